// The beginning: what the buttons do, and the first frame.

document.onkeydown = (event) => {
  if (event.key !== " " || /^(BUTTON|SELECT|INPUT|SUMMARY)$/.test(event.target.tagName)) return;
  event.preventDefault();
  play(!playing);
};
find("play").onclick = () => play(!playing);
find("again").onclick = () => goTo(0);
find("race").onchange = () => {
  racing = find("race").value;
  before = null;
  liveAnew();
};
for (const stage of find("stages").children) stage.onclick = () => goTo(Number(stage.value));
find("kind").append(new Option("bumps", "counts"), new Option("reward", "rewards"));
find("kind").onchange = changed;
addEventListener("resize", changed);
followTheme(() => {
  colours = coloursOf(picture);
  changed();
});
find("head").open = innerWidth >= 680 && !isFramed;
readLink();
liveAnew();
showSettings();
if (matchMedia("(prefers-reduced-motion: reduce)").matches) play(false);
keepLink();
requestAnimationFrame(frame);
