// The cells of the trace lab: a bar for the trace, a bar for Q with the ideal's as a frame, and the numbers. Below them
// a curve: how the trace, or Q, of the cell that is left most often goes over the steps.

const EDGE = 6, NAME = 20, LINE = 16; // of a picture, of a cell's first line, of a line of letters [px]
const BARS = 50, CURVE = 64; // heights of the bars and of the curve [px]
const WIDE = 120; // a cell that has room for two numbers side by side [px]; in a narrower one they stand below each other
const SMALL = "font-size:11px";

function grid(found, width, feed, values) {
  const { path, step } = values, { rows, columns, cells } = feed;
  const wide = (width - 2 * EDGE) / columns, lines = (wide > WIDE ? 1 : 2) + (feed.againstIdeal ? 1 : 0), high = NAME + BARS + lines * LINE + 14;
  const corner = (cell) => [EDGE + (cell % columns) * wide, EDGE + Math.floor(cell / columns) * high];
  const middle = (cell) => corner(cell).map((x, i) => x + (i ? high : wide) / 2);
  const scale = scaleOf(found), left = step ? path[step - 1] : path[0], marks = [];
  for (let cell = 0; cell < cells.length; cell++) {
    const [x, y] = corner(cell);
    marks.push(mark("rect", { x: x + 2, y: y + 2, width: wide - 4, height: high - 4, rx: 6, style: `fill:${ink("back")};stroke:${ink("line")}` }));
  }
  const band = { "stroke-width": 14, "stroke-linejoin": "round", "stroke-linecap": "round" };
  if (path.length) marks.push(way(path.map(middle), "line", { ...band, opacity: 0.55 }), way(path.slice(0, step + 1).map(middle), "line", band));
  for (let cell = 0; cell < cells.length; cell++) marks.push(content(cell, corner(cell), wide, scale, found, feed, values));
  if (left !== undefined) {
    const [x, y] = corner(left), frame = { "stroke-width": 3, style: `fill:none;stroke:${ink("blue")}` };
    marks.push(mark("rect", { x: x + 2, y: y + 2, width: wide - 4, height: high - 4, rx: 6, ...frame }));
    if (step) marks.push(robot(middle(left), middle(path[step])));
  }
  for (let cell = 0; cell < cells.length; cell++) {
    const [x, y] = corner(cell), place = { x: x + 2, y: y + 2, width: wide - 4, height: high - 4, rx: 6 };
    marks.push(mark("rect", { ...place, "data-pick": cells[cell], role: "button", "aria-label": heard(cell, found, feed, step), style: "fill:transparent" }));
  }
  const height = 2 * EDGE + rows * high;
  if (path.length < 2) return { height, picture: marks.join("") };
  return { height: height + CURVE + 50, picture: marks.join("") + curve(found, height + 30, width, feed, values) };
}

// Of all steps, so that bars of two steps can be compared; traces of all kinds, so that kinds can be, too.
function scaleOf({ q, ideal, largestTrace }) {
  const all = [0, ...q.flat(), ...(ideal ?? []).flat()], low = Math.min(...all), high = Math.max(...all);
  const size = high - low || 1;
  return { trace: (e) => BARS * e / largestTrace, worth: (x) => BARS * (high - x) / size };
}

function content(cell, [x, y], wide, scale, found, feed, { step, alpha }) {
  const { visits, ideal } = found, { cells, pays } = feed, top = y + NAME + 4, bottom = top + BARS;
  const e = found.e[step][cell], q = found.q[step][cell], ghost = ideal?.[step][cell], marks = [];
  marks.push(letters(x + 9, y + 18, cells[cell], "start", "ink", { class: "rl-large" }));
  const isWide = wide > WIDE, small = (colour) => (isWide ? {} : { style: `fill:${ink(colour)};${SMALL}` });
  if (visits[cell] > 1) marks.push(letters(x + (isWide ? 24 : 21), y + 18, `×${visits[cell]}`, "start", "faint", small("faint")));
  const paid = pays[cell] > 0 ? `+${pays[cell]}` : tidy(String(pays[cell])), colour = pays[cell] > 0 ? "green" : "red";
  const look = isWide ? { class: "rl-large" } : small(colour);
  if (pays[cell]) marks.push(letters(x + wide - 8, y + 18, paid, "end", colour, look));
  if (!visits[cell]) return marks.join("");
  const bars = Math.min(wide * 0.3, 44), first = x + wide * 0.27 - bars / 2, second = x + wide * 0.73 - bars / 2;
  marks.push(bar(first, bars, bottom, bottom - scale.trace(e), "orange", { rx: 2 }));
  const limit = feed.againstIdeal ? 1 / alpha : 1; // where a step would overshoot; else where replacing traces begin
  if (scale.trace(limit) <= BARS) marks.push(line(first - 4, bottom - scale.trace(limit), first + bars + 4, bottom - scale.trace(limit), "ink", { "stroke-dasharray": "3 3" }));
  const zero = top + scale.worth(0);
  marks.push(bar(second, bars, zero, top + scale.worth(q), q < 0 ? "red" : "blue", { rx: 2 }), line(second - 5, zero, second + bars + 5, zero, "faint"));
  if (ghost !== undefined) {
    const frame = { "stroke-width": 2, "stroke-dasharray": "4 3", style: `fill:none;stroke:${ink("ink")}` };
    marks.push(bar(second - 4, bars + 8, zero, top + scale.worth(ghost), "ink", frame));
    const below = bottom + (isWide ? 2 : 3) * LINE;
    if (Math.abs(ghost - q) >= SEEN) marks.push(letters(x + wide - 8, below, `ideal ${amount(ghost)}`, "end", "ink", small("ink")));
  }
  const trace = `e = ${amount(e)}`, worth = `Q = ${amount(q)}`;
  if (isWide) marks.push(letters(x + wide * 0.27, bottom + LINE, trace, "middle"), letters(x + wide * 0.73, bottom + LINE, worth, "middle"));
  else marks.push(...[trace, worth].map((text, i) => letters(x + wide - 8, bottom + (i + 1) * LINE, text, "end", "ink", small("ink"))));
  return marks.join("");
}

// On the border between two cells, pointing to the second; in the middle of its cell if it stays there.
function robot([x1, y1], [x2, y2]) {
  if (x1 === x2 && y1 === y2) return letters(x1, y1, "↻", "middle", "blue", { class: "rl-large" });
  const angle = Math.atan2(y2 - y1, x2 - x1) * 180 / Math.PI, place = `translate(${(x1 + x2) / 2} ${(y1 + y2) / 2}) rotate(${angle})`;
  return mark("path", { d: "M-10 -11L13 0L-10 11Z", transform: place, style: `fill:${ink("blue")};stroke:${ink("paper")}`, "stroke-width": 2 });
}

function heard(cell, { e, q, visits }, { cells, pays }, step) {
  const paid = pays[cell] ? `, pays ${pays[cell]}` : "";
  return visits[cell] ? `${cells[cell]}${paid}, trace ${amount(e[step][cell])}, Q ${amount(q[step][cell])}` : `${cells[cell]}${paid}`;
}

// Over the steps: Q of the watched cell with the ideal's as a broad band, or in lesson 07 its trace.
function curve({ e, q, ideal, watched, largestTrace }, top, width, { cells }, { path, step }) {
  const shown = ideal ? q : e, of = (table) => table.map((row) => row[watched]), values = of(shown), ghost = ideal ? of(ideal) : [];
  const low = Math.min(0, ...values, ...ghost), high = Math.max(...(ideal ? [0, ...values, ...ghost] : [largestTrace]));
  const left = 62, right = width - 16, foot = top + CURVE;
  const x = (t) => left + (right - left) * t / stepsOf(path), y = (value) => foot - CURVE * (value - low) / (high - low || 1);
  const points = (numbers) => numbers.map((value, t) => [x(t), y(value)]), marks = [];
  marks.push(letters(EDGE + 2, top - 12, `${ideal ? "Q" : "e"}(${cells[watched]}) at each step`, "start", "ink"), line(left, y(0), right, y(0), "faint"));
  for (const value of new Set([low, high])) if (value) marks.push(letters(left - 8, y(value) + 5, amount(value), "end", "faint"));
  if (Math.abs(y(0) - y(high)) > LINE || !high) marks.push(letters(left - 8, y(0) + 5, "0", "end", "faint"));
  if (ideal) marks.push(way(points(ghost), "grey", { "stroke-width": 9, opacity: 0.4, "stroke-linejoin": "round" }));
  const style = `fill:${ink(ideal ? "blue" : "orange")}`;
  marks.push(way(points(values), ideal ? "blue" : "orange", { "stroke-width": 2.5 }));
  for (const [cx, cy] of points(values)) marks.push(mark("circle", { cx, cy, r: 3, style }));
  path.slice(0, -1).forEach((cell, i) => cell === watched && marks.push(line(x(i + 1), foot + 4, x(i + 1), foot + 10, "ink", { "stroke-width": 2 })));
  marks.push(line(x(step), top - 4, x(step), foot + 4, "faint", { "stroke-dasharray": "3 3" }));
  return marks.join("") + mark("circle", { cx: x(step), cy: y(values[step]), r: 6, style: `${style};stroke:${ink("ink")}` });
}
