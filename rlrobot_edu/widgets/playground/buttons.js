// The beginning: what the buttons do, and the first frame.

document.onkeydown = (event) => {
  if (event.key !== " " || /^(BUTTON|SELECT|INPUT|SUMMARY)$/.test(event.target.tagName)) return;
  event.preventDefault();
  play(!playing);
};
find("play").onclick = () => play(!playing);
find("again").onclick = () => change();
find("race").onclick = () => {
  isRacing = !isRacing;
  change();
};
for (const stage of find("stages").children) stage.onclick = () => goTo(Number(stage.value));
find("kind").append(new Option("bumps", "counts"), new Option("reward", "rewards"));
find("kind").onchange = changed;
addEventListener("resize", changed);
followTheme(() => {
  colours = coloursNow();
  changed();
});
find("head").open = innerWidth >= 680 && !isFramed;
readLink();
begin();
showSettings();
if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
  while (yours.simulation.t < 3600) live(3600 - yours.simulation.t, MOST_MS); // an hour of its life, at once
  play(false);
}
keepLink();
requestAnimationFrame(frame);
