// The stepper in a file of its own: a link leads to its step, and a key counts wherever the focus is.
function standalone({ frames, ...feed }, place) {
  const names = Object.keys(frames), row = (i) => Object.fromEntries(names.map((name) => [name, frames[name][i]]));
  const rows = (frames.t ?? []).map((_, i) => row(i));
  const stepper = window.stepper = new Stepper({ ...feed, frames: rows }, replayData, null), linked = () => (/^#(\d+)$/.exec(location.hash) ?? [])[1];
  stepper.mount(place, true);
  onhashchange = () => { if (linked()) { stepper.stop(); stepper.go(+linked()); } };
  onhashchange();
  document.onkeydown = (event) => { if (!event.target.closest(".rl-stepper")) stepper.key(event); };
}
