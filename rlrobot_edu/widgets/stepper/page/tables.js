// Q and the traces as tables of coloured numbers; and which states and actions fit into them.

const MOST_STATES = 48, MOST_ACTIONS = 9; // of more, the latest BLOCK states and MOST_ACTIONS actions are shown
const BLOCK = 12; // rows in one block; the next block stands beside it
const FAINTEST_FRAME = 0.35; // opacity of the frame around the smallest changes
const count = (n) => Array.from({ length: n }, (_, i) => i);

// The part of the tables that is shown: states (null is an empty row), actions, and both in words.
function windowOf(tape) {
  const nStates = tape.q.length, { nActions, frame } = tape, says = [];
  let states = count(nStates), actions = count(nActions);
  if (nStates <= MOST_STATES && nActions <= MOST_ACTIONS) return { states, actions, says: `all ${nStates} states` };
  const [recent, taken] = tape.recent(BLOCK);
  if (nStates > MOST_STATES) {
    states = [...recent, ...Array(BLOCK - recent.length).fill(null)];
    says.push(`the ${BLOCK} states visited last, of ${nStates}`);
  }
  if (nActions > MOST_ACTIONS) { // what the update took for the value of s′ is always shown
    const follows = frame ? [frame.a, frame.a2 ?? frame.best, frame.best] : [];
    actions = [...new Set([...follows, ...taken, ...actions])].slice(0, MOST_ACTIONS).sort((a, b) => a - b);
    says.push(`${MOST_ACTIONS} of ${nActions} actions, the latest among them`);
  }
  return { states, actions, says: says.join("; ") || `all ${nStates} states` };
}

// Q as a heatmap with numbers, in the cells of qCells.
const qHtml = (about, tape, shown, pointsAt) => blocks(about, qCells(about, tape, pointsAt), shown, tape.frame);

// The cells of Q by state and action, a dot where nothing was tried. What the step changed is framed: ▲ 38.0 → 48.5; the
// frame is the stronger the more it changed. pointsAt: the pairs whose value the update took for what follows.
function qCells(about, tape, pointsAt) {
  const most = largest(tape.q, about.rMax), { frame, nActions } = tape, old = new Map();
  let mostChanged = 0;
  if (frame) {
    frame.q[0].forEach((at, i) => {
      old.set(at, frame.old[i]);
      mostChanged = Math.max(mostChanged, Math.abs(frame.q[1][i] - frame.old[i]));
    });
  }
  return (s, a) => {
    const value = tape.q[s][a], was = old.get(s * nActions + a), kinds = [];
    let sign = "", title = "", strength = "";
    if (was !== undefined) {
      sign = `<u>${arrow(was, value)}</u><small>${beforeIt(was, value)}</small>`;
      title = ` title="by ${number(value - was)}"`;
      strength = `;--strength:${Math.max(FAINTEST_FRAME, Math.abs(value - was) / mostChanged).toFixed(1)}`;
      kinds.push("new");
    }
    if (frame && s === frame.s && a === frame.a) kinds.push("pair");
    if (pointsAt.some(([s2, a2]) => s === s2 && a === a2)) kinds.push("next");
    const place = ` data-at="${s * nActions + a}"`;
    if (!value && !tape.visits[s][a]) return `<td class="${["dot", ...kinds].join(" ")}"${place}>·</td>`;
    const kind = kinds.length ? ` class="${kinds.join(" ")}"` : "";
    return `<td${kind}${place}${title} style="background:${tint(value, most)}${strength}">${sign}${short(value)}</td>`;
  };
}

// How a change is written before the new value: the old one, or by how much where both look the same.
const arrow = (was, value) => (value > was ? "▲" : "▼");
const beforeIt = (was, value) => (short(was) === short(value) ? `${value > was ? "+" : ""}${short(value - was)}` : `${short(was)} → `);

// What the colours mean.
function scaleHtml(most) {
  const swatch = (x) => `<b style="background:${tint(x, most)}">${given(x)}</b>`;
  return `<span class="scale">${[-1, -0.2, -0.02, 0, 0.02, 0.2, 1].map((x) => swatch(x * most)).join("")}</span>`;
}

// The traces by which the update learned, in the same places; a weaker trace has a paler colour.
function tracesHtml(about, tape, shown) {
  const { frame, nActions } = tape, [where, values] = frame ? frame.traces : [[], []];
  const traces = new Map(where.map((at, i) => [at, values[i]]));
  const cell = (s, a) => {
    const at = s * nActions + a, e = traces.get(at) ?? 0;
    if (e === 0) return '<td class="dot">·</td>';
    const kind = frame && at === frame.s * nActions + frame.a ? ' class="pair"' : "";
    return `<td${kind} style="background:${traceTint(e)}">${short(e)}</td>`;
  };
  return blocks(about, cell, shown, frame);
}

// Tables of cell(s, a), one for each block of states, side by side.
function blocks({ names }, cell, { states, actions }, frame) {
  const mark = (on) => (on ? ' class="on"' : "");
  const head = actions.map((a) => `<th title="action ${a}: ${escaped(names.actions[a])}"${mark(frame && a === frame.a)}>` +
    `${escaped(names.columns[a])}</th>`).join("");
  const row = (s) => {
    if (s === null) return `<tr class="empty"><td colspan="${actions.length + 1}">&nbsp;</td></tr>`;
    const role = (frame && s === frame.s ? "s" : "") + (frame && s === frame.s2 ? " s′" : "");
    const label = `<th title="${escaped(stateInWords(names, s))}"${mark(role)}><em>${role}</em> ${s}</th>`;
    return `<tr>${label}${actions.map((a) => cell(s, a)).join("")}</tr>`;
  };
  const rows = Math.ceil(states.length / Math.ceil(states.length / BLOCK)); // of equal length
  const starts = count(Math.ceil(states.length / rows)).map((i) => i * rows);
  const tables = starts.map((i) => `<table><tr><th>state</th>${head}</tr>${states.slice(i, i + rows).map(row).join("")}</table>`);
  return `<div class="blocks">${tables.join("")}</div>`;
}

// The bin of each input in state s, and what it reads there.
function binsOf({ shape }, s) {
  return shape.map((bins, i) => Math.floor(s / shape.slice(i + 1).reduce((n, each) => n * each, 1)) % bins);
}
const readingsOf = (names, s) => binsOf(names, s).map((bin, i) => (names.readings[i]?.[bin] ?? String(bin)));
const stateInWords = (names, s) => readingsOf(names, s).map((text, i) => `${names.inputs[i]} = ${text}`).join(", ");
