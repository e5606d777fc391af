// Values that spread over a frozen lake, sweep by sweep; the formula of the square that is chosen has its numbers below.

const ARROWS = ["←", "↓", "→", "↑"]; // the lake's actions
const shortly = (v) => (v ? v.toFixed(2).replace(/^0/, "") : "");

const handle = {
  controls: ({ values, opens }) => [
    { name: "sweep", kind: "scrubber", label: "sweep", last: values.length - 1, value: opens },
  ],
  begins: ({ square }) => ({ square }),

  compute({ values, follows, gamma }, { sweep, square }) {
    const v = values[sweep], before = values[Math.max(sweep - 1, 0)];
    const sums = follows[square].map(([after, r, ends]) => kernels.one_sum(before, after, r, ends, gamma));
    return { v, before, sums, known: v.filter((x) => x).length, fresh: v.map((x, s) => sweep > 0 && x !== before[s]) };
  },

  draw({ v, before, sums, known, fresh }, width, { desc, follows, gamma }, { sweep, square }) {
    const wide = width > 640, columns = desc[0].length, edge = 8;
    const size = Math.min(wide ? 400 : 380, width - 2 * edge) / columns, marks = [];
    desc.join("").split("").forEach((kind, s) => {
      const x = edge + (s % columns) * size, y = edge + Math.floor(s / columns) * size;
      const shade = mark("rect", { x, y, width: size, height: size, style: `fill:${ink("floor")};stroke:${ink("line")}` }) +
        mark("rect", { x, y, width: size, height: size, style: `fill:${ink("green")}`, "fill-opacity": v[s] });
      const hatch = [1 / 3, 2 / 3, 1].map((part) => line(x, y + part * size, x + part * size, y, "grey")).join("") +
        [1 / 3, 2 / 3].map((part) => line(x + part * size, y + size, x + size, y + part * size, "grey")).join("");
      const sign = v[s] ? shortly(v[s]) : "SG".includes(kind) ? kind : "";
      const ring = fresh[s] && mark("rect", { x: x + 2, y: y + 2, width: size - 4, height: size - 4, class: "fresh",
        style: `fill:none;stroke:${ink("ink")}`, "stroke-dasharray": "3 3" });
      marks.push(mark("g", { "data-pick": s, role: "button", "aria-label": `square ${s}: ${v[s].toFixed(2)}` }, shade +
        (kind === "H" ? hatch : "") + (ring || "") +
        letters(x + size / 2, y + size / 2 + 5, sign, "middle", v[s] > 0.6 ? "on-blue" : "ink")));
    });
    const at = { x: edge + (square % columns) * size, y: edge + Math.floor(square / columns) * size };
    marks.push(mark("rect", { ...at, width: size, height: size, style: `fill:none;stroke:${ink("blue")}`, "stroke-width": 4 }));
    const map = columns * size + 2 * edge, x = wide ? map + 16 : edge + 4, ends = "HG".includes(desc.join("")[square]);
    let y = wide ? 34 : map + 22;
    const write = (text, more) => { marks.push(letters(x, y, text, "start", "ink", more)); y += 26; };
    write(`Square ${square}`, { class: "rl-large" });
    if (ends) write("The walk is over here: V stays 0.");
    else if (!sweep) write("Before the first sweep V is 0.");
    else {
      const most = Math.max(...sums), best = sums.indexOf(most);
      follows[square].forEach(([after, r, over], a) => write(`${ARROWS[a]} to ${after}: ${over
        ? `${r}, nothing follows` : `${r} + ${gamma} · ${before[after].toFixed(2)} = ${sums[a].toFixed(2)}`}${a === best ? "  ✓" : ""}`));
      write(`V(${square}) = max [${sums.map((sum) => +sum.toFixed(2)).join(", ")}] = ${+v[square].toFixed(2)}`);
    }
    const changed = fresh.filter((each) => each).length, start = v[desc.join("").indexOf("S")];
    const finding = !sweep ? "Before the first sweep V is 0 in all squares"
      : !changed ? `Sweep ${sweep} changes nothing any more`
        : start ? `After sweep ${sweep} the value has reached S: ${start.toFixed(2)}`
          : `After sweep ${sweep}, ${known} of ${v.length} squares have a value, ${changed} of them new`;
    const said = "Green and numbers: V(s). Dashed: changed in this sweep. Hatched: holes. Press a square to see how it got its value" +
      " from the values before this sweep.";
    return { finding, height: wide ? map : y + 4, picture: marks.join(""), said };
  },

  picked: (feed, values, name) => ({ square: +name }),
};
