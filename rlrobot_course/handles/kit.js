// What all handles share. A handle's program is an object:
//   controls(feed)                      what the reader moves, see CONTROLS; each has a name, a kind and a label; one that
//                                       counts only at some values of the others has a function of them, `when`
//   begins(feed)                        further values by name, such as a path that is clicked; may be missing
//   compute(feed, values)               all numbers that are shown; tests call it
//   draw(found, width, feed, values)    { finding, height, picture, said }: a sentence that is the title, the height and
//                                       the marks of the picture for this width [px], and a sentence about what is seen
//   picked(feed, values, name)          the values that change where the reader presses a button of this name, or a part
//                                       of the picture with data-pick="name"; may be missing
// A part of the picture with data-grip="name", data-from and data-to [px] is dragged along x, or moved by the keys ← and →,
// to set the slider of this name.

const SECONDS = 0.7; // that a scrubber stays at a step
const isStill = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
const shownAs = (control, value) => (control.text ?? given)(value);

const CONTROLS = {
  // a number from min to max
  slider: (control) => `<label class="rl-slide"><span>${escaped(control.label)}</span>` +
    `<input type="range" name="${control.name}" min="${control.min}" max="${control.max}" step="${control.step}"><output></output></label>`,
  // a step, 0 to last: buttons beside the slider go one on or back, and play
  scrubber: (control) => `<div class="rl-scrub"><button data-step="${control.name}" data-by="-1" aria-label="One step back">◀</button>` +
    `<button class="main" data-play="${control.name}">Play</button>` +
    `<button data-step="${control.name}" data-by="1" aria-label="One step on">▶</button>${CONTROLS.slider({ min: 0, step: 1, ...control, max: control.last })}</div>`,
  // true or false
  toggle: (control) => `<button name="${control.name}" data-toggle aria-pressed="${control.value}">${escaped(control.label)}</button>`,
  // one of several, by its number
  choice: (control) => `<label>${escaped(control.label)} <select name="${control.name}">` +
    `${control.options.map((text, i) => `<option value="${i}">${escaped(text)}</option>`).join("")}</select></label>`,
  button: (control) => `<button data-pick="${control.name}">${escaped(control.label)}</button>`,
};

class View {
  constructor(handle, feed, place) {
    this.handle = handle;
    this.feed = feed;
    this.controls = handle.controls(feed);
    this.values = { ...handle.begins?.(feed) };
    for (const { name, value } of this.controls) if (value !== undefined) this.values[name] = value;
    const moved = this.controls.map((control) => CONTROLS[control.kind](control)).join("");
    place.innerHTML = '<div class="rl-handle rl-look"><h3 class="rl-finding" role="status"></h3>' +
      `<div class="rl-seen"><svg role="group"></svg></div><div class="rl-moved">${moved}</div><p class="rl-said"></p></div>`;
    this.root = place.firstChild;
    this.svg = this.root.querySelector("svg");
    this.root.oninput = ({ target }) => this.take(target);
    this.root.onclick = ({ target }) => this.press(target);
    this.root.onkeydown = (event) => this.key(event);
    this.root.onpointerdown = (event) => this.drag(event);
    this.width = 0;
    this.observer = new ResizeObserver(([{ contentRect }]) => {
      if (contentRect.width && Math.round(contentRect.width) !== this.width) this.show();
    });
    this.observer.observe(this.svg.parentNode);
    this.show();
  }

  // What has been moved counts from now on.
  set(values) {
    Object.assign(this.values, values);
    this.show();
  }

  take(target) {
    this.stop();
    this.set({ [target.name]: +target.value });
  }

  press(target) {
    const button = target.closest("button, [data-pick]");
    if (!button) return;
    const { step, by, play, pick } = button.dataset;
    if (play) return this.timer ? this.stop() : this.play(play);
    this.stop();
    if (step) this.move(step, +by);
    else if (pick) this.set(this.handle.picked(this.feed, this.values, pick));
    else if ("toggle" in button.dataset) this.set({ [button.name]: !this.values[button.name] });
  }

  named(name) {
    return this.controls.find((control) => control.name === name);
  }

  // A slider goes so many of its steps further, as far as it can.
  move(name, by) {
    const { min = 0, step = 1, max, last } = this.named(name), value = this.values[name] + by * step;
    this.set({ [name]: Math.min(Math.max(+value.toFixed(6), min), max ?? last) });
  }

  play(name) {
    const { last } = this.named(name);
    if (this.values[name] >= last) this.set({ [name]: 0 });
    this.timer = setInterval(() => {
      if (this.values[name] >= this.named(name).last || !this.root.isConnected) this.stop();
      else this.move(name, 1);
    }, 1000 * SECONDS);
    this.show();
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
  }

  // Keys: on a part of the picture ← and → move its slider, Enter and the blank press it.
  key(event) {
    const { grip, pick } = event.target.dataset, by = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (event.target.closest("svg") && grip && by) this.move(grip, by);
    else if (event.target.closest("svg") && pick && [" ", "Enter"].includes(event.key)) this.press(event.target);
    else if (!event.target.matches("input, select") || !event.key.startsWith("Arrow")) return;
    else return event.stopPropagation(); // the slider moves, and JupyterLab's cells stay
    event.preventDefault();
    event.stopPropagation();
  }

  drag(event) {
    const part = event.target.closest("[data-grip]");
    if (!part || event.button) return;
    const { grip, from, to } = part.dataset, { min, max, step } = this.named(grip);
    const { left } = this.svg.getBoundingClientRect();
    const follow = ({ clientX }) => {
      const value = min + ((clientX - left - from) / (to - from)) * (max - min);
      this.set({ [grip]: Math.min(Math.max(+(Math.round(value / step) * step).toFixed(6), min), max) });
    };
    this.svg.setPointerCapture(event.pointerId);
    this.svg.onpointermove = follow;
    this.svg.onlostpointercapture = () => { this.svg.onpointermove = null; };
    event.preventDefault();
    part.focus();
    follow(event);
  }

  show() {
    const { handle, feed, values, root, svg } = this;
    this.width = Math.round(svg.parentNode.clientWidth) || 640;
    for (const control of this.controls) this.showControl(control, handle.limits?.(feed, values)?.[control.name]);
    const found = handle.compute(feed, values);
    const { finding, height, picture, said } = handle.draw(found, this.width, feed, values);
    const had = document.activeElement?.closest?.(".rl-handle") === root ? document.activeElement.dataset : {};
    svg.setAttribute("viewBox", `0 0 ${this.width} ${height}`);
    svg.setAttribute("aria-label", said);
    svg.style.height = `${height}px`;
    svg.innerHTML = picture;
    for (const part of svg.querySelectorAll("[data-pick], [data-grip]")) part.setAttribute("tabindex", 0);
    for (const name of ["pick", "grip"]) if (had[name]) svg.querySelector(`[data-${name}="${had[name]}"]`)?.focus();
    root.querySelector(".rl-finding").textContent = finding;
    root.querySelector(".rl-said").textContent = said;
  }

  // A control as it stands now; last: of a scrubber whose number of steps changes
  showControl(control, last) {
    const { root, values } = this, { name, kind } = control, value = values[name];
    if (last !== undefined) Object.assign(control, { last });
    const input = root.querySelector(`[name="${name}"]`);
    if (control.when) input.closest("label").hidden = !control.when(values);
    if (kind === "toggle") input.setAttribute("aria-pressed", value);
    if (kind === "choice") input.value = value;
    if (kind === "scrubber") {
      input.max = control.last;
      const play = root.querySelector(`[data-play="${name}"]`);
      play.textContent = this.timer ? "Pause" : "Play";
      play.hidden = isStill(); // the buttons beside it go step by step
    }
    if (kind === "slider" || kind === "scrubber") {
      const text = shownAs(control, value);
      input.value = value;
      input.setAttribute("aria-valuetext", text);
      input.nextElementSibling.textContent = text;
    }
  }
}

// A handle at a place on the page; returns what takes it away.
function mount(handle, feed, place) {
  const view = new View(handle, feed, place);
  return () => {
    view.stop();
    view.observer.disconnect();
  };
}
