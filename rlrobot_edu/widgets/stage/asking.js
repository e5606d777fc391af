// The picture of the question: the similar states as ghosts, their ribbons, the arrow, and the step that was taken.

const APART = 0.58; // least distance of two robots that are drawn [m]
const HEAD = 0.3, RIM = 0.2; // of an arrow: its head to the walls around, its beginning to the robot's middle [m]
const WIDEST = { px: 24, part: 0.5 }; // a ribbon of say 1 at most, and all together, as a part of a metre
const TIMES = { ring: 1.5, ghosts: 0.45, ribbons: 1.25, arrow: 2, step: 4.4, end: 5.6 }; // [s] after the camera is there

const eased = (x) => { const part = Math.max(0, Math.min(1, x)); return part * part * (3 - 2 * part); };
const mixed = (from, to, part) => from + part * (to - from);

// Where each ghost is drawn: at its place, or as far beside it as it takes that none hides another, or the robot.
function fanned(places, robot, { bounds: [xMin, yMin, xMax, yMax] }) {
  const spots = places.map(([x, y]) => [x, y]);
  for (let turn = 0; turn < 200; turn++) {
    spots.forEach((spot, i) => {
      for (const [k, other] of [[-1, robot], ...spots.entries()]) {
        if (k === i) continue;
        const away = [spot[0] - other[0], spot[1] - other[1]], far = Math.hypot(...away);
        if (far >= APART) continue;
        const angle = far > 1e-6 ? Math.atan2(away[1], away[0]) : 2.4 * (i + 1), push = (APART - far) * (k < 0 ? 1 : 0.5);
        spot[0] += push * Math.cos(angle + 0.05);
        spot[1] += push * Math.sin(angle + 0.05);
      }
      spot[0] = Math.max(xMin + 0.3, Math.min(xMax - 0.3, spot[0]));
      spot[1] = Math.max(yMin + 0.3, Math.min(yMax - 0.3, spot[1]));
    });
  }
  return spots;
}

// A curve of ribbon from a ghost to the robot, by its three points; points along it, and a point's distance to it.
const along = ([a, b, c], p) => [0, 1].map((i) => (1 - p) ** 2 * a[i] + 2 * p * (1 - p) * b[i] + p * p * c[i]);
const distanceToCurve = (curve, [x, y]) => Math.min(...Array.from({ length: 21 }, (_, i) => {
  const [left, top] = along(curve, i / 20);
  return Math.hypot(left - x, top - y);
}));
function curveBetween(from, to, i) {
  const bend = i % 2 ? 0.18 : -0.18, [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  return [from, [from[0] + dx / 2 - dy * bend, from[1] + dy / 2 + dx * bend], to];
}

// All of a moment that does not depend on the time: places and sizes on the canvas. says: of each ghost, now
function laidOut(camera, world, moment, place, ghosts, says, narrow) {
  const spots = fanned(ghosts.map(({ at }) => at), place, world), foot = camera.at(place[0], place[1]);
  const all = sum(says, Math.abs), unit = Math.min(narrow ? 9 : WIDEST.px / 1.7, (WIDEST.part * camera.scale) / Math.max(all, 0.01));
  const drawn = ghosts.map((ghost, i) => {
    const spot = camera.at(spots[i][0], spots[i][1], BODY_HIGH);
    return {
      ...ghost, place: [...spots[i], ghost.at[2]], shift: [spots[i][0] - ghost.at[0], spots[i][1] - ghost.at[1]], spot,
      curve: curveBetween(camera.at(...spots[i]), foot, i), width: Math.abs(says[i]) * unit, say: says[i],
    };
  });
  const robot = camera.at(place[0], place[1], BODY_HIGH);
  return { robot, unit, total: sum(says, (say) => say), ghosts: drawn };
}

const speaks = ({ say }) => Math.abs(say) >= 0.05;

function drawRibbon(context, { curve, width, say, input }, grown, strength, colours) {
  const isAgainst = say < 0;
  context.globalAlpha = strength;
  context.lineCap = "butt";
  context.lineWidth = width;
  context.strokeStyle = isAgainst ? colours.red : colours[`input-${input + 1}`];
  context.setLineDash(isAgainst ? [4, Math.max(5, 0.9 * width)] : []);
  context.beginPath();
  for (let i = 0; i <= 30; i++) context[i ? "lineTo" : "moveTo"](...along(curve, (grown * i) / 30));
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}

// A ghost is paler than its ribbon, so that nobody takes it for another robot.
const ghostTone = (input, colours) => between(colours[`input-${input + 1}`], colours.floor, 0.5);

// Beside one of some ghosts stands who that is: where most room is for it. Tells both ends and the middle of these words. all: spots of all that is drawn
function drawWho(context, camera, ghosts, all, colours) {
  context.font = `650 14px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 4;
  context.strokeStyle = colours.floor;
  context.fillStyle = colours.ink;
  const far = 0.3 * camera.scale + 8, half = context.measureText("itself, minute 00").width / 2;
  const around = [[0, far + 4], [far + half, 0], [-far - half, 0], [0, -far - 2]];
  const spots = ghosts.flatMap(({ spot: [left, top], seen }) => around.map(([dx, dy]) => ({ at: [left + dx, top + dy], seen })));
  const ends = [-1, -0.5, 0, 0.5, 1].map((part) => part * half);
  const free = ({ at: [x, y] }) => Math.min(...ends.flatMap((dx) => all.map(([left, top]) => Math.hypot(left - x - dx, top - y))));
  const isIn = ({ at: [x] }) => x > camera.left + half && x < camera.left + camera.wide - half;
  const { at, seen } = mostBy(spots.filter(isIn), free);
  for (const how of ["strokeText", "fillText"]) context[how](`itself, minute ${Math.floor(seen / 60)}`, ...at);
  return [-half, 0, half].map((dx) => [at[0] + dx, at[1]]);
}

// A ghost that had to step aside is tied to where it was.
function drawTie(context, camera, { at, shift, place, input }, colours) {
  if (Math.hypot(...shift) < 0.1) return;
  const [left, top] = camera.at(at[0], at[1]);
  context.strokeStyle = context.fillStyle = colours[`input-${input + 1}`];
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(...camera.at(place[0], place[1]));
  context.lineTo(left, top);
  context.stroke();
  context.beginPath();
  context.arc(left, top, 3, 0, 7);
  context.fill();
}

// The arrow of a motion from a place, as wide as what the ribbons bring; tells its tip.
// It ends where the room ends.
function drawArrow(context, camera, place, motion, { total, unit }, grown, strength, colours, narrow, [xMin, yMin, xMax, yMax]) {
  const [x, y, heading] = place, cos = Math.cos(heading), sin = Math.sin(heading);
  if (!motion.path.length) return null;
  const spots = motion.path.map(([a, b]) => [x + a * cos - b * sin, y + a * sin + b * cos]);
  const out = spots.findIndex(([a, b], i) => i > 4 && (a < xMin + HEAD || a > xMax - HEAD || b < yMin + HEAD || b > yMax - HEAD));
  const until = out < 0 ? spots.length : out, rim = spots.findIndex(([a, b]) => Math.hypot(a - x, b - y) > RIM);
  const first = rim < 0 ? 0 : Math.max(0, Math.min(rim, until - 4)); // it begins at the robot's rim, if there is room
  const path = spots.slice(first, until).map(([a, b]) => camera.at(a, b));
  const shown = path.slice(0, Math.max(4, Math.round(path.length * grown))), tip = shown.at(-1), before = shown.at(-4);
  const most = (motion.v ? 0.26 : 0.13) * camera.scale, wide = Math.max(3, Math.min(most, Math.abs(total) * unit));
  const turn = Math.atan2(tip[1] - before[1], tip[0] - before[0]), head = Math.max(narrow ? 10 : 13, Math.min(0.95 * wide, 0.17 * camera.scale));
  context.globalAlpha = strength;
  context.strokeStyle = context.fillStyle = total < 0 ? colours.red : colours.ink;
  context.lineWidth = wide;
  context.lineCap = "butt";
  context.lineJoin = "round";
  context.beginPath();
  shown.forEach((spot, i) => context[i ? "lineTo" : "moveTo"](...spot));
  context.stroke();
  fill(context, [0, 2.1, -2.1].map((angle) => [tip[0] + head * Math.cos(turn + angle), tip[1] + head * Math.sin(turn + angle)]),
    context.strokeStyle);
  context.globalAlpha = 1;
  return tip;
}

function drawRing(context, [left, top], camera, part, colours) {
  context.globalAlpha = 1 - part;
  context.strokeStyle = colours.blue;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(left, top, (0.35 + 0.9 * part) * camera.scale, 0, 7);
  context.stroke();
  context.globalAlpha = 1;
}
