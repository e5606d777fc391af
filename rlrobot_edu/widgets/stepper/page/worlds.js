// The world of a tape as it was: a robot from above, or a state by its inputs.

const MOST_BINS = 12; // an input with more is written as a number
const CHIP = [0.3, 0.25]; // of a mark [m]; two lines of small letters fit into it
const AMONG_MARKS = 0.6; // size of a robot that is drawn between marks, so that none lies on it

const worldHtml = (about, tape, most) => ({ robot: robotHtml, state: stateHtml })[about.view.kind](about, tape, most);
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
  const size = marks ? AMONG_MARKS : 1;
  const shrunk = ([x, y]) => (place ? [place[0] + size * (x - place[0]), place[1] + size * (y - place[1])] : [x, y]);
  const body = moving.map(([role, points]) => [role, role === "robot" ? points.map(shrunk) : points]);
  const heading = place ? line([place[0], place[1], ...shrunk(nose)]).replace("<line", '<line class="heading"') : "";
  const path = looks.filter((look) => look.place).map((look) => look.place);
  const says = `A room of ${(xMax - xMin).toFixed(1)} by ${(yMax - yMin).toFixed(1)} metres` + (place
    ? `, the robot at x = ${place[0].toFixed(1)}, y = ${place[1].toFixed(1)}, heading ${Math.round((place[2] * 180) / Math.PI)} degrees` : "");
  const between = marks ? '<path class="lines" d="M0,-1V1M-1,0H1"/>' : ""; // the four cells of the worked example
  const drawn = (solids) => solids.map((solid) => polygonHtml(solid, roles)).join("");
  const viewBox = [xMin - margin, -yMax - margin, xMax - xMin + 2 * margin, yMax - yMin + 2 * margin];
  return `<svg viewBox="${viewBox.map((x) => x.toFixed(3)).join(" ")}" role="img" aria-label="${says.replaceAll("-", "−")}.">` +
    `<g transform="scale(1,-1)">${drawn(walls.map((points) => ["wall", points]))}${between}` +
    `<polyline class="path" points="${svgPoints(path)}"/><g class="beams">${beams.map(line).join("")}</g>` +
    `${drawn(body)}${heading}${litHtml(tape, (frame) => lookBefore(tape, frame)?.place)}</g>${marks ? marks[box].map((mark) => chipHtml(mark, tape, most)).join("") : ""}</svg>`;
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
