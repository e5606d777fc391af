// The bias explorer on a page: what the reader presses and edits. What it shows stands in a model: that of a widget,
// or of a file alone; `state`, `table` (the number of one) and `tables` (the values of all) change.

// All that stays while the numbers change: the states, the inputs, a field for each value that has a say.
function explorerHtml(about) {
  const { inputs, actions, originals } = about, option = (text, i) => `<option value="${i}">${escaped(text)}</option>`;
  const choices = inputs.map(({ name, sign, words }, i) =>
    `<label>${sign} ${escaped(name)} <select data-input="${i}">${words.map(option).join("")}</select></label>`);
  const fields = actions.map(() => '<td><input type="number" step="any"></td>').join("");
  const rows = 1 + inputs.reduce((n, { words }) => n + words.length - 1, 0);
  const heads = [`state (${inputs.map(({ name }) => name).join(", ")})`, ...actions].map((name) => `<th scope="col">${escaped(name)}</th>`).join("");
  return '<div class="rl-bias"><p class="said" role="status"></p><div class="rl-top"><div class="rl-left">' +
    "<h4>The state: click one, or choose its inputs</h4>" +
    `<div class="rl-states" role="group" aria-label="The states: click one">${statesHtml(about)}</div>` +
    `<div class="rl-inputs">${choices.join(" ")}</div><div class="rl-legend"></div></div><div class="rl-choice"></div>` +
    '<div class="rl-members" role="region" aria-label="Q of the states that have a say"><h4>Q of the states that have a say: ' +
    `edit it</h4><label>Q-table <select name="table">${originals.map(({ name }) => name).map(option).join("")}</select></label> ` +
    '<button name="reset" title="Undo all edits of this Q-table">Reset Q</button>' +
    `<table><tr>${heads}</tr>${`<tr><th scope="row"></th>${fields}</tr>`.repeat(rows)}</table></div></div>` +
    '<div class="rl-formulas"></div></div>';
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

// All that is drawn anew, by its class: what biasOf has found in state s.
const panesOf = (about, q, scale, s, found) => ({
  said: saidHtml(about, s, found), "rl-legend": legendHtml(about, s),
  "rl-choice": choiceHtml(about, q, scale, s, found), "rl-formulas": formulasHtml(about, q, s, found),
});

class Explorer {
  constructor(model, place) {
    this.model = model;
    this.about = model.get("about");
    place.innerHTML = explorerHtml(this.about);
    this.root = place.firstChild;
    const all = (what) => [...this.root.querySelectorAll(what)];
    this.buttons = all(".rl-states button").sort((one, other) => one.value - other.value);
    this.inputs = all("[data-input]");
    this.rows = all(".rl-members tr + tr");
    this.root.onclick = ({ target }) => {
      if (target.name === "reset") this.set("tables", this.withTable(this.about.originals[model.get("table")].q));
      else if (target.value && target.matches(".rl-states button")) this.set("state", +target.value);
    };
    this.root.onchange = ({ target }) => this.take(target);
    this.root.onkeydown = (event) => {
      if (event.key !== "Enter" || !event.target.matches("input")) return;
      event.preventDefault(); // JupyterLab would keep it for itself
      event.stopPropagation();
      event.target.blur(); // what was typed counts now, and once
      event.target.focus();
    };
    this.show();
  }

  get q() {
    return this.model.get("tables")[this.model.get("table")];
  }

  // Another value of the model; who listens to it shows it.
  set(name, value) {
    this.model.set(name, value);
    this.model.save_changes();
  }

  // All tables, with q in place of the one that is shown.
  withTable(q) {
    return this.model.get("tables").map((each, i) => (i === this.model.get("table") ? q : each));
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
    this.set("tables", this.withTable(this.q.map((row, k) => (k === +s ? row.map((x, i) => (i === +a ? value : x)) : row))));
  }

  // Bring everything in line with the model.
  show() {
    const { about, q, model } = this, s = model.get("state"), { scale } = about.originals[model.get("table")];
    const found = biasOf(about, q, scale, s), inputOf = new Map(found.members);
    this.buttons.forEach((button, k) => {
      const input = inputOf.get(k), mark = input === undefined ? null : about.inputs[input] ?? about.here;
      button.textContent = mark ? labelOf(about, input, k) : k;
      button.setAttribute("aria-pressed", k === s);
      Object.assign(button.style, { background: mark?.colour ?? "", color: mark?.ink ?? "" });
    });
    this.inputs.forEach((select, i) => { select.value = about.states[s].bins[i]; });
    found.members.forEach(([k, input], i) => {
      const [head, ...cells] = this.rows[i].children;
      head.innerHTML = `${chip(about, input, k)} ${escaped(about.states[k].text)}`;
      cells.forEach(({ firstChild: field }, a) => {
        Object.assign(field.dataset, { s: k, a });
        field.setAttribute("aria-label", `Q of state ${k}, ${about.actions[a]}`);
        field.value = +q[k][a].toFixed(3);
      });
    });
    for (const [name, html] of Object.entries(panesOf(about, q, scale, s, found))) {
      this.root.querySelector(`.${name}`).innerHTML = html;
    }
    this.root.querySelector("[name=table]").value = model.get("table");
  }
}

// A view of a model; a notebook may show several.
function render({ model, el }) {
  const explorer = new Explorer(model, el), show = () => explorer.show();
  model.on("change", show);
  return () => model.off("change", show);
}

// A file alone: its model is the page's own, and the address leads to what is shown: #17, or #17-2 in the second table.
function alone(told, el) {
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
  model.on("change", link);
  onhashchange = follow;
  follow();
}
