// The stepper on a page: what the reader presses and moves, the steps one after the other, and lives of other settings.

const SPEEDS = [0.5, 1, 2, 5, 10, 20, 30]; // steps a second
const SLICE = 100; // steps that are asked for at once: after each slice the reader is heard
const SILENCE = 4000; // ms without an answer of the kernel, then the page says so
const KEYS = { ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last" };
const BUTTONS = { // name: its text, and what it says to the mouse
  first: ["|◀ First", "Go to the earliest step that is kept (Home)"],
  back: ["◀ Back", "Show the step before (left arrow)"],
  step: ["Step ▶", "Show the next step (right arrow)"],
  play: ["▶▶ Play", "Go on by itself, or stop (space)"],
  last: ["Last ▶|", "Go to the last step that the agent has taken (End)"],
};
const SETTINGS = { // that can be others: symbol, values to choose from
  alpha: ["α", [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1]],
  gamma: ["γ", [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99]],
  lam: ["λ", [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1]],
  temperature: ["T", [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50]],
  epsilon: ["ε", [0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1]],
};

class Stepper {
  // feed: what told.py tells; lives: how it can be lived again here, or null; ask: sends the kernel a question, or null
  constructor(feed, lives, ask) {
    const { about } = feed;
    Object.assign(this, { about, lives, ask, goal: null, player: null });
    this.recorded = this.newTape(feed.start);
    this.recorded.add(feed.frames);
    this.recorded.go(Math.max(feed.at, this.recorded.first));
    this.tape = this.recorded;
  }

  newTape(start) {
    return new Tape(this.about.nStates, this.about.nActions, start, this.about.keep);
  }

  // Draw the stepper into an element of a page; link: whether the page's address leads to the step shown.
  mount(root, link = false) {
    const buttons = Object.entries(BUTTONS).map(([name, [text, title]]) =>
      `<button class="rl-${name}" name="${name}" title="${title}">${text}</button>`).join("");
    const speeds = SPEEDS.map((each) => `<option value="${each}"${each === 2 ? " selected" : ""}>${each} steps/s</option>`);
    root.innerHTML = `<div class="rl-stepper" data-lm-suppress-shortcuts="true"><div class="rl-bar" role="group" ` +
      `aria-label="Controls">${buttons}<select class="rl-speed" aria-label="speed">${speeds.join("")}</select>` +
      '<label>go to step <input class="rl-go" type="number" min="0" title="Number of a step, then Enter"></label>' +
      '<input class="rl-slider" type="range" aria-label="step" title="The steps that are kept"></div>' +
      '<p class="rl-error rl-said" role="status"></p><div class="rl-keys" tabindex="0" role="group" ' +
      'aria-label="Keyboard of the stepper: left and right arrow step, space plays and pauses, Home and End go to the ends">' +
      "Keyboard (click the view, or come here with Tab): <kbd>←</kbd> <kbd>→</kbd> step &nbsp; <kbd>Space</kbd> play or " +
      "pause &nbsp; <kbd>Home</kbd> <kbd>End</kbd> first and last step</div>" +
      '<p class="rl-live" aria-live="polite"></p><div class="rl-view"></div><div class="rl-what-if"></div>' +
      `<div class="rl-view">${this.about.code}</div></div>`;
    this.root = root.firstChild;
    this.link = link;
    this.find = (name) => this.root.querySelector(`.rl-${name}`);
    this.wishes();
    this.root.querySelector(".rl-bar").onclick = ({ target }) => target.name && this.press(target.name);
    this.find("go").onchange = ({ target }) => { this.stop(); this.go(+target.value); };
    this.find("slider").oninput = ({ target }) => { this.stop(); this.go(+target.value); };
    this.find("speed").onchange = () => { if (this.player) { this.stop(); this.play(); } };
    this.find("view").onclick = ({ target }) => {
      if (!target.closest("summary")) this.find("keys").focus({ preventScroll: true });
    };
    this.root.onkeydown = (event) => this.key(event);
    this.show();
  }

  // A key counts wherever the focus is, also on a button just clicked, but for what has keys of its own.
  key(event) {
    const name = KEYS[event.key], its = event.key === " " ? "button, summary, select" : "input, select";
    if (!name || event.ctrlKey || event.altKey || event.metaKey || event.target.closest(its)) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat || !this.waits) this.press(name); // held: the next one when the kernel has answered
  }

  press(name) {
    const played = this.stop(), { tape } = this;
    if (name === "play") return played || this.play();
    return this.go({ first: tape.first, back: tape.t - 1, step: tape.t + 1, last: tape.end }[name]);
  }

  play() {
    this.find("play").textContent = "‖ Pause";
    const next = () => {
      if (!this.waits && !this.go(this.tape.t + 1)) this.stop();
    };
    this.player = setInterval(next, 1000 / this.find("speed").value);
    next();
  }

  // Stop at once. Returns whether it went on by itself.
  stop() {
    const went = this.player !== null || this.goal !== null;
    if (this.goal !== null) this.say(`Stopped at step ${this.tape.t}, on the way to step ${this.goal}.`);
    clearInterval(this.player);
    this.player = this.goal = null;
    this.find("play").textContent = BUTTONS.play[0];
    return went;
  }

  // Go to step t; steps that are not taken yet are lived here, or asked for. Returns whether there is one to come.
  go(t) {
    const { tape } = this, { first, end } = tape;
    if (t > end && tape !== this.recorded) {
      tape.add(count(Math.min(t - end, 20000)).map(() => this.relived.step()));
    } else if (t > end && this.ask) {
      this.goal = t;
      this.request({ take: Math.min(t - end, SLICE) });
      if (t > end + SLICE) this.say(`At step ${end}, on the way to step ${t}. Pause stops it.`);
      if (t > end + SLICE) this.find("play").textContent = "‖ Pause";
      return true;
    }
    this.say(t < first && first > 0 ? `There is no step ${t} to show: the earliest that is kept is ${first} (keep= sets how many).` : "");
    tape.go(Math.min(Math.max(t, tape.first), tape.end));
    this.show();
    if (this.ask && tape === this.recorded) this.tellWhere();
    return t <= tape.end;
  }

  request(question) {
    this.waits = true;
    clearTimeout(this.silence);
    this.silence = setTimeout(() => {
      this.say("The kernel does not answer. It is busy with another cell, or it was restarted: then run this cell again. " +
        "The steps that are here can still be looked at.", "alert");
      this.waits = false;
      this.goal = null;
    }, SILENCE);
    this.ask(question);
  }

  // What the kernel says: new frames, where to be, an error.
  hear({ frames = [], at = null, parameters, error = "" }) {
    clearTimeout(this.silence);
    this.waits = false;
    if (parameters) {
      this.about.recordedParameters = parameters;
      if (this.tape === this.recorded) this.about.parameters = parameters;
    }
    const news = frames.filter(({ t }) => t >= this.recorded.end);
    if (news.length) this.recorded.add(news);
    if (error) {
      this.stop();
      this.say(error, "alert");
    } else if (at !== null) {
      this.relive({});
      this.stop();
      this.go(at);
    } else if (this.goal !== null && this.tape === this.recorded) {
      const { goal } = this, { end } = this.recorded;
      this.recorded.go(Math.min(goal, end));
      if (goal <= end) {
        this.goal = null;
        this.say("");
        if (!this.player) this.find("play").textContent = BUTTONS.play[0];
      }
      this.show();
      if (goal > end && news.length) this.go(goal);
    }
  }

  // The kernel's own position follows, once this one rests.
  tellWhere() {
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.ask({ at: this.recorded.t }), 200);
  }

  say(text, role = "status") {
    const said = this.find("said");
    said.setAttribute("role", role);
    if (said.textContent !== text) said.textContent = text;
  }

  show() {
    const { tape, about } = this, slider = this.find("slider");
    this.find("view").innerHTML = viewHtml(about, tape);
    Object.assign(slider, { min: tape.first, max: tape.end, value: tape.t });
    this.find("go").value = tape.t;
    clearTimeout(this.speech);
    this.speech = setTimeout(() => { // where it stands still: nobody can listen faster
      this.find("live").textContent = this.find("view").querySelector(".said span").textContent;
      if (this.link) history.replaceState(null, "", `#${tape.t}`);
    }, 500);
  }

  // The settings that can be others; or why nothing can.
  wishes() {
    const place = this.find("what-if"), { lives } = this;
    if (!lives || !lives.kernels) {
      place.innerHTML = lives ? `<p class="rl-note">${escaped(lives.reason)}</p>` : "";
      return;
    }
    const own = lives.memory.parameters;
    const select = (name) => {
      const [symbol, values] = SETTINGS[name], all = [...new Set([...values, own[name]])].sort((a, b) => a - b);
      const option = (x) => `<option value="${x}"${x === own[name] ? " selected" : ""}>${+x.toPrecision(6)}</option>`;
      return `<label>${symbol} <select name="${name}">${all.map(option).join("")}</select></label>`;
    };
    place.innerHTML = `<b>What if?</b> ${lives.settings.map(select).join(" ")} <button>As it was</button> ` +
      '<span class="rl-parted" role="status"></span>';
    place.onchange = () => {
      const chosen = [...place.querySelectorAll("select")].map(({ name, value }) => [name, +value]);
      this.relive(Object.fromEntries(chosen.filter(([name, value]) => value !== own[name])));
    };
    place.querySelector("button").onclick = () => {
      for (const each of place.querySelectorAll("select")) each.value = own[each.name];
      this.relive({});
    };
  }

  // Live the same time again with these settings, and show it at the same step; without any, show what happened.
  relive(settings) {
    const { t } = this.tape, { end } = this.recorded, told = this.find("parted");
    if (!Object.keys(settings).length) {
      this.tape = this.recorded;
      if (told) told.textContent = "";
    } else {
      this.stop();
      this.relived = new Relived(this.about, this.lives, settings);
      this.tape = this.newTape(this.lives.start);
      for (let done = 0; done < end; done += 1000) this.tape.add(count(Math.min(1000, end - done)).map(() => this.relived.step()));
      told.textContent = this.parted(settings);
    }
    this.about.parameters = { ...this.about.recordedParameters, ...settings };
    this.tape.go(Math.min(Math.max(t, this.tape.first), this.tape.end));
    this.show();
  }

  // From where on it is another life, and what either paid.
  parted(settings) {
    const said = Object.entries(settings).map(([name, value]) => `${SETTINGS[name][0]} = ${value}`).join(", ");
    const from = Math.max(this.tape.dropped, this.recorded.dropped) + 1, { end } = this.recorded;
    const steps = count(end - from + 1).map((i) => [this.tape.at(from + i), this.recorded.at(from + i)]);
    const other = steps.find(([one, two]) => one.s !== two.s || one.a !== two.a || one.s2 !== two.s2);
    const mean = (i) => number(steps.reduce((sum, pair) => sum + pair[i].r, 0) / steps.length);
    return `With ${said} and the same luck it ${other ? `goes another way from step ${other[0].t + 1} on` : "goes the same way"}: ` +
      `mean reward ${mean(0)} a step, ${mean(1)} as it was.`;
  }
}
