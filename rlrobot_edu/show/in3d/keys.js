// A replay's buttons and keys, its links (#31 is step 31), and what is said aloud where it stands still.
const number = () => Math.min(Math.floor(at), frames.length - 1) + 1;
function go(step) {
  playing = false;
  at = Math.min(Math.max(step - 1, 0), frames.length - 1);
  moved = true;
  settle();
}
const moves = {
  first: () => go(1), back: () => go(number() - 1), step: () => go(number() + 1), last: () => go(frames.length),
  play: () => { playing = !playing; settle(); },
};
const keys = {ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last"};
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
  for (const button of document.querySelectorAll("#replay button")) button.onclick = moves[button.name];
  document.onkeydown = event => {
    const name = keys[event.key], isButtons = event.key === " " && event.target.closest("button");
    if (!name || event.ctrlKey || event.altKey || event.metaKey || isButtons) return;
    event.preventDefault();
    moves[name]();
  };
  time.addEventListener("input", settle);
  addEventListener("hashchange", followLink);
  followLink();
}
