// One number of the Q table at each visit: the targets as dots, and the value that goes the share α of the way to each.

const LAST = 1000; // steps, as in the lesson's figure
const ROUGH = 5, NEAR = 2; // from how much it leaps, and up to which distance it has arrived

const handle = {
  controls: ({ alpha }) => [{ name: "alpha", kind: "slider", label: "α", min: 0.01, max: 1, step: 0.01, value: alpha }],

  compute({ kinds, walk, states, actions, s: shown, a: acted, gamma }, { alpha }) {
    const m = { parameters: { alpha, gamma }, q: Array.from({ length: states }, () => Array(actions).fill(0)) };
    const visits = [];
    const ends = []; // the value after each of the last steps
    walk.forEach((kind, t) => {
      const [s, a, r, s_next, terminated] = kinds[kind], before = m.q[s][a];
      const target = before + kernels.update(m, s, a, r, s_next, null, terminated);
      if (s === shown && a === acted) visits.push({ target, value: m.q[s][a] });
      if (t >= walk.length - LAST) ends.push(m.q[shown][acted]);
    });
    const low = Math.min(...ends), high = Math.max(...ends);
    return { visits, low, high, mean: ends.reduce((sum, x) => sum + x, 0) / ends.length };
  },

  draw({ visits, low, high, mean }, width, { s, a, true: right, most }, { alpha }) {
    const left = 34, end = width - 14, height = 330, zero = height - 34, name = `Q(${s}, ${a})`;
    const x = (i) => left + (i / visits.length) * (end - left), y = (value) => zero - (value / most) * (zero - 24), marks = [];
    for (let value = 0; value <= most; value += 10) {
      marks.push(line(left, y(value), end, y(value), "line"), letters(left - 6, y(value) + 5, value, "end", "faint"));
    }
    visits.forEach(({ target }, i) => marks.push(mark("circle", { cx: x(i + 1).toFixed(1), cy: y(target).toFixed(1), r: 3, class: "target",
      style: `fill:${ink("orange")}` })));
    marks.push(line(left, y(right), end, y(right), "ink", { "stroke-dasharray": "3 4", "stroke-width": 2 }));
    const corners = [[x(0), y(0)]];
    visits.forEach(({ value }, i) => corners.push([x(i + 1), corners.at(-1)[1]], [x(i + 1), y(value)]));
    marks.push(way(corners, "blue", { "stroke-width": 2.5 }), letters(left + 4, y(right) - 7, `true value ${right.toFixed(1)}`, "start", "ink",
        { style: `fill:${ink("ink")};stroke:${ink("paper")};stroke-width:5;paint-order:stroke` }));
    for (const i of [0, 50, 100]) if (i < visits.length) marks.push(letters(x(i), height - 10, i, "middle", "faint"));
    marks.push(letters(end, height - 10, "visits", "end", "faint"));
    const leap = high - low, gap = mean - right;
    const finding = leap > ROUGH ? `With α = ${alpha}, ${name} never rests: at the end it leaps between ${low.toFixed(0)} and ${high.toFixed(0)}`
      : Math.abs(gap) > NEAR ? `With α = ${alpha}, ${name} is smooth, and ends ${Math.abs(gap).toFixed(0)} ${gap < 0 ? "below" : "above"} its true value`
        : `With α = ${alpha}, ${name} is smooth, and ends near its true value`;
    const said = `Blue: ${name} after each of ${visits.length} visits. Orange dots: their targets, which move as the table learns. ` +
      `Mean of its last ${LAST} steps: ${mean.toFixed(1)}.`;
    return { finding, height, picture: marks.join(""), said };
  },
};
