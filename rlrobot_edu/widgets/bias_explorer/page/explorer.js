// The bias explorer on a page: what the reader presses and edits. What it shows stands in a model: that of a widget,
// or of a file alone; `state`, `table` (the number of one), `tables` (the values of all) and `stage` change.

const ROW = 26; // height of a state's row [px]
const NEXT = ["Next: its similar states", "Next: the mean of each set", "Next: the bias", "Next: all actions, and the choice",
  "Build it up, column by column"];

// All that stays while the numbers change: a block of columns for each action, the states, the inputs.
function explorerHtml(about) {
  const { inputs, actions, originals } = about, option = (text, i) => `<option value="${i}">${escaped(text)}</option>`;
  const choices = inputs.map(({ name, sign, words }, i) =>
    `<label>${sign} ${escaped(name)} <select data-input="${i}">${words.map(option).join("")}</select></label>`);
  return '<div class="rl-bias rl-look"><div class="rl-steps"><button name="back" title="Back (key ←)">Back</button> ' +
    '<button name="next" class="main" title="Next (key →)"></button> <button name="all">All columns</button> ' +
    `<label>action <select name="action">${actions.map(option).join("")}</select></label></div>` +
    '<p class="rl-finding" data-from="4"></p><p class="said" role="status"></p><div class="rl-top"><div class="rl-picture" role="region" aria-label="Four columns">' +
    '<div class="rl-columns rl-heads"><b>Q of <i>s</i> and its similar states</b><b data-from="2">mean of each set</b>' +
    '<b data-from="3">bias: mean of means</b><b data-from="4">probability, 0 to 100&nbsp;%</b></div>' +
    `${actions.map((name, a) => actionHtml(about, name, a)).join("")}<p class="rl-legend" data-from="1"></p></div><div class="rl-chooser">` +
    `<h2>The state: click one, or choose its inputs${isRoom(about) ? ". A bar: something is right ahead (d = 1)" : ""}</h2>` +
    `<div class="rl-states${isRoom(about) ? " rl-room" : ""}" role="group" aria-label="The states: click one">${statesHtml(about)}</div>` +
    `<div class="rl-inputs">${choices.join(" ")}</div><h2>The values of Q: edit them in the first column</h2>` +
    `<label>Q-table <select name="table">${originals.map(({ name }) => name).map(option).join("")}</select></label> ` +
    '<button name="reset" title="Undo all edits of this Q-table">Reset Q</button></div></div></div>';
}

// The columns of one action, and between them lines; which row belongs to which set is the same in all states.
function actionHtml({ inputs, shape }, name, a) {
  const others = inputs.flatMap((_, i) => Array(shape[i] - 1).fill(i)), rows = [null, ...others];
  const height = Math.max(rows.length, inputs.length) * ROW, space = (n, i) => ((i + 0.5) * height) / n;
  const lines = (from, ends) => `<svg data-from="${from}" viewBox="0 0 1 ${height}" preserveAspectRatio="none" aria-hidden="true">` +
    `${ends.map(([y, to, i, k]) => `<path d="M0 ${y}C.5 ${y} .5 ${to} 1 ${to}" stroke="${inputs[i].colour}" data-of="${[k, i]}"/>`).join("")}</svg>`;
  const meanOf = (i) => space(inputs.length, i), all = inputs.map((_, i) => i);
  const toMeans = rows.flatMap((input, k) => (input === null ? all : [input]).map((i) => [space(rows.length, k), meanOf(i), i, k]));
  const row = (input) => `<label class="rl-row" ${input === null ? "" : `data-from="1" style="background:${inputs[input].colour};` +
    `color:${inputs[input].ink}"`}><span></span><input type="number" step="any"></label>`;
  const mean = ({ sign, colour, ink }) => `<span style="background:${colour};color:${ink}">${sign} <data></data></span>`;
  const bar = (kind) => `<span><data></data><i class="rl-track"><i class="${kind}"></i></i></span>`;
  return `<div class="rl-action" role="group" aria-label="${escaped(name)}" data-a="${a}"><h2>${escaped(name)}</h2>` +
    `<div class="rl-columns" style="height:${height}px"><div class="rl-rows">${rows.map(row).join("")}</div>` +
    `${lines(2, toMeans)}<div class="rl-means" data-from="2">${inputs.map(mean).join("")}</div>` +
    `${lines(3, all.map((i) => [meanOf(i), height / 2, i, "mean"]))}<div class="rl-sum" data-from="3"><b></b><span data-from="4"></span></div>` +
    `<div class="rl-chances" data-from="4">${bar("rl-sr")}${bar("rl-qbiassr")}</div></div></div>`;
}

// A value in a field: two decimals, or three where that is all of it.
function typed(x) {
  const text = x.toFixed(3), short = x.toFixed(2);
  return +text === x && !text.endsWith("0") ? text : +short === 0 ? "0.00" : short;
}

// Whether the states are places and headings of a robot, which can be drawn.
const isRoom = ({ inputs }) => /^X,Y,(θ|theta),d$/.test(inputs.map(({ name }) => name).join());

// The robot in a state, from above: its heading, and a bar where something is right ahead.
function robotSvg({ bins }, inputs) {
  const [heading, ahead] = bins.slice(-2).map((bin, i) => parseInt(inputs.at(i - 2).values[bin].replace("−", "-"), 10));
  const bar = ahead ? '<path d="M31-24V24" stroke="var(--wall)" stroke-width="8"/>' : "";
  return `<svg class="rl-robot" viewBox="-40 -40 80 80" aria-hidden="true"><g transform="rotate(${-heading})">${bar}` +
    '<circle r="21" fill="var(--blue)" stroke="var(--card)" stroke-width="4"/><path d="M17 0 3-11V11Z" fill="var(--on-blue)"/></g></svg>';
}

// Every state as a button. Those that differ in their last two inputs alone are a block: a column for each value of the
// last but one, a row for each of the last. Blocks stand as on a map: inputs 0, 2, … go across, 1, 3, … up.
function statesHtml({ shape, inputs, states }) {
  const outer = shape.slice(0, -2), columns = shape.at(-2) ?? 1, rows = shape.at(-1), blocks = [];
  const place = (bins, first) => outer.reduce((n, size, i) => (i % 2 === first ? n * size + bins[i] : n), 0);
  const [top, last] = [inputs.at(-2), inputs.at(-1)];
  for (let first = 0; first < states.length; first += columns * rows) {
    const { bins } = states[first], row = (j) => Array.from({ length: columns }, (_, i) => button(first + i * rows + j));
    const button = (s) => `<td><button value="${s}" title="state ${s}: ${escaped(states[s].words)}"></button></td>`;
    const heads = top ? top.values.map((value, i) => `<th>${escaped(i ? value : `${top.name} ${value}`)}</th>`).join("") : "";
    const body = last.values.map((value, j) => `<tr><th>${escaped(`${last.name} ${value}`)}</th>${row(j).join("")}</tr>`);
    const common = outer.map((_, i) => `${inputs[i].name} = ${inputs[i].values[bins[i]]}`).join(", ");
    blocks.push({ across: place(bins, 0), up: place(bins, 1), html: `<b>${escaped(common)}</b><table>` +
      `<tr><td></td>${heads}</tr>${body.join("")}</table>` });
  }
  const highest = Math.max(...blocks.map(({ up }) => up));
  return blocks.map(({ across, up, html }) => `<div style="grid-area:${highest - up + 1}/${across + 1}">${html}</div>`).join("");
}

class Explorer {
  constructor(model, place) {
    this.model = model;
    this.about = model.get("about");
    place.innerHTML = explorerHtml(this.about);
    this.root = place.firstChild;
    const all = (what) => [...this.root.querySelectorAll(what)];
    this.buttons = all(".rl-states button").sort((one, other) => one.value - other.value);
    this.inputs = all("[data-input]");
    this.blocks = all(".rl-action");
    this.later = all("[data-from]");
    this.named = Object.fromEntries(all("[name]").map((control) => [control.name, control]));
    const { bias } = this.found();
    this.action = bias.indexOf(Math.max(...bias));
    this.root.onclick = ({ target }) => {
      const steps = { back: -1, next: 1, all: 4 };
      if (target.name === "reset") this.set("tables", this.withTable(this.about.originals[model.get("table")].q));
      else if (target.name === "next" && model.get("stage") === 4) this.set("stage", 0);
      else if (target.name in steps) this.step(steps[target.name]);
      else if (target.closest(".rl-states button")) this.set("state", +target.closest("button").value);
    };
    this.root.onchange = ({ target }) => this.take(target);
    this.root.onkeydown = (event) => this.press(event);
    this.show();
  }

  get q() {
    return this.model.get("tables")[this.model.get("table")];
  }

  get scale() {
    return this.about.originals[this.model.get("table")].scale;
  }

  found() {
    return biasOf(this.about, this.q, this.scale, this.model.get("state"));
  }

  // Another value of the model; who listens to it shows it.
  set(name, value) {
    this.model.set(name, value);
    this.model.save_changes();
  }

  step(by) {
    this.set("stage", Math.min(Math.max(this.model.get("stage") + by, 0), 4));
  }

  // All tables, with q in place of the one that is shown.
  withTable(q) {
    return this.model.get("tables").map((each, i) => (i === this.model.get("table") ? q : each));
  }

  // The keys ← and → build the columns; in a field they move the cursor, and Enter takes its number.
  press(event) {
    const { key, target } = event, by = { ArrowLeft: -1, ArrowRight: 1 }[key], isField = target.matches?.("input, select");
    if (event.defaultPrevented || (isField ? key !== "Enter" || target.matches("select") : !by)) return;
    event.preventDefault(); // JupyterLab would keep it for itself
    event.stopPropagation();
    if (!isField) return this.step(by);
    target.blur(); // what was typed counts now, and once
    target.focus();
  }

  // A list or a field was changed.
  take(control) {
    if (control.name === "table") return this.set("table", +control.value);
    if (control.name === "action") {
      this.action = +control.value;
      return this.show();
    }
    if (control.dataset.input) {
      const bins = this.inputs.map(({ value }) => +value), { shape } = this.about;
      return this.set("state", bins.reduce((s, bin, i) => s * shape[i] + bin, 0));
    }
    const { s, a } = control.dataset, value = control.valueAsNumber;
    if (!Number.isFinite(value)) return this.show(); // what is no number is not taken over
    this.set("tables", this.withTable(this.q.map((row, k) => (k === +s ? row.map((x, i) => (i === +a ? value : x)) : row))));
  }

  // Bring everything in line with the model.
  show() {
    const { about, q, model, action, named } = this, found = this.found();
    const [s, stage] = ["state", "stage"].map((name) => model.get(name)), inputOf = new Map(stage ? found.members : [[s]]);
    this.buttons.forEach((button, k) => {
      const input = inputOf.get(k), { colour = "", ink = "" } = about.inputs[input] ?? {};
      const robot = isRoom(about) ? robotSvg(about.states[k], about.inputs) : "";
      button.innerHTML = robot + k + (input === undefined ? "" : `<span>${marksHtml(about, input)}</span>`);
      button.setAttribute("aria-pressed", k === s);
      Object.assign(button.style, { background: colour, color: ink });
    });
    this.inputs.forEach((select, i) => { select.value = about.states[s].bins[i]; });
    this.blocks.forEach((block, a) => this.showAction(block, a, s, stage, found));
    for (const each of this.later) each.style.visibility = stage < each.dataset.from ? "hidden" : "";
    named.next.textContent = NEXT[stage];
    this.root.querySelector(".rl-finding").innerHTML = findingHtml(about, found);
    named.back.disabled = !stage;
    named.action.value = action;
    for (const each of [named.all, named.action.parentNode]) each.hidden = stage === 4;
    named.table.value = model.get("table");
    this.root.querySelector(".said").innerHTML = saidHtml(about, q, s, action, stage, found);
    this.root.querySelector(".rl-legend").innerHTML = legendHtml(about, this.scale, s, stage);
  }

  // The numbers of one action, into the block of its columns.
  showAction(block, a, s, stage, { sets, members, means, bias, sr, qbiassr }) {
    const { about, q } = this, most = Math.max(...means.flatMap((mean) => Array.from(mean, Math.abs)), 1e-9), write = (what, texts) => block.querySelectorAll(what).forEach((each, i) => { each.innerHTML = texts[i]; });
    block.hidden = stage < 4 && a !== this.action;
    write(".rl-row span:first-child", members.map(([k, input]) => `<b>${k}</b>${stage ? marksHtml(about, input) : ""}`));
    for (const line of block.querySelectorAll("path")) { // as wide as what it brings; dashed if that speaks against
      const [k, i] = line.dataset.of.split(","), say = k === "mean" ? means[i][a] : q[members[k][0]][a] / sets[i].length;
      line.style.strokeWidth = `max(1px, ${Math.min(1, Math.abs(say) / most)} * var(--widest))`;
      line.style.strokeDasharray = say < 0 ? "4 3" : "";
      line.style.opacity = say ? 1 : 0.5;
    }
    block.querySelectorAll("input").forEach((field, i) => {
      const [k] = members[i];
      Object.assign(field.dataset, { s: k, a });
      field.setAttribute("aria-label", `Q of state ${k}, ${about.actions[a]}`);
      field.parentNode.title = `state ${k}: ${about.states[k].words}`;
      field.value = typed(q[k][a]);
    });
    write(".rl-means data", means.map((mean) => twoDecimals(mean[a])));
    write(".rl-sum b", [twoDecimals(bias[a])]);
    write(".rl-sum span", [`<i>Q</i>(<i>s</i>) + bias = ${whole(twoDecimals(q[s][a] + bias[a]))}`]);
    write(".rl-chances data", [sr, qbiassr].map((p) => `${(100 * p[a]).toFixed(1)} %`));
    block.querySelectorAll(".rl-track i").forEach((bar, i) => { bar.style.width = `${100 * [sr, qbiassr][i][a]}%`; });
  }
}

// A view of a model; a notebook may show several.
function render({ model, el }) {
  const explorer = new Explorer(model, el), show = () => explorer.show();
  model.on("change", show);
  return () => model.off("change", show);
}

// A file alone: its model is the page's own, and the address leads to what is shown: #17, or #17-2 in the second table.
function standalone(told, el) {
  const listeners = [], { states, originals } = told.about, clamped = (x, end) => Math.min(Math.max(x, 0), end - 1);
  const model = {
    get: (name) => told[name],
    set(name, value) { told[name] = value; },
    save_changes: () => listeners.forEach((hear) => hear()),
    on: (_, hear) => listeners.push(hear),
  };
  const link = () => {
    const at = `#${told.state}${originals.length > 1 ? `-${told.table + 1}` : ""}`;
    if (location.hash !== at) history.replaceState(null, "", at);
  };
  const follow = () => {
    const [, s, nth] = /^#(\d+)(?:-(\d+))?$/.exec(location.hash) ?? [];
    if (s) told.state = clamped(+s, states.length);
    if (nth) told.table = clamped(nth - 1, originals.length);
    model.save_changes();
  };
  render({ model, el });
  document.addEventListener("keydown", (event) => el.firstChild.onkeydown(event)); // wherever the reader is
  model.on("change", link);
  onhashchange = follow;
  follow();
}
