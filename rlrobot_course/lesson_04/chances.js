// Probabilities end to end on one bar: where u falls, and where a hundred random numbers fall.

const RULES = ["greedy", "ε-greedy", "softmax"];
const BETWEEN = 25, FALL = 500; // from drop to drop, and of each [ms]
const DROP = 8; // room of a drop [px]

const handle = {
  controls: ({ q, u, temperatures, opening, epsilon }) => [
    ...(q ? [
      { name: "rule", kind: "choice", label: "Rule", options: RULES, value: 2 },
      { name: "epsilon", kind: "slider", label: "ε", min: 0, max: 1, step: 0.01, value: epsilon, when: ({ rule }) => rule === 1 },
      { name: "heat", kind: "slider", label: "T", min: 0, max: temperatures.length - 1, step: 1, value: opening,
        text: (i) => given(temperatures[i]), when: ({ rule }) => rule === 2 },
    ] : []),
    { name: "u", kind: "slider", label: "u", min: 0, max: 0.99, step: 0.01, value: u },
    { name: "rain", kind: "button", label: "Draw a hundred" },
  ],

  begins: () => ({ presses: 0 }),

  compute({ p, q, temperatures, numbers }, { rule, epsilon, heat, u, presses }) {
    const chances = q ? Array(q.length).fill(0) : p;
    if (q && rule === 2) kernels.softmax(q, temperatures[heat], chances);
    else if (q) kernels.epsilon_greedy({ probabilities: chances, q: [q] }, 0, rule === 1 ? epsilon : 0);
    const drops = presses ? numbers[(presses - 1) % numbers.length] : [];
    const counts = chances.map(() => 0);
    for (const drop of drops) counts[kernels.draw(chances, drop)] += 1;
    return { chances, drawn: kernels.draw(chances, u), drops, counts };
  },

  draw(found, width, feed, values) {
    const { chances, drawn, drops } = found, left = 14, wide = width - 2 * left, marks = [];
    const x = (part) => left + part * wide, top = 92, bottom = top + 46;
    marks.push(...fallen(drops, left, wide, top - 6, values.since));
    let sum = 0;
    chances.forEach((p, a) => {
      const hit = a === drawn, middle = x(sum + p / 2);
      if (a && drops.length) marks.push(line(x(sum), 8, x(sum), top, "line"));
      marks.push(bar(x(sum), p * wide, top, bottom, hit ? "blue" : "line", { stroke: ink("paper"), "stroke-width": 2 }));
      if (p * wide > 14) marks.push(letters(middle, top + 29, a, "middle", hit ? "on-blue" : "ink", { class: "rl-large" }));
      sum += p;
    });
    marks.push(letters(left, bottom + 18, "0", "start", "faint"), letters(x(1), bottom + 18, "1", "end", "faint"));
    marks.push(pointer(x(values.u), bottom, left, wide, values.u));
    const rows = bottom + 62;
    marks.push(...table(found, width, rows, feed.q));
    return { finding: findingOf(found, feed, values), height: rows + 24 * chances.length + 12, picture: marks.join(""), said: saidOf(found) };
  },

  picked: (feed, { presses }) => ({ presses: presses + 1, since: performance.now() }),
};

// Random numbers as drops, each above its place on the bar. since: when they began to fall; none: they have fallen
function fallen(drops, left, wide, ground, since) {
  const age = since === undefined ? Infinity : performance.now() - since, heaps = {};
  const falls = age < drops.length * BETWEEN + FALL;
  return drops.map((u, i) => {
    const cx = left + u * wide, heap = Math.floor((u * wide) / DROP);
    heaps[heap] = (heaps[heap] ?? 0) + 1;
    const late = falls && { class: "rl-falls", style: `fill:${ink("wall")};animation-delay:${Math.round(i * BETWEEN - age)}ms` };
    return mark("circle", { cx: cx.toFixed(1), cy: ground - (heaps[heap] - 0.5) * DROP, r: DROP / 2 - 0.6, style: `fill:${ink("wall")}`, ...late });
  });
}

// u below the bar; it can be dragged.
function pointer(x, y, left, wide, u) {
  const name = `u = ${u}`, at = Math.min(Math.max(x, left + 42), left + wide - 42);
  const shape = line(x, y - 46, x, y, "ink", { "stroke-width": 2.5 }) +
    mark("path", { d: `M${x} ${y} l-9 15 h18 z`, style: `fill:${ink("ink")}` }) + letters(at, y + 32, name, "middle", "ink", { class: "rl-large" }) +
    mark("rect", { x: x - 22, y: y - 46, width: 44, height: 82, fill: "transparent" });
  return mark("g", { "data-grip": "u", "data-from": left, "data-to": left + 0.99 * wide, role: "slider", "aria-label": name, "aria-valuenow": u }, shape);
}

// A row for each action: its value, its probability, and how often it was drawn
function table({ chances, drawn, drops, counts }, width, top, q) {
  const rained = drops.length > 0, columns = [["action", (a) => a]];
  if (q) columns.push(["Q(s, a)", (a) => given(q[a])]);
  columns.push(["P(a)", (a) => chances[a].toFixed(2)]);
  if (rained) columns.push(["expected", (a) => Math.round(100 * chances[a])], ["drawn", (a) => counts[a]]);
  const apart = Math.min((width - 72) / 4, 120);
  return columns.flatMap(([name, entry], i) => {
    const x = 58 + i * apart;
    return [letters(x, top, name, "end", "faint"), ...chances.map((_, a) =>
      letters(x, top + 24 * (a + 1), entry(a), "end", "ink", a === drawn && { style: `fill:${ink("blue")};font-weight:700` }))];
  });
}

function findingOf({ chances, drawn, drops, counts }, { q, temperatures }, { rule, epsilon, heat, u }) {
  if (!q) return `u = ${u} draws action ${drawn}${drops.length ? `, as do ${counts[drawn]} of the hundred numbers` : ""}`;
  const best = q.indexOf(Math.max(...q)), p = chances[best];
  const where = ["The greedy rule draws the best action", `At ε = ${epsilon} the best action is drawn`,
    `At T = ${given(temperatures[heat])} the best action is drawn`][rule];
  const often = p < 1 && p > 0.995 ? "nearly always" : `${Math.round(100 * p)} times in 100`;
  return `${where} ${often}${drops.length ? `; in this hundred ${counts[best]} times` : ""}`;
}

function saidOf({ drawn, drops, counts }) {
  const text = `The probabilities lie end to end from 0 to 1. u falls into the blue piece, that of action ${drawn}.`;
  if (!drops.length) return text;
  return `${text} Dots: a hundred random numbers; each draws the action of the piece below it. Actions 0, 1, …: ${counts.join(", ")} times.`;
}
