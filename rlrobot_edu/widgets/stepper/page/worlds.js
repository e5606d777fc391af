// The world of a tape as it was: a robot from above, a grid of cells, or a state by its inputs.

const WORDS = { S: "start", G: "goal", H: "hole", C: "cliff" };
const FILL = { G: "#009e73", H: "#7f7f7f", C: "#7f7f7f" };
const STEPS = { "↑": [0, -1], "→": [1, 0], "↓": [0, 1], "←": [-1, 0] };
const MOST_BINS = 12; // an input with more is written as a number
const CHIP = [0.36, 0.25]; // of a mark [m]; two lines of small letters fit into it

const worldHtml = (about, tape, most) => ({ robot: robotHtml, grid: gridHtml, state: stateHtml })[about.view.kind](about, tape, most);
const svgPoints = (xy) => xy.map(([x, y]) => `${+x.toFixed(3)},${+y.toFixed(3)}`).join(" ");
const polygonHtml = ([role, points], roles) =>
  `<polygon fill="${roles[role]}"${role === "goal" ? ' fill-opacity="0.45"' : ""} points="${svgPoints(points)}"/>`;

// Value of state s and all actions that are worth it; nothing where the agent never acted.
function bestIn(tape, s) {
  if (tape.visits[s].every((n) => n === 0)) return { value: null, best: [] };
  const value = Math.max(...tape.q[s]);
  return { value, best: count(tape.nActions).filter((a) => tape.q[s][a] === value) };
}

// The last scene and the way to it. y grows upwards in the scene and downwards in SVG.
function robotHtml({ view }, tape, most) {
  const looks = tape.looks(), { place, nose, moving, beams, box } = looks.at(-1), { roles, walls, marks } = view;
  const [xMin, yMin, xMax, yMax] = view.bounds, margin = 0.03 * Math.max(xMax - xMin, yMax - yMin);
  const line = ([x1, y1, x2, y2]) => `<line x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}"/>`;
  const length = marks ? 0.6 : 1; // of the line ahead: among marks it ends before the one there
  const heading = place ? line([place[0], place[1], ...[0, 1].map((i) => place[i] + length * (nose[i] - place[i]))])
    .replace("<line", '<line class="heading"') : "";
  const path = looks.filter((look) => look.place).map((look) => look.place);
  const says = `A room of ${(xMax - xMin).toFixed(1)} by ${(yMax - yMin).toFixed(1)} metres` + (place
    ? `, the robot at x = ${place[0].toFixed(1)}, y = ${place[1].toFixed(1)}, heading ${Math.round((place[2] * 180) / Math.PI)} degrees` : "");
  const between = marks ? '<path class="lines" d="M0,-1V1M-1,0H1"/>' : ""; // the four cells of the worked example
  const drawn = (solids) => solids.map((solid) => polygonHtml(solid, roles)).join("");
  const viewBox = [xMin - margin, -yMax - margin, xMax - xMin + 2 * margin, yMax - yMin + 2 * margin];
  return `<svg viewBox="${viewBox.map((x) => x.toFixed(3)).join(" ")}" role="img" aria-label="${says.replaceAll("-", "−")}.">` +
    `<g transform="scale(1,-1)">${drawn(walls.map((points) => ["wall", points]))}${between}` +
    `<polyline class="path" points="${svgPoints(path)}"/><g class="beams">${beams.map(line).join("")}</g>` +
    `${drawn(moving)}${heading}${litHtml(tape, (frame) => lookBefore(tape, frame)?.place)}</g>${marks ? marks[box].map((mark) => chipHtml(mark, tape, most)).join("") : ""}</svg>`;
}

// What the agent thinks of a place: the icons of the best actions there, above their value.
function chipHtml({ at: [x, y], s, icons }, tape, most) {
  const { value, best } = bestIn(tape, s), [wide, high] = CHIP;
  if (value === null) return "";
  const text = best.map((a) => icons[a]).join("");
  const rect = `<rect x="${(x - wide / 2).toFixed(3)}" y="${(-y - high / 2).toFixed(3)}" width="${wide}" height="${high}"`;
  const line = (down, words) => `<text x="${x.toFixed(2)}" y="${(-y + down).toFixed(2)}">${words}</text>`;
  return `<g class="chip"><title>state ${s}: ${text} ${short(value)}</title>${rect} fill="#fff"/>` +
    `${rect} fill="${tint(value, most)}"/>${line(-0.01, text)}${line(0.08, short(value))}</g>`;
}

// Cells, the agent and the way it came; a cell that was visited says the value of its best action.
function gridHtml({ view, names }, tape, most) {
  const looks = tape.looks(), [rows, columns] = view.shape, size = view.wide ? 0.26 : 0.21, cells = [];
  const centre = (s) => [(s % columns) + 0.5, Math.floor(s / columns) + 0.5];
  [...view.letters].forEach((letter, s) => {
    const column = s % columns, row = Math.floor(s / columns), { value, best } = bestIn(tape, s);
    const word = WORDS[letter] ?? "", worth = value === null ? "" : short(value);
    const says = `state ${s} ${word}${best.length ? `: ${worth}, best ${best.map((a) => names.actions[a]).join(", ")}` : ""}`;
    cells.push(`<rect x="${column}" y="${row}" width="1" height="1" ` +
      `fill="${letter in FILL ? `${FILL[letter]}70` : tint(value ?? 0, most)}"><title>${escaped(says)}</title></rect>` +
      `<text x="${column + 0.05}" y="${row + 0.06 + 0.8 * size}" font-size="${(0.8 * size).toFixed(3)}" class="faint">${s} ${word && letter}</text>`);
    if (value !== null) {
      cells.push(`<text x="${column + 0.5}" y="${(row + 0.7 + 0.4 * size).toFixed(3)}" font-size="${size}" class="v">${worth}</text>`);
    }
    if (!names.arrows) return;
    for (const a of best) { // a triangle points over the edge of the cell
      const [dx, dy] = STEPS[names.arrows[a]], [x, y] = centre(s);
      const corner = (ahead, aside) => [x + ahead * dx - aside * dy, y + ahead * dy + aside * dx];
      cells.push(`<polygon points="${svgPoints([corner(0.48, 0), corner(0.37, 0.11), corner(0.37, -0.11)])}"/>`);
    }
  });
  const [x, y] = centre(looks.at(-1));
  return `<svg class="cells" viewBox="-0.05 -0.05 ${columns + 0.1} ${rows + 0.1}" role="img" ` +
    `aria-label="A grid of ${rows} by ${columns} cells, the agent in cell ${looks.at(-1)}.">` +
    `<polyline class="path" points="${svgPoints(looks.map(centre))}"/>${cells.join("")}${litHtml(tape, ({ s }) => centre(s))}` +
    `<circle cx="${x}" cy="${y - 0.1}" r="0.22" stroke="${BLUE}" fill="${BLUE}" fill-opacity="0.2"/></svg>`;
}

// A strip of bins for each input, the present one filled, the one before framed.
function stateHtml({ names }, tape) {
  const looks = tape.looks(), s = looks.at(-1), now = binsOf(names, s), before = binsOf(names, looks.at(-2) ?? s);
  const reads = readingsOf(names, s);
  const row = (n, i) => {
    const bin = (k) => `<i class="${k === now[i] ? "now" : k === before[i] ? "was" : ""}"></i>`;
    const strip = n <= MOST_BINS ? count(n).map(bin).join("") : `${now[i]} of ${n}`;
    return `<tr><th>${escaped(names.inputs[i])}</th><td>${strip}</td><td>${escaped(reads[i])}</td></tr>`;
  };
  return `<p class="big">state ${s}</p><table class="bins">${names.shape.map(row).join("")}</table>`;
}
