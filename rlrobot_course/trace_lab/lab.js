// The trace lab: the reader draws a path over a grid, and sees what each step of it teaches each cell.

const EXACT = 1e-9; // a smaller gap to the ideal is rounding
const SEEN = 0.005; // a smaller change shows in no number
const TRUE_ONLINE = "true online";

const times = (n) => (n === 1 ? "once" : n === 2 ? "twice" : `${n} times`);
const stepsOf = (path) => Math.max(path.length - 1, 0);
const tableFor = (path, cells) => Array.from({ length: stepsOf(path) + 1 }, () => Array(cells.length).fill(0));

function touch(a, b, columns) { // a cell touches itself, too: a step may lead back into it
  const row = (c) => Math.floor(c / columns), column = (c) => c % columns;
  return Math.abs(row(a) - row(b)) + Math.abs(column(a) - column(b)) <= 1;
}

// The cell that is left most often, of several the one that is left first.
function watched(path) {
  const left = path.slice(0, -1), often = left.map((cell) => left.filter((other) => other === cell).length);
  return left[often.indexOf(Math.max(...often))];
}

// What is learned along the path with one kind of trace.
function learned({ cells, pays }, { path, alpha, gamma, lam, first, second }, kind) {
  const q = tableFor(path, cells), e = tableFor(path, cells), rewards = path.slice(1).map((cell) => pays[cell]);
  const delta = q.map(() => 0), qOld = q.map(() => 0), way = [path, rewards, alpha, gamma, lam];
  if (kind === TRUE_ONLINE) kernels.true_online(q, e, delta, qOld, ...way, +first, +second);
  else kernels.sarsa_lambda(q, e, delta, ...way, kind === "accumulating" ? 1 : 0);
  return { q, e, delta, qOld };
}

const handle = {
  controls: (feed) => [
    ...Object.keys(feed.paths).map((name) => ({ name: `path ${name}`, kind: "button", label: name })),
    { name: "undo", kind: "button", label: "undo" },
    { name: "clear", kind: "button", label: "clear" },
    { name: "step", kind: "scrubber", label: "step", last: stepsOf(feed.path), value: stepsOf(feed.path) },
    ...(feed.kinds.length > 1 ? [{ name: "kind", kind: "choice", label: "Trace:", options: feed.kinds, value: feed.kind }] : []),
    ...(feed.hasSwitches ? [
      { name: "first", kind: "toggle", label: "first line: + q_sa − Q_old", value: true },
      { name: "second", kind: "toggle", label: "second line: − α (q_sa − Q_old)", value: true },
    ] : []),
    { name: "alpha", kind: "slider", label: "α", min: 0.05, max: 1, step: 0.05, value: feed.alpha },
    { name: "gamma", kind: "slider", label: "γ", min: 0, max: 1, step: 0.05, value: feed.decay },
    { name: "lam", kind: "slider", label: "λ", min: 0, max: 1, step: 0.05, value: feed.decay },
  ],

  begins: ({ path, kind }) => ({ path, kind, first: true, second: true, note: "" }),

  limits: (_, { path }) => ({ step: stepsOf(path) }),

  picked({ cells, columns, longest, paths }, { path }, name) {
    const on = (way) => ({ path: way, step: stepsOf(way), note: "" });
    if (name === "undo") return on(path.slice(0, -1));
    if (name === "clear") return on([]);
    if (name.startsWith("path ")) return on(paths[name.slice(5)]);
    const cell = cells.indexOf(name), here = path.at(-1);
    if (path.length && !touch(here, cell, columns)) return { note: `${name} does not touch ${cells[here]}, where the path ends. ` };
    if (stepsOf(path) === longest) return { note: `A path has ${longest} steps at most. ` };
    return on([...path, cell]);
  },

  compute(feed, values) {
    const { path, step, alpha, gamma, lam } = values;
    const runs = feed.kinds.map((kind) => learned(feed, values, kind)), run = runs[values.kind];
    const visits = feed.cells.split("").map((_, cell) => path.slice(0, step).filter((left) => left === cell).length);
    const traces = runs.flatMap(({ e }) => e.flat());
    const found = { ...run, visits, watched: watched(path), largestTrace: Math.max(1, ...traces), ideal: null, gap: null };
    if (feed.againstIdeal) {
      found.ideal = tableFor(path, feed.cells);
      kernels.online_lambda_return(found.ideal, path, path.slice(1).map((cell) => feed.pays[cell]), alpha, gamma, lam);
      const gaps = run.q[step].map((q, cell) => q - found.ideal[step][cell]), sizes = gaps.map(Math.abs);
      const cell = sizes.indexOf(Math.max(...sizes));
      found.gap = { cell, by: gaps[cell] };
    }
    return found;
  },

  draw(found, width, feed, values) {
    return { finding: finding(found, feed, values), said: said(found, feed, values), ...grid(found, width, feed, values) };
  },
};

function finding(found, feed, values) {
  const { path, step } = values, { cells } = feed;
  if (path.length < 2) return path.length ? `The path begins in ${cells[path[0]]}: press a cell beside it` : "Press a cell: the path begins there";
  if (!step) return "Before the first step all traces and all values are 0";
  return feed.againstIdeal ? aboutTheGap(found, feed, values) : aboutTheStep(found, feed, values);
}

// Lesson 07: whom this step teaches.
function aboutTheStep({ e, delta }, { cells }, { path, step, alpha }) {
  const changes = e[step].map((trace) => alpha * delta[step] * trace), sizes = changes.map(Math.abs);
  const taught = sizes.filter((size) => size >= SEEN).length, marked = e[step].filter((trace) => trace >= SEEN).length;
  if (!taught) return `Step ${step} teaches nothing, for δ = ${short(delta[step])}; ${marked === 1 ? "one cell has a trace" : `${marked} cells have a trace`}`;
  const most = sizes.indexOf(Math.max(...sizes)), least = sizes.indexOf(Math.min(...sizes.filter((size) => size >= SEEN)));
  if (taught === 1) return `Step ${step} teaches ${cells[most]} alone: ${change(changes[most])}`;
  return `Step ${step} teaches ${taught} cells: ${cells[most]} most, ${change(changes[most])}, and ${cells[least]} least, ${change(changes[least])}`;
}

const change = (x) => (x > 0 ? `+${amount(x)}` : amount(x));

// A value, or how far two are apart, in six signs at most.
function amount(x) {
  const size = Math.abs(x);
  return tidy(size >= 1e5 ? x.toExponential(0) : x.toFixed(size >= 1000 ? 0 : size >= 100 ? 1 : 2));
}

// Lesson 08: how far from the ideal.
function aboutTheGap({ gap, visits }, feed, { kind, first, second }) {
  const name = { replacing: "Replacing traces", accumulating: "Accumulating traces", [TRUE_ONLINE]: trueOnline(first, second) }[feed.kinds[kind]];
  const size = Math.abs(gap.by);
  if (size < EXACT) return feed.kinds[kind] === TRUE_ONLINE && first && second ? "True online is the ideal, in every cell" : `${name}: no gap to the ideal after this step`;
  const where = `Q of ${feed.cells[gap.cell]}, left ${times(visits[gap.cell])}, is`;
  return `${name}: ${where} ${size < SEEN ? "almost the ideal" : `${amount(size)} ${gap.by > 0 ? "above" : "below"} the ideal`}`;
}

function trueOnline(first, second) {
  if (first && second) return "True online";
  if (!first && !second) return "Without Q_old";
  return first ? "Without the second line" : "Without q_sa − Q_old in the first line";
}

function said(found, feed, values) {
  const { path, step, alpha, note } = values, { cells, pays } = feed;
  const key = "Orange: the trace e as this step uses it. Blue: Q, red below 0. " +
    (feed.againstIdeal ? "Frame and grey band: the ideal’s Q. Dashed line: e = 1/α. " : "Dashed line: e = 1. ");
  if (!step) return `${note}${key}A pays 10 to a step that leads into it, E takes 2. A cell that is pressed twice is a step back into itself.`;
  const from = path[step - 1], to = path[step], trace = found.e[step][from];
  let told = `Step ${step}, ${cells[from]} → ${cells[to]}, pays ${tidy(String(pays[to]))}: δ = ${amount(found.delta[step])}, e(${cells[from]}) = ${amount(trace)}`;
  const overshoots = alpha * trace > 1 + EXACT && Math.abs(found.delta[step]) > EXACT;
  told += overshoots ? `, so α · e = ${amount(alpha * trace)} is above 1: it overshoots. ` : ". ";
  if (feed.kinds[values.kind] === TRUE_ONLINE && feed.againstIdeal) {
    const before = found.q[step - 1][from], noted = found.qOld[step];
    told += `Noted for ${cells[from]}: Q_old = ${amount(noted)}; now q_sa = ${amount(before)}; δ + q_sa − Q_old = ${amount(found.delta[step] + before - noted)}. `;
  }
  return note + told + key;
}
