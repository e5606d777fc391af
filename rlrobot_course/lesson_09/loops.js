// Loop evasion, step by step: what the rule sees in the queues of two robots, and when it heats.

const TOP = [30, 158], TALL = 84; // the two charts, from above [px]
const SQUEEZED = [(rho) => Math.log(rho) / Math.log(21), (mean) => (Math.sign(mean) * Math.sqrt(Math.abs(mean)) + 0.6) / 3.8];
const TICKS = [[1, 2, 5, 21], [0, 1, 10]], SIGNS = [2, 0];
const INKS = ["blue", "faint"], DASHES = [undefined, "6 4"];

const handle = {
  controls: ({ states, opening }) => [
    { name: "t", kind: "scrubber", label: "step", min: 0, max: states[0].length - 1, last: states[0].length - 1, step: 1,
      value: opening, text: (t) => t + 1 },
  ],

  compute: ({ states, rewards, length, cold }) => states.map((visited, robot) => {
    const m = memory(length, Math.max(...visited) + 1, cold), seen = [];
    visited.forEach((s, t) => {
      const before = m.now.temperature;
      kernels.watch_for_loops(m, s, rewards[robot][t]);
      const { queue_size: size, queue_unique: different, temperature } = m.now;
      seen.push({ size, different, temperature, before, redundancy: kernels.redundancy(m), mean: kernels.mean_reward(m),
        again: m.queue_count[s] > 1, hot: temperature > cold });
    });
    return seen;
  }),

  draw(found, width, { names, states, length }, { t }) {
    const left = 30, right = width - 14, n = states[0].length, marks = [];
    const x = (step) => left + ((step + 1) / n) * (right - left);
    const from = x(Math.max(t - length, -1)), low = TOP[1] + TALL;
    marks.push(mark("rect", { x: from, width: x(t) - from, y: TOP[0], height: low - TOP[0], style: `fill:${ink("floor")}` }));
    ["redundancy", "mean"].forEach((name, chart) => marks.push(...curves(found.map((seen) => seen.map((each) => each[name])), found, chart, x, left, right)));
    marks.push(mark("g", { "data-grip": "t", "data-from": x(0), "data-to": x(n - 1), role: "slider", "aria-label": `step ${t + 1}`, "aria-valuenow": t + 1 },
      line(x(t), TOP[0], x(t), low + 4, "ink", { "stroke-width": 2 }) + mark("rect", { x: x(t) - 14, y: TOP[0], width: 28, height: low - TOP[0], fill: "transparent" })));
    for (const step of [1, 20, 40, 60].filter((each) => each <= n)) marks.push(letters(x(step - 1), low + 20, step, "middle", "faint"));
    names.forEach((name, robot) => marks.push(...queue(found[robot][t], name, states[robot].slice(Math.max(t + 1 - length, 0), t + 1), robot, low + 52 + robot * 88, width, length)));
    return { finding: findingOf(found[0][t], t, names[0], length), height: low + 52 + 2 * 88 - 12, picture: marks.join(""), said: saidOf(found[1][t], names, length) };
  },
};

// What an agent remembers, as far as the rule needs it.
function memory(length, n_states, temperature) {
  const zeros = (n) => Array(n).fill(0);
  return {
    parameters: { loop_evasion: true, temperature },
    now: { temperature, queue_size: 0, queue_unique: 0, queue_end: 0 },
    queue_states: zeros(length), queue_rewards: zeros(length), queue_count: zeros(n_states),
  };
}

// A chart with the curves of both robots and the rule's threshold.
function curves(values, found, chart, x, left, right) {
  const bottom = TOP[chart] + TALL, y = (value) => bottom - TALL * SQUEEZED[chart](value);
  const title = ["redundancy ρ: a sign above 2", "mean reward: a sign below 0"][chart];
  const marks = [letters(left - 16, TOP[chart] - 11, title), line(left, y(SIGNS[chart]), right, y(SIGNS[chart]), "ink", { "stroke-dasharray": "2 4", "stroke-width": 1.5 })];
  for (const tick of TICKS[chart]) marks.push(letters(left - 6, y(tick) + 5, tick, "end", tick === SIGNS[chart] ? "ink" : "faint"));
  for (const robot of [1, 0]) {
    const points = values[robot].map((value, step) => [x(step), y(value)]);
    marks.push(way(points, INKS[robot], { "stroke-width": 2.5, "stroke-dasharray": DASHES[robot] }));
    found[robot].forEach(({ hot }, step) => hot && marks.push(triangle(...points[step])));
  }
  return marks;
}

const hundredths = (x) => tidy(x.toFixed(2));
const triangle = (x, y) => mark("path", { d: `M${x.toFixed(1)} ${(y - 7).toFixed(1)} l6 11 h-12 z`, style: `fill:${ink("red")};stroke:${ink("paper")}` });

// The queue of a robot, oldest left: equal letters are equal states, A is the present one.
function queue({ again, mean, redundancy, size, hot, temperature }, name, visited, robot, y, width, length) {
  const wide = Math.min((width - 28) / length, 26), known = [], marks = [];
  marks.push(line(14, y - 5, 40, y - 5, INKS[robot], { "stroke-width": 2.5, "stroke-dasharray": DASHES[robot] }));
  marks.push(letters(48, y, `${name} robot: T = ${given(+temperature.toFixed(2))}${hot ? " ▲" : ""}`, "start", hot ? "red" : INKS[robot], { class: "rl-large" }));
  for (let i = 0; i < length; i += 1) {
    const s = visited[visited.length - 1 - i], x = 14 + (length - 1 - i) * wide;
    if (s !== undefined && !known.includes(s)) known.push(s);
    const now = s !== undefined && s === known[0], style = `fill:${ink(now ? INKS[robot] : "paper")};stroke:${ink("line")}`;
    marks.push(mark("rect", { x: x + 0.5, y: y + 9, width: wide - 1, height: 22, style }));
    if (s !== undefined) marks.push(letters(x + wide / 2, y + 25, String.fromCharCode(65 + known.indexOf(s)), "middle", now ? "paper" : "ink"));
  }
  const signs = [[again, "A again"], [mean < 0, `mean ${hundredths(mean)}`], [redundancy > 2, `ρ ${size}/${known.length} = ${redundancy.toFixed(1)}`]];
  const room = Math.min(width - 28, 480);
  signs.forEach(([is, text], i) => marks.push(letters(14 + [0, 0.27, 0.6][i] * room, y + 50, `${is ? "✓" : "✗"} ${text}`, "start", is ? "ink" : "faint")));
  return marks;
}

function findingOf({ size, different, again, mean, redundancy, hot, temperature, before }, t, name, length) {
  const head = `Step ${t + 1}, ${name} robot: `, T = given(+temperature.toFixed(2));
  if (size < length) return `${head}the queue has ${size} of ${length} places filled, and the rule waits`;
  const in_states = `${different} state${different > 1 ? "s" : ""} in ${size} steps`;
  if (hot) return `${head}${in_states}, and ${hundredths(mean)} a step: the temperature rises to ${T}`;
  const why = !again ? "its state is new" : mean >= 0 ? `it earns ${hundredths(mean)} a step` : `its redundancy is ${redundancy.toFixed(1)}`;
  return `${head}${why}, so the temperature ${before > temperature ? "falls back to" : "stays at"} ${T}`;
}

function saidOf({ size, mean, redundancy }, names, length) {
  const signs = [mean < 0 && "its mean is below 0", redundancy > 2 && "its redundancy is above 2"].filter(Boolean);
  const text = size < length ? "waits, too" : signs.length ? `shows a sign: ${signs.join(", and ")}` : "shows neither of the two signs";
  return "▲: the temperature rises. Shaded: the steps in the queue. Boxes: their states, the newest at the right; A is the present state. " +
    `The ${names[1]} robot ${text}. Both charts give small numbers more room.`;
}
