// The stepper in a file of its own: a link leads to its step, and a key counts wherever the focus is.
function alone(feed, place) {
  const stepper = window.stepper = new Stepper(feed, lives, null), linked = () => (/^#(\d+)$/.exec(location.hash) ?? [])[1];
  stepper.mount(place, true);
  onhashchange = () => { if (linked()) { stepper.stop(); stepper.go(+linked()); } };
  onhashchange();
  document.onkeydown = (event) => { if (!event.target.closest(".rl-stepper")) stepper.key(event); };
}
