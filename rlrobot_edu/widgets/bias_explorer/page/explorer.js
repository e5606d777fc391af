// The bias explorer on a page: what the reader presses and edits. What it shows stands in a model: that of a widget,
// or of a file alone; `state`, `table` (the number of one), `tables` (the values of all) and `stage` change.

const ROW = 26; // height of a state's row [px]
const LEAST_ROWS = 5; // so high are the columns at least, for what stands below the bias
const WIDEST = 10; // of a line from a state to its mean, and on to the bias [px]
const NEXT = ["Next: similar states", "Next: the mean of each set", "Next: the bias", "Next: the choice",
  "Build it up, step by step"];

// All that stays while the numbers change: the states, a block of columns for each action, the inputs.
function explorerHtml(about) {
  const { inputs, actions, originals } = about, option = (text, i) => `<option value="${i}">${escaped(text)}</option>`;
  const choices = inputs.map(({ name, words }, i) =>
    `<label>${marksHtml(about, i)} ${escaped(name)} <select data-input="${i}">${words.map(option).join("")}</select></label>`);
  const where = isRoom(about) ? "in the room" : "in the tables";
  return '<div class="rl-bias rl-look"><h2 class="rl-asks"></h2><p class="rl-finding" data-from="4"></p><div class="rl-top"><div class="rl-chooser">' +
    `<div class="rl-states${isRoom(about) ? " rl-room" : ""}" role="group" aria-label="The states: click one">${statesHtml(about)}</div>` +
    '<div class="rl-steps"><button name="back" title="Back (key ←)">Back</button> <button name="next" title="Next (key →)"></button> ' +
    '<button name="all">All columns</button></div>' +
    `<p class="rl-do"><b>Click</b> another state ${where}. <b>Drag</b> a value: the choice changes.</p>` +
    '<p class="rl-legend" data-from="1"></p>' +
    `<div class="rl-inputs">${choices.join(" ")} <label>Q-table <select name="table">` +
    `${originals.map(({ name }) => name).map(option).join("")}</select></label> ` +
    '<button name="reset" title="Undo all edits of this Q-table">Reset Q</button></div>' +
    '<p class="said" role="status"></p></div><div class="rl-shown">' +
    '<div class="rl-picture" role="region" aria-label="Four columns">' +
    '<div class="rl-columns rl-heads"><b>learned<span>, <i>Q</i>: here and in similar states</span></b>' +
    '<b data-from="2">mean<span> of each set</span></b><b data-from="3">bias<span>: mean of means</span></b>' +
    '<b data-from="4">chance</b></div>' +
    `${actions.map((name, a) => actionHtml(about, name, a)).join("")}</div><p class="rl-bars" data-from="4"></p></div></div></div>`;
}

// One action: a row with its bias and its chances, which opens its columns, and between these lines; which row belongs to
// which set is the same in all states.
function actionHtml({ inputs, shape }, name, a) {
  const others = inputs.flatMap((_, i) => Array(shape[i] - 1).fill(i)), rows = [null, ...others];
  const height = Math.max(rows.length, inputs.length, LEAST_ROWS) * ROW, space = (n, i) => ((i + 0.5) * height) / n;
  const own = (i) => `style="--own:${i === null ? "" : inputs[i].colour}"`;
  const lines = (from, ends) => `<svg data-from="${from}" viewBox="0 0 1 ${height}" preserveAspectRatio="none" aria-hidden="true">` +
    `${ends.map(([y, to, i]) => `<path d="M0 ${y}C.5 ${y} .5 ${to} 1 ${to}" ${own(i)}/>`).join("")}</svg>`;
  const meanOf = (i) => space(inputs.length, i), all = inputs.map((_, i) => i);
  const toMeans = rows.flatMap((input, k) => (input === null ? all : [input]).map((i) => [space(rows.length, k), meanOf(i), i]));
  const row = (input) => `<div class="rl-row" ${own(input)}${input === null ? "" : ' data-from="1"'}><span></span>` +
    '<input type="number" step="any"></div>';
  const mean = (i) => `<span ${own(i)}>${marksHtml({ inputs }, i)} <data></data></span>`;
  const bar = (kind) => `<span><data></data><i class="rl-track"><i class="${kind}"></i></i></span>`;
  const chances = `<span class="rl-chances" data-from="4">${bar("rl-sr")}${bar("rl-qbiassr")}</span>`;
  return `<div class="rl-action" role="group" aria-label="${escaped(name)}" data-a="${a}">` +
    `<button class="rl-columns rl-fold" name="fold"><span class="rl-name">${escaped(name)}</span>` +
    `<b class="rl-bias-of" data-from="3"></b>${chances}</button>` +
    `<div class="rl-columns rl-open" style="height:${height}px"><div class="rl-rows">${rows.map(row).join("")}</div>` +
    `${lines(2, toMeans)}<div class="rl-means" data-from="2">${all.map(mean).join("")}</div>` +
    `${lines(3, all.map((i) => [meanOf(i), height / 2, i]))}<div class="rl-sum" data-from="3"><b></b><span data-from="4"></span></div>` +
    `${chances}</div></div>`;
}

// A value in a field, as exact as it is shown; three decimals where that is all of it.
function typed(x) {
  const text = x.toFixed(3);
  return +text === x && !text.endsWith("0") ? text : amount(x).replaceAll("−", "-");
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
    this.root.onclick = ({ target }) => {
      const steps = { back: -1, next: 1, all: 4 };
      const fold = target.closest("[name=fold]");
      if (fold) this.open(+fold.parentNode.dataset.a);
      else if (target.name === "reset") this.set("tables", this.withTable(this.about.originals[model.get("table")].q));
      else if (target.name === "next" && model.get("stage") === 4) this.set("stage", 0);
      else if (target.name in steps) this.step(steps[target.name]);
      else if (target.closest(".rl-states button")) this.set("state", +target.closest("button").value);
    };
    this.root.onchange = ({ target }) => this.take(target);
    this.root.onkeydown = (event) => this.press(event);
    this.root.onpointerdown = (event) => this.drag(event);
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

  // Show the columns of this action.
  open(action) {
    this.action = action;
    this.show();
  }

  step(by) {
    this.set("stage", Math.min(Math.max(this.model.get("stage") + by, 0), 4));
  }

  // All tables, with q in place of the one that is shown.
  withTable(q) {
    return this.model.get("tables").map((each, i) => (i === this.model.get("table") ? q : each));
  }

  // All tables, with another value of Q(s, a) in the one that is shown.
  changed(s, a, value) {
    return this.withTable(this.q.map((row, k) => (k === s ? row.with(a, value) : row)));
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

  // A value follows the pointer, to the right up and to the left down; whoever else sees it is told at the end.
  drag(event) {
    const row = event.target.closest(".rl-row"), { model } = this;
    if (!row || event.button || event.target.matches("input")) return;
    const { s, a } = row.lastChild.dataset, was = this.q[s][a], width = row.offsetWidth;
    const most = Math.max(1, ...this.q.flat().map(Math.abs));
    row.setPointerCapture(event.pointerId);
    row.onpointermove = ({ clientX }) => {
      const moved = (2 * most * (clientX - event.clientX)) / width;
      model.set("tables", this.changed(+s, +a, Math.round(100 * (was + moved)) / 100));
      this.show();
    };
    row.onlostpointercapture = () => {
      row.onpointermove = row.onlostpointercapture = null;
      model.save_changes();
    };
  }

  // A list or a field was changed.
  take(control) {
    if (control.name === "table") return this.set("table", +control.value);
    if (control.dataset.input) {
      const bins = this.inputs.map(({ value }) => +value), { shape } = this.about;
      return this.set("state", bins.reduce((s, bin, i) => s * shape[i] + bin, 0));
    }
    const { s, a } = control.dataset, value = control.valueAsNumber;
    if (!Number.isFinite(value)) return this.show(); // what is no number is not taken over
    this.set("tables", this.changed(+s, +a, value));
  }

  // Bring everything in line with the model.
  show() {
    const { about, q, model, named } = this, found = this.found();
    const [s, stage, table] = ["state", "stage", "table"].map((name) => model.get(name)), at = `${s} of ${table}`;
    if (at !== this.at) { // an edit opens no other action
      this.action = mostChanged(found);
      this.root.querySelector(".rl-heads").after(this.blocks[this.action], ...this.blocks.filter((_, a) => a !== this.action));
    }
    this.at = at;
    const inputOf = new Map(stage ? found.members : [[s, null]]);
    this.buttons.forEach((button, k) => showState(button, about, k, inputOf.get(k)));
    this.inputs.forEach((select, i) => { select.value = about.states[s].bins[i]; });
    const largest = Math.max(1e-9, ...found.flows.flat(2).map(Math.abs));
    const wide = (x) => Math.max(1, (WIDEST * Math.abs(x)) / largest);
    this.blocks.forEach((block, a) => {
      this.showAction(block, a, s, stage, found);
      block.querySelectorAll("path").forEach((path, i) => {
        const flow = found.flows[a][i];
        path.style.strokeWidth = wide(flow);
        path.classList.toggle("rl-against", flow < 0);
      });
    });
    for (const each of this.later) each.style.visibility = stage < each.dataset.from ? "hidden" : "";
    named.next.textContent = NEXT[stage];
    this.root.querySelector(".rl-asks").textContent = question(q[s]);
    this.root.querySelector(".rl-finding").innerHTML = findingHtml(about, q, s, found);
    named.back.disabled = !stage;
    named.all.hidden = stage === 4;
    named.table.value = table;
    const said = this.root.querySelector(".said");
    said.innerHTML = saidHtml(about, q, s, this.action, stage, found);
    said.classList.toggle("rl-heard", stage === 4); // then all columns show the same
    this.root.querySelector(".rl-legend").innerHTML = legendHtml(about, s, stage);
    this.root.querySelector(".rl-bars").innerHTML = barsHtml(about, this.scale);
  }

  // The numbers of one action, into the block of its columns.
  showAction(block, a, s, stage, { members, means, bias, sr, qbiassr }) {
    const { about, q } = this, write = (what, texts) => block.querySelectorAll(what).forEach((each, i) => { each.innerHTML = texts[i]; });
    const isOpen = a === this.action;
    block.classList.toggle("rl-opened", isOpen);
    block.querySelector(".rl-open").hidden = !isOpen;
    block.firstChild.setAttribute("aria-expanded", isOpen);
    write(".rl-row span:first-child", members.map(([k, input]) => `<b>${k}</b>${stage ? marksHtml(about, input) : ""}`));
    block.querySelectorAll("input").forEach((field, i) => {
      const [k] = members[i];
      Object.assign(field.dataset, { s: k, a });
      field.setAttribute("aria-label", `Q of state ${k}, ${about.actions[a]}`);
      field.parentNode.title = `state ${k}: ${about.states[k].words}`;
      field.value = typed(q[k][a]);
    });
    write(".rl-means data", means.map((mean) => amount(mean[a])));
    write(".rl-sum b, .rl-bias-of", [amount(bias[a]), amount(bias[a])]);
    write(".rl-sum span", [`<i>Q</i>(<i>s</i>) + bias = ${whole(amount(q[s][a] + bias[a]))}`]);
    const told = percents(sr[a], qbiassr[a], 1), chances = [sr[a], qbiassr[a]];
    write(".rl-chances data", [...told, ...told]); // folded and open
    block.querySelectorAll(".rl-track i").forEach((bar, i) => { bar.style.width = `${100 * chances[i % 2]}%`; });
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
