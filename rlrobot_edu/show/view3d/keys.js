// A replay's keys, its links (#31 is step 31), and what is said aloud where it stands still.
const number = () => Math.min(Math.floor(at), frames.length - 1) + 1;
function go(step) {
  playing = false;
  at = Math.min(Math.max(step - 1, 0), frames.length - 1);
  moved = true;
  settle();
}
const keys = {
  ArrowLeft: () => go(number() - 1), ArrowRight: () => go(number() + 1),
  Home: () => go(1), End: () => go(frames.length), " ": () => play.click(),
};
function followLink() {
  if (/^#\d+$/.test(location.hash)) go(+location.hash.slice(1));
}
let rest;
function settle() {
  clearTimeout(rest);
  rest = setTimeout(() => {
    if (playing) return;
    live.textContent = caption.textContent;
    if (self === top) history.replaceState(null, "", "#" + number());  // a frame in a notebook has no address
  }, 500);
}
if (!feed.live && feed.frames.length > 1) {
  document.onkeydown = event => {
    const isButtons = event.key === " " && event.target.closest("button");
    if (!keys[event.key] || event.ctrlKey || event.altKey || event.metaKey || isButtons) return;
    event.preventDefault();
    keys[event.key]();
  };
  play.addEventListener("click", settle);
  time.addEventListener("input", settle);
  addEventListener("hashchange", followLink);
  followLink();
}
