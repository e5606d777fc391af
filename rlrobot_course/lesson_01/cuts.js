// The cut points under the readings of lasers: which bin each falls into, and what a robot can tell apart.

const LETTERS = ["A", "B", "C", "D", "E"];
const CENTIMETRES = (x) => `${x.toFixed(2)} m`;

const handle = {
  controls: ({ cuts, end }) => cuts.map((value, i) => (
    { name: `cut${i}`, kind: "slider", label: `Cut ${LETTERS[i]}`, min: 0, max: end, step: 0.01, value, text: CENTIMETRES })),

  compute({ readings, cuts, pair }, values) {
    const moved = cuts.map((_, i) => values[`cut${i}`]);
    const edges = [0, ...moved].sort((a, b) => a - b);
    const wasted = edges.slice(1).filter((edge, i) => edge === edges[i]).length;
    const bins = readings.map((x) => kernels.bin_of(x, moved)), n = moved.length + 1;
    return { moved, edges, bins, n, wasted, pair: pair.map((x) => kernels.bin_of(x, moved)),
      states: n ** readings.length, used: (n - wasted) ** readings.length };
  },

  draw({ moved, edges, bins, n, wasted, pair, states, used }, width, { names, readings, end, pair: places }) {
    const left = 14, right = width - 14, row = 50, top = 74, height = top + (names.length + 1) * row + 30;
    const x = (metres) => left + (Math.min(metres, end) / end) * (right - left), marks = [];
    const strip = (y) => edges.forEach((edge, i) => {
      const to = edges[i + 1] ?? end;
      marks.push(bar(x(edge), x(to) - x(edge), y, y + 22, i % 2 ? "line" : "floor"));
      if (i) marks.push(line(x(edge), y - 2, x(edge), y + 24, "ink", { "stroke-dasharray": "4 3", "stroke-width": 2 }));
    });
    strip(top - 8);
    marks.push(letters(left, top - 13, places.map((place, i) => `${place} m → bin ${pair[i]}`).join(", ")));
    for (const place of places) marks.push(mark("circle", { cx: x(place), cy: top + 3, r: 7, style: `fill:${ink("red")}` }));
    names.forEach((name, i) => {
      const y = top + (i + 1) * row + 14;
      strip(y);
      marks.push(letters(left, y - 5, `${name}: ${readings[i].toFixed(2)} m → bin ${bins[i]}`),
        bar(left, x(readings[i]) - left, y + 6, y + 16, "orange", { class: "reading" }));
    });
    moved.forEach((cut, i) => {
      marks.push(mark("g", { "data-grip": `cut${i}`, "data-from": left, "data-to": right, "aria-label": `Cut ${LETTERS[i]}` },
          mark("circle", { cx: x(cut), cy: 28, r: 15, style: `fill:${ink("blue")}` }) +
          letters(x(cut), 33, LETTERS[i], "middle", "on-blue", { class: "rl-large" })));
    });
    for (let metres = 0; metres <= end; metres += 0.5) {
      marks.push(letters(x(metres), height - 9, `${metres} m`, metres ? "middle" : "start", "faint"));
    }
    const [one, other] = places, apart = pair[0] !== pair[1];
    const finding = apart
      ? `${one} m is in bin ${pair[0]} and ${other} m in bin ${pair[1]}: the robot can tell them apart`
      : `${one} m and ${other} m are both in bin ${pair[0]}: the robot cannot tell them apart`;
    const count = `${moved.length} cuts make ${n} bins, and ${names.length} lasers ${n}${"⁰¹²³⁴⁵"[names.length]} = ${states} states. `;
    const waste = wasted
      ? `But ${wasted === 1 ? "1 bin has" : `${wasted} bins have`} no width and no reading falls into it: only ${used} states are left.`
      : "Dashed: the cuts. Orange: readings; a longer bar ends at the edge. Red: the two distances.";
    return { finding, height, picture: marks.join(""), said: count + waste };
  },
};
