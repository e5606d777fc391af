// The world of a tape as it was: a robot from above, or a state by its inputs.

const MOST_BINS = 12; // an input with more is written as a number
const CHIP = [0.3, 0.25]; // of a mark [m]; two lines of small letters fit into it
const AMONG_MARKS = 0.6; // size of a robot that is drawn between marks, so that none lies on it

const worldHtml = (about, tape, most) => ({ robot: robotHtml, state: stateHtml })[about.view.kind](about, tape, most);

// Value of state s and all actions that are worth it; nothing where the agent never acted.
function bestIn(tape, s) {
  if (tape.visits[s].every((n) => n === 0)) return { value: null, best: [] };
  const value = Math.max(...tape.q[s]);
  return { value, best: count(tape.nActions).filter((a) => tape.q[s][a] === value) };
}

// The way that is drawn: places, each with the reward of the step to it.
function trailOf(tape) {
  if (tape.t === 0) return [];
  const latest = tape.latest(PATH), begun = Math.max(0, latest.findLastIndex(({ n }) => n === 1)), seen = latest.slice(begun);
  const before = lookBefore(tape, seen[0])?.place;
  const to = seen.filter(({ look }) => look?.place).map(({ look, r }) => [look.place[0], look.place[1], r]);
  return before ? [[before[0], before[1], null], ...to] : to;
}

// The last scene and the way to it: a canvas, which paintRooms fills, and on it the values of places and where it was paid.
// y grows upwards in the scene and downwards in SVG.
function robotHtml({ view, names, nActions, rooms = [] }, tape, most) {
  const look = tape.looks().at(-1), { place, box } = look, { marks, near, loss, scene: still } = view;
  const [xMin, yMin, xMax, yMax] = still.bounds, margin = ROOM_MARGIN * Math.max(xMax - xMin, yMax - yMin);
  const size = marks ? AMONG_MARKS : 1, outline = still.outline?.map(([x, y]) => [size * x, size * y]);
  const says = `A room of ${(xMax - xMin).toFixed(1)} by ${(yMax - yMin).toFixed(1)} metres` + (place
    ? `, the robot at x = ${place[0].toFixed(1)}, y = ${place[1].toFixed(1)}, heading ${Math.round((place[2] * 180) / Math.PI)} degrees` : "");
  const isBump = bumped(view, tape.frame), word = marks ? "" : "bump!", trail = trailOf(tape);
  rooms.push([{ ...still, ...look, outline }, { trail, loss, near, isBump, word }]);
  const between = marks ? '<path class="lines" d="M0,-1V1M-1,0H1"/>' : ""; // the four cells of the worked example
  const viewBox = [xMin - margin, -yMax - margin, xMax - xMin + 2 * margin, yMax - yMin + 2 * margin].map((x) => x.toFixed(3));
  const lit = litHtml(tape, (frame) => lookBefore(tape, frame)?.place);
  const chips = marks ? marks[box].map((mark) => chipHtml(mark, tape, most)).join("") : "";
  const before = tape.frame && lookBefore(tape, tape.frame)?.place;
  const ghost = before && place && Math.hypot(before[0] - place[0], before[1] - place[1]) > 0.02 ? ghostSvg(before, outline) : "";
  return `<div class="room" role="img" aria-label="${says.replaceAll("-", "−")}." style="aspect-ratio:${viewBox[2]} / ${viewBox[3]}">` +
    `<canvas data-room="${rooms.length - 1}"></canvas><svg viewBox="${viewBox.join(" ")}" aria-hidden="true">` +
    `<g transform="scale(1,-1)">${between}${ghost}${lit}</g>${chips}</svg>` +
    `${chips.includes("its") ? "" : changeHtml({ names, nActions }, tape, before && placeIn(viewBox, before))}</div>`;
}

// Where the robot was before a step that moved it: its outline, dashed.
function ghostSvg([x, y, heading], outline) {
  const cos = Math.cos(heading), sin = Math.sin(heading);
  const at = outline.map(([a, b]) => `${(x + a * cos - b * sin).toFixed(3)},${(y + a * sin + b * cos).toFixed(3)}`);
  return `<path class="ghost" d="M${at.join("L")}Z"/>`;
}

// A place in a picture, as parts of its width and its height.
const placeIn = ([left, top, wide, high], [x, y]) => [(x - left) / wide, (-y - top) / high];

// What the step has changed, beside the place where the robot was, and inside the picture; without a place in a corner.
function changeHtml({ names, nActions }, { frame }, at) {
  if (!frame) return "";
  const [was, now] = valuesOf(nActions, frame), written = writerFor(was, now);
  const value = was === now ? `stays ${written(now)}` : `${written(was)} → <b>${written(now)}</b> ${arrow(was, now)}`;
  const side = at ? ["left", "middle", "right"][Math.min(2, Math.floor(3 * at[0]))] : "corner";
  const style = at ? ` style="left:${(100 * at[0]).toFixed(1)}%;top:${(100 * at[1]).toFixed(1)}%"` : "";
  return `<p class="change ${side}${at && at[1] > 0.6 ? " above" : ""}"${style}>${escaped(quoted(names, frame.a))}: <nobr>${value}</nobr></p>`;
}

// Whether a robot that drives has bumped in this step: then it lost much.
const bumped = ({ loss = null }, frame) => Boolean(frame?.look?.place) && loss !== null && frame.r <= loss;

// Fill the canvases of an element.
function paintRooms(element, rooms) {
  for (const canvas of element.querySelectorAll("canvas[data-room]")) {
    if (!canvas.clientWidth) continue; // it is hidden
    const [scene, options] = rooms[canvas.dataset.room];
    drawRoom(canvas, scene, options);
  }
}

// What the agent thinks of a place: the icons of the best actions there, above their value. Where the step has changed a
// value, that one is told: what was done, its old value struck out (or by how much, where both look the same), and the new one.
function chipHtml({ at: [x, y], s, icons }, tape, most) {
  const { value: highest, best } = bestIn(tape, s), { frame, nActions } = tape, isIts = frame?.s === s, [wide, high] = CHIP;
  if (highest === null) return "";
  const [was, now] = isIts ? valuesOf(nActions, frame) : [highest, highest], isNew = was !== now, value = isIts ? now : highest;
  const text = isIts ? icons[frame.a] : best.map((a) => icons[a]).join("");
  const rect = `<rect x="${(x - wide / 2).toFixed(3)}" y="${(-y - high / 2).toFixed(3)}" width="${wide}" height="${high}" rx="0.03"`;
  const line = (down, words) => `<text x="${x.toFixed(2)}" y="${(-y + down).toFixed(2)}">${words}</text>`;
  const kind = short(was) === short(now) ? "by" : "old", before = beforeIt(was, now).replace(" → ", "");
  const first = isNew ? `${text} <tspan class="${kind}">${before}</tspan>` : text;
  return `<g class="chip${isIts ? " its" : ""}"><title>state ${s}: ${text} ${short(value)}</title>${rect} class="under"/>` +
    `${rect} fill="${tint(value, most)}"/>${line(-0.02, first)}${line(0.08, (isNew ? `${arrow(was, now)} ` : "") + short(value))}</g>`;
}

// A strip of bins for each input, the present one filled, the one before framed.
function stateHtml({ names, nActions }, tape) {
  const looks = tape.looks(), s = looks.at(-1), now = binsOf(names, s), before = binsOf(names, looks.at(-2) ?? s);
  const reads = readingsOf(names, s);
  const row = (n, i) => {
    const bin = (k) => `<i class="${k === now[i] ? "now" : k === before[i] ? "was" : ""}"></i>`;
    const strip = n <= MOST_BINS ? count(n).map(bin).join("") : `${now[i]} of ${n}`;
    return `<tr><th>${escaped(names.inputs[i])}</th><td>${strip}</td><td>${escaped(reads[i])}</td></tr>`;
  };
  return `<p class="big">state ${s}</p><table class="bins">${names.shape.map(row).join("")}</table>` +
    changeHtml({ names, nActions }, tape, null);
}
