// A value that runs back along a corridor: bars are cells, and each drive carries what was found one cell further.

const handle = {
  controls: ({ drives, opens, alpha, gamma }) => [
    { name: "drive", kind: "scrubber", label: "drives", last: drives, value: opens },
    { name: "alpha", kind: "slider", label: "α", min: 0.05, max: 1, step: 0.05, value: alpha },
    { name: "gamma", kind: "slider", label: "γ", min: 0, max: 0.95, step: 0.05, value: gamma },
  ],

  compute({ cells, reward, drives }, { alpha, gamma, drive }) {
    const m = { parameters: { alpha, gamma }, q: Array.from({ length: cells + 1 }, () => [0]) };
    const after = [m.q.map(([value]) => value)];
    for (let k = 0; k < drives; k += 1) {
      for (let s = 0; s < cells; s += 1) {
        const ends = s === cells - 1;
        kernels.update(m, s, 0, ends ? reward : 0, s + 1, null, ends);
      }
      after.push(m.q.map(([value]) => value));
    }
    const limit = Array.from({ length: cells }, (_, s) => reward * gamma ** (cells - 1 - s));
    const values = after[drive].slice(0, cells), known = values.filter((value) => value > 0).length;
    const half = limit[0] > 0 ? after.findIndex((each) => each[0] >= limit[0] / 2) : -1;
    const first = after.findIndex((each) => each[0] > 0);
    return { values, limit, known, half, first };
  },

  draw({ values, limit, known, half, first }, width, { cells, reward, drives }, { drive, gamma }) {
    const left = 30, right = width - 10, height = 290, zero = height - 56, wide = (right - left) / cells, marks = [];
    const y = (value) => zero - (value / reward) * (zero - 26);
    for (const value of [0, reward / 2, reward]) {
      marks.push(line(left, y(value), right, y(value), "line"), letters(left - 6, y(value) + 5, value, "end", "faint"));
    }
    values.forEach((value, s) => {
      const x = left + s * wide + 3, middle = x + wide / 2 - 3;
      marks.push(bar(x, wide - 6, zero, y(limit[s]), "floor", { stroke: "currentColor", "stroke-dasharray": "3 3", "stroke-opacity": 0.6 }),
        bar(x, wide - 6, zero, y(value), "blue"), letters(middle, zero + 18, s, "middle", "faint"));
      if (value > 0) marks.push(letters(middle, y(value) - 5, value < 0.05 ? "≈0" : value.toFixed(1), "middle"));
    });
    marks.push(letters(left, height - 12, "cell", "start", "faint"), letters(right, height - 12, `goal: ${reward} →`, "end", "green"));
    const times = drive === 1 ? "1 drive" : `${drive} drives`;
    const cell = known === 1 ? "only the last cell knows" : `${known} of ${cells} cells know`;
    const finding = gamma === 0 ? `With γ = 0, ${drive ? "only the last cell ever learns" : "no cell but the last will ever learn"} of the reward`
      : drive === 0 ? "Before the first drive, no cell knows of the reward"
        : known < cells ? `After ${times}, ${cell} of the reward` : `After ${times}, the value has run back to cell 0`;
    const reached = half < 0 ? `not within ${drives} drives` : `after ${half} drives`;
    const said = "Blue: Q of going on, in each cell. Dashed: what it comes to. " +
      (first < 0 ? "Cell 0 never knows of the reward." : `Cell 0 first knows of the reward after ${first} drives; it has half of its value ${reached}.`);
    return { finding, height, picture: marks.join(""), said };
  },
};
