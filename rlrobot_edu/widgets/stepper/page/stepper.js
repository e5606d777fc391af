// The stepper on a page: what the reader presses and moves, the steps one after the other, and replays with other settings.

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
const LEAST = 1e-5; // a probability; page_data.py rounds to less
const SETTINGS = { // that can be others: symbol, values to choose from
  alpha: ["α", [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1]],
  gamma: ["γ", [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99]],
  lam: ["λ", [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1]],
  temperature: ["T", [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50]],
  epsilon: ["ε", [0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1]],
};

class Stepper {
  // feed: what page_data.py tells; replayData: how it can be replayed here, or null; ask: sends the kernel a question, or null
  constructor(feed, replayData, ask) {
    const { about } = feed;
    Object.assign(this, { about, replayData, ask, goal: null, player: null, asked: null, from: null });
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
      `<button class="rl-${name}${name === "play" ? " main" : ""}" name="${name}" title="${title}">${text}</button>`).join("");
    const speeds = SPEEDS.map((each) => `<option value="${each}"${each === 2 ? " selected" : ""}>${each} steps/s</option>`);
    root.innerHTML = `<div class="rl-stepper rl-look" data-lm-suppress-shortcuts="true"><div class="rl-bar" role="group" ` +
      `aria-label="Controls">${buttons}<select class="rl-speed" aria-label="speed">${speeds.join("")}</select>` +
      '<label>go to step <input class="rl-go" type="number" min="0" title="Number of a step, then Enter"></label>' +
      '<input class="rl-slider" type="range" aria-label="step" title="The steps that are kept"></div>' +
      '<p class="rl-error rl-said" role="status"></p><div class="rl-keys" tabindex="0" role="group" ' +
      'aria-label="Keyboard of the stepper: left and right arrow step, space plays and pauses, Home and End go to the ends">' +
      `Keyboard${link ? "" : " (click the view, or come here with Tab)"}: <kbd>←</kbd> <kbd>→</kbd> step &nbsp; <kbd>Space</kbd> play or ` +
      "pause &nbsp; <kbd>Home</kbd> <kbd>End</kbd> first and last step</div>" +
      '<p class="rl-live" aria-live="polite"></p><div class="rl-view"></div><details><summary><b>Why?</b> ' +
      "Click a value, or ask here who paid for it</summary>" +
      '<div class="rl-why rl-ask" role="group" aria-label="Who paid for a value?"></div><div class="rl-view rl-paid"></div></details>' +
      "<details><summary><b>What if?</b> Learn again with other settings, another action or another reward</summary>" +
      '<div class="rl-what-if rl-ask" role="group" aria-label="What if?"></div><div class="rl-view rl-futures"></div></details>' +
      `<div class="rl-view">${this.about.code}</div></div>`;
    this.root = root.firstChild;
    this.link = link;
    this.find = (name) => this.root.querySelector(`.rl-${name}`);
    this.questions();
    this.wishes();
    this.root.querySelector(".rl-bar").onclick = ({ target }) => target.name && this.press(target.name);
    this.find("go").onchange = ({ target }) => { this.stop(); this.go(+target.value); };
    this.find("slider").oninput = ({ target }) => { this.stop(); this.go(+target.value); };
    this.find("speed").onchange = () => { if (this.player) { this.stop(); this.play(); } };
    this.find("view").onclick = ({ target }) => {
      const bias = target.closest("[data-bias]")?.dataset.bias;
      if (bias && choice) this.why({ bias: +bias });
      this.whyOf(target);
      if (!target.closest("summary")) this.find("keys").focus({ preventScroll: true });
    };
    this.find("view").addEventListener("toggle", ({ target }) => {
      this.about.open = { ...this.about.open, [target.dataset.kept]: target.open };
    }, true); // the next step keeps it
    this.root.onkeydown = (event) => this.key(event);
    this.show();
    const repaint = () => paintRooms(this.root, this.about.rooms);
    new ResizeObserver(repaint).observe(this.root);
    followColours(repaint);
  }

  // A key counts wherever the focus is, also on a button just clicked, but for what has keys of its own.
  key(event) {
    if (event.key === "Enter" && event.target.matches("input")) { // JupyterLab would keep it for itself
      event.preventDefault();
      event.stopPropagation();
      event.target.blur(); // what was typed counts now, and once
      event.target.focus();
      return;
    }
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
    if (this.isOver) this.go(this.tape.first); // at the end it begins again
    this.find("play").textContent = "‖ Pause";
    const next = () => {
      if (!this.waits && !this.go(this.tape.t + 1)) this.stop();
    };
    this.player = setInterval(next, 1000 / this.find("speed").value);
    next();
  }

  // Whether the last step is shown, and nobody lives on.
  get isOver() {
    return !this.ask && this.tape === this.recorded && this.tape.t >= this.tape.end;
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
      tape.add(count(Math.min(t - end, 20000)).map(() => this.replay.step()));
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
    if (parameters) this.about.parameters = parameters;
    const news = frames.filter(({ t }) => t >= this.recorded.end);
    if (news.length) this.recorded.add(news);
    if (error) {
      this.stop();
      this.say(error, "alert");
    } else if (at !== null) {
      this.replayWith({});
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
    const { tape, about, recorded } = this, slider = this.find("slider");
    about.rooms = []; // what the canvases show
    this.find("paid").innerHTML = this.paid(); // what it lights on the map is drawn after it
    if (this.from !== null) recorded.go(Math.min(Math.max(tape.t, recorded.first), recorded.end));
    this.find("futures").innerHTML = this.from === null || tape.t > recorded.end ? "" : comparisonHtml(about, recorded, tape, this.from);
    this.find("view").innerHTML = viewHtml(about, tape);
    paintRooms(this.root, about.rooms);
    Object.assign(slider, { min: tape.first, max: tape.end, value: tape.t });
    this.find("go").value = tape.t;
    clearTimeout(this.speech);
    this.speech = setTimeout(() => { // where it stands still: nobody can listen faster
      this.find("live").textContent = this.find("view").querySelector(".said span").textContent;
      if (this.link) history.replaceState(null, "", `#${tape.t}`);
    }, 500);
  }

  // What the reader can ask of a value: the state, the action, and another one that it is compared with.
  questions() {
    const place = this.find("why"), { names, nStates, nActions } = this.about;
    if (updates.reason) {
      place.innerHTML = `<p class="rl-note">${escaped(updates.reason)}</p>`;
      return;
    }
    const option = (a) => `<option value="${a}">${escaped(named(names, a))}</option>`, actions = count(nActions).map(option).join("");
    place.innerHTML = '<span>Who paid for Q(</span>' +
      `<input name="s" type="number" min="0" max="${nStates - 1}" aria-label="state">, <select name="a" aria-label="action">${actions}</select> ) ` +
      `<label>rather than <select name="rather"><option value="">no other action</option>${actions}</select></label> ` +
      '<button name="tell">Tell</button> <button name="mine">What did the step shown pay?</button> ' +
      `${choice ? '<button name="advice">Whose advice was the bias?</button> ' : ""}<button name="enough">Enough</button>`;
    const control = (name) => place.querySelector(`[name=${name}]`);
    place.onchange = place.querySelector("[name=tell]").onclick = () => {
      const { value } = control("rather"), s = Math.min(Math.max(Math.trunc(+control("s").value), 0), nStates - 1);
      this.why({ s, a: +control("a").value, rather: value === "" ? null : +value });
    };
    control("mine").onclick = () => {
      const { frame } = this.tape;
      if (frame) this.why({ s: frame.s, a: frame.a, step: frame.t + 1 });
    };
    if (choice) control("advice").onclick = () => this.why({ bias: null });
    control("enough").onclick = () => this.why(null);
    this.find("paid").onclick = ({ target }) => {
      this.whyOf(target);
      if (target.dataset.go) return this.go(+target.dataset.go);
      const step = target.closest("[data-step]")?.dataset.step ?? target.closest("button")?.name;
      if (step) this.why({ ...this.asked, step: +step });
    };
  }

  // A value was clicked, or something else.
  whyOf(target) {
    const at = target.closest("[data-at]")?.dataset.at, { nActions } = this.about;
    if (at && !updates.reason) this.why({ s: Math.floor(at / nActions), a: at % nActions });
  }

  // Who paid for a value: tell it below the tables, at every step, until another one is asked for.
  why(asked) {
    this.asked = asked;
    this.find("why").parentNode.open = Boolean(asked);
    if (asked && "s" in asked) for (const name of ["s", "a", "rather"]) this.find("why").querySelector(`[name=${name}]`).value = asked[name] ?? "";
    this.show();
  }

  paid() {
    const { tape, about } = this;
    tape.lit = [];
    if (!this.asked) return "";
    try {
      return "bias" in this.asked ? adviceHtml(about, tape, this.asked.bias) : paidHtml(about, tape, this.asked);
    } catch (error) {
      return `<p role="status">${escaped(error.message)}</p>`;
    }
  }

  // The settings that can be others, if the page has the world.
  wishes() {
    const place = this.find("what-if"), { replayData, about } = this, { names } = about;
    if (!replayData || !replayData.kernels) {
      place.parentNode.hidden = true;
      return;
    }
    const own = replayData.memory.parameters, as = '<option value="">as it was</option>';
    const select = (name) => {
      const [symbol, values] = SETTINGS[name], all = [...new Set([...values, own[name]])].sort((a, b) => a - b);
      const option = (x) => `<option value="${x}"${x === own[name] ? " selected" : ""}>${+x.toPrecision(6)}</option>`;
      return `<label>${symbol} <select name="${name}">${all.map(option).join("")}</select></label>`;
    };
    const methods = about.methods.map(({ algorithm }, i) => `<option value="${i || ""}">${escaped(algorithm)}</option>`);
    const actions = count(about.nActions).map((a) => `<option value="${a}">${escaped(named(names, a))}</option>`);
    place.innerHTML = '<label>From step <input name="from" type="number" min="1" value="1"></label> ' +
      `<button name="here">from the step shown</button> ${replayData.settings.map(select).join(" ")} ` +
      `<label>learn by <select name="method">${methods.join("")}</select></label> <label>in that step a = ` +
      `<select name="action">${as}${actions.join("")}</select></label> <label>r = <input name="reward" type="number" step="any" ` +
      'placeholder="as it was"></label> <button name="undo">As it was</button> <span class="rl-parted" role="status"></span>';
    const controls = Object.fromEntries([...place.querySelectorAll("[name]")].map((each) => [each.name, each]));
    const wish = () => {
      const chosen = replayData.settings.map((name) => [name, +controls[name].value]), said = (name) => controls[name].value;
      const from = Math.min(Math.max(Math.trunc(+said("from")) || 1, 1), this.recorded.end), number = (text) => (text === "" ? null : +text);
      this.replayWith(Object.fromEntries(chosen.filter(([name, value]) => value !== own[name])),
        { from, method: number(said("method")), action: number(said("action")), reward: number(said("reward")) });
    };
    place.onchange = wish;
    controls.here.onclick = () => { controls.from.value = Math.max(this.tape.t, 1); wish(); };
    controls.undo.onclick = () => {
      for (const name of replayData.settings) controls[name].value = own[name];
      for (const name of ["method", "action", "reward"]) controls[name].value = "";
      controls.from.value = 1;
      this.replayWith({});
    };
  }

  // Live the same time again, from a step on with these settings, by another method, with another action or reward in it;
  // show it at the same step. Without any, show what happened.
  replayWith(settings, { from = 1, method = null, action = null, reward = null } = {}) {
    const { t } = this.tape, { end, dropped } = this.recorded, told = this.find("parted"), at = from > dropped ? this.recorded.at(from) : null;
    const taken = action !== null && at && action !== at.a, wished = taken || [method, reward].some((each) => each !== null);
    this.from = null;
    this.tape = this.recorded;
    if (told) told.textContent = "";
    if (taken && at.p[action] < LEAST) {
      told.textContent = `In state ${at.s} the agent takes this action with a probability below ${LEAST}: no luck brings it there.`;
    } else if (wished || Object.keys(settings).length) {
      this.stop();
      this.from = from;
      const fork = { from, method, reward, luck: taken ? luckFor(at.p, action) : null, begins: at?.n === 1 };
      this.replay = new Replay(this.about, this.replayData, settings, fork);
      this.tape = this.newTape(this.replayData.start);
      for (let done = 0; done < end; done += 1000) this.tape.add(count(Math.min(1000, end - done)).map(() => this.replay.step()));
      told.textContent = this.parted(settings, { from, method, action: taken ? action : null, reward });
    }
    this.tape.go(Math.min(Math.max(t, this.tape.first), this.tape.end));
    this.show();
  }

  // From which step on the replay differs, and what either paid.
  parted(settings, { from, method, action, reward }) {
    const { names, methods } = this.about, said = Object.entries(settings).map(([name, value]) => `${SETTINGS[name][0]} = ${value}`);
    if (method !== null) said.push(methods[method].algorithm);
    if (said.length && from > 1) said.push(`${said.pop()} from step ${from} on`);
    if (action !== null) said.push(`a = ${named(names, action)} in step ${from}`);
    if (reward !== null) said.push(`r = ${given(reward)} in step ${from}`);
    const parts = partsAt(this.recorded, this.tape), first = Math.max(this.tape.dropped, this.recorded.dropped), { end } = this.recorded;
    const mean = (tape) => number(count(end - first).reduce((sum, i) => sum + tape.at(first + i + 1).r, 0) / (end - first));
    return `With ${said.join(", ")} and the same luck it ` +
      `${parts === null ? "goes the same way" : `goes another way from step ${parts} on`}: ` +
      `mean reward ${mean(this.tape)} a step, ${mean(this.recorded)} as it was.`;
  }
}
