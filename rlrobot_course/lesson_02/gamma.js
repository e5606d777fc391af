// What γ leaves of each reward: grey bars are the rewards of a policy, blue is what counts of each in the return.

const SHOWN = 30; // rewards that are drawn; the return has them all

const handle = {
  controls: ({ gamma }) => [
    { name: "gamma", kind: "slider", label: "γ", min: 0, max: 0.99, step: 0.01, value: gamma },
  ],

  compute({ rewards }, { gamma }) {
    const returns = rewards.map((each) => kernels.discounted(each, gamma));
    const horizon = 1 / (1 - gamma);
    return { returns, horizon, parts: rewards.map((each) => each.slice(0, SHOWN).map((r, k) => r * gamma ** k)) };
  },

  draw({ returns, horizon, parts }, width, { names, rewards }, { gamma }) {
    const apart = Math.abs(returns[0] - returns[1]), left = 36, right = width - 12, row = 130;
    const wide = (right - left) / SHOWN, marks = [];
    names.forEach((name, i) => {
      const zero = 34 + i * (row + 34) + 90, y = (r) => zero - r * 8;
      marks.push(letters(left, zero - 98, `${name}: G = ${tidy(returns[i].toFixed(2))}`, "start", "ink", { class: "rl-large" }));
      rewards[i].slice(0, SHOWN).forEach((r, k) => marks.push(bar(left + k * wide + 1, wide - 2, zero, y(r), "line")));
      parts[i].forEach((r, k) => marks.push(bar(left + k * wide + 1, wide - 2, zero, y(r), "blue")));
      marks.push(line(left, zero, right, zero, "faint"), letters(left - 6, y(10) + 5, "10", "end", "faint"), letters(left - 6, zero + 5, "0", "end", "faint"));
    });
    const height = 34 + names.length * (row + 34) + 8, reach = left + Math.min(horizon, SHOWN) * wide;
    marks.push(line(reach, 44, reach, height - 26, "red", { "stroke-dasharray": "5 4", "stroke-width": 2 }));
    for (const k of [0, 10, 20]) marks.push(letters(left + (k + 0.5) * wide, height - 8, k, "middle", "faint"));
    marks.push(letters(right, height - 8, width > 400 ? "steps ahead, k" : "k", "end", "faint"));
    const finding = apart < 0.1
      ? `With γ = ${gamma}, nothing tells the two apart: their returns differ by ${tidy(apart.toFixed(2))}`
      : `With γ = ${gamma}, “${names[returns[0] > returns[1] ? 0 : 1]}” is worth ${tidy(apart.toFixed(apart < 10 ? 2 : 0))} more`;
    const said = "Grey: the rewards. Blue: what counts of each in the return G. " +
      `Dashed: about 1 / (1 − γ) = ${Math.round(horizon)} steps ahead, as far as a robot with this γ looks.`;
    return { finding, height, picture: marks.join(""), said };
  },
};
