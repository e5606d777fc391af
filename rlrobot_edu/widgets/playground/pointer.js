// Hands: what a mouse, a finger or a key does to walls and robot, and the floor that is pointed at.

const ROBOT = -2, NOTHING = -1; // what may be chosen besides a wall's number
const NEAR = 0.08; // how near to a wall one must be to take it [m]
let chosen = NOTHING, held = null, isDrawing = false, pointed = null;

const inside = () => walls ?? (yours.world.walls ? wallsInside(yours.world) : []);
const wallAt = (x, y) => inside().findIndex((wall) => distanceTo(wall, x, y) < NEAR);
const isRobotAt = (x, y) => Boolean(yours.floor) && Math.hypot(x - yours.here[0], y - yours.here[1]) < yours.world.radius;
const at = (event) => {
  const box = picture.getBoundingClientRect();
  return view.from(event.clientX - box.left, event.clientY - box.top);
};

// Whether a wall may stand there: not on a robot, nor where it starts.
const mayStand = (wall) => [yours.world.start, ...runs().map((run) => run.here)].every(
  ([x, y]) => distanceTo(wall, x, y) > yours.world.radius);

// Other walls in the room, from now on.
function setWalls(list) {
  walls = list;
  for (const { world } of runs()) {
    const own = about.worlds[settings.task];
    world.build(list ? allWalls(own, list) : own.walls);
    world.readings = world.sense(world.place);
  }
  keepLink();
  changed();
}

// A wall elsewhere; false, and nothing has changed, if a robot is in its way.
function placeWall(i, wall) {
  const moved = intoRoom(yours.world, wall);
  if (!mayStand(moved)) {
    say("The robot, or its start, is in the way.");
    return false;
  }
  setWalls(Object.assign([...inside()], { [i]: moved }));
  return true;
}

function placeRobot([x, y, heading]) {
  if (!isFree(yours.world, [x, y], inside())) return say("There is no room for the robot.");
  for (const run of runs()) run.put([x, y, heading]);
  return changed();
}

function choose(i) {
  chosen = i;
  changed();
}

// What the buttons and keys do to what is chosen.
function turn(degrees) {
  const wall = inside()[chosen], [x, y, heading] = yours.here;
  if (chosen === ROBOT) placeRobot([x, y, heading + (degrees * Math.PI) / 180]);
  else if (wall) placeWall(chosen, [...wall.slice(0, 3), wall[3] + degrees]);
}
function move(dx, dy) {
  const wall = inside()[chosen], [x, y, heading] = yours.here;
  if (chosen === ROBOT) placeRobot([x + dx, y + dy, heading]);
  else if (wall) placeWall(chosen, [wall[0] + dx, wall[1] + dy, ...wall.slice(2)]);
}
function remove() {
  if (!inside()[chosen]) return;
  setWalls(inside().filter((_, i) => i !== chosen));
  choose(NOTHING);
  say("The wall is away.");
}
function drawing(yes) {
  isDrawing = yes;
  find("draw").setAttribute("aria-pressed", yes);
  find("draw").textContent = yes ? "Now draw on the floor" : "Draw a wall";
}

// A wall from one point to another.
function wallBetween([x0, y0], [x1, y1]) {
  const [wide, high] = [x1 - x0, y1 - y0], half = Math.min(1.5, Math.max(0.1, Math.hypot(wide, high) / 2));
  return [(x0 + x1) / 2, (y0 + y1) / 2, half, Math.round((Math.atan2(high, wide) * 180) / Math.PI)];
}

picture.addEventListener("touchstart", (event) => { // a finger that has taken something does not move the page
  const point = at(event.touches[0]);
  if (isDrawing || isRobotAt(...point) || wallAt(...point) >= 0) event.preventDefault();
}, { passive: false });
picture.onpointerdown = (event) => {
  if (!yours.floor) return point(event);
  const [x, y] = at(event);
  held = null;
  if (isDrawing) held = { from: [x, y], i: inside().length };
  else if (isRobotAt(x, y)) held = { robot: [x, y], moved: false };
  else if (wallAt(x, y) >= 0) held = { i: wallAt(x, y), x, y, wall: inside()[wallAt(x, y)] };
  choose(held === null || isDrawing ? NOTHING : held.robot ? ROBOT : held.i);
  if (held) picture.setPointerCapture(event.pointerId);
  return point(event);
};
picture.onpointermove = (event) => {
  const [x, y] = at(event);
  if (!held) point(event);
  else if (held.from && Math.hypot(x - held.from[0], y - held.from[1]) > 0.2 && inside().length <= MOST_WALLS) {
    if (placeWall(held.i, wallBetween(held.from, [x, y]))) chosen = held.i;
  } else if (held.wall && Math.hypot(x - held.x, y - held.y) > 0) {
    const [left, top, ...rest] = held.wall;
    placeWall(held.i, [left + x - held.x, top + y - held.y, ...rest]);
  } else if (held.robot && (held.moved || Math.hypot(x - held.robot[0], y - held.robot[1]) > 0.1)) {
    held.moved = true;
    placeRobot([x, y, yours.here[2]]);
  }
};
picture.onpointerup = picture.onpointercancel = () => {
  if (held?.from) drawing(false);
  held = null;
};
picture.onpointerleave = ({ pointerType }) => { if (pointerType !== "touch") point(null); };
picture.ondblclick = (event) => {
  if (yours.floor && wallAt(...at(event)) >= 0) turn(30);
};

// What is told of a point of the floor, beside it; null: of none.
function point(event) {
  const [x, y] = event ? at(event) : [0, 0], tip = find("tip");
  pointed = event && !held ? stateAt(x, y) : null;
  tip.hidden = pointed === null;
  if (pointed === null) return;
  const box = picture.getBoundingClientRect(), q = yours.simulation.m.q[pointed], best = bestOf(q);
  const isNew = q.every((value) => value === 0);
  tip.textContent = isNew ? "Here it knows nothing yet." : `Here it would: ${yours.world.actions[best]}. It expects ${number(q[best])} points to come.`;
  tip.style.left = `${Math.max(0, Math.min(event.clientX - box.left + 14, box.width - 205))}px`;
  tip.style.top = `${Math.max(0, event.clientY - box.top - 56)}px`;
}

// The state that the robot would be in at a point, with its present heading; null where it cannot be.
function stateAt(x, y) {
  const { world, here } = yours;
  if (yours.floor) {
    if (isAround(world, [x, y]) || wallAt(x, y) >= 0) return null;
    return world.stateOf(world.sense([x, y, world.place[2]]));
  }
  const same = (a, b) => String(a) === String(b);
  const there = world.drawn.findIndex(({ cell, heading, box }) =>
    same(cell, [Math.floor(x), Math.floor(y)]) && heading === here.heading && same(box, here.box));
  return there < 0 ? null : world.seen[there];
}

const WAYS = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, 0.05], ArrowDown: [0, -0.05] };
picture.onkeydown = (event) => {
  const n = inside().length;
  if (event.key === "w" && n) {
    choose((Math.max(NOTHING, chosen) + 1) % n);
    say(`Wall ${chosen + 1} of ${n}`);
  } else if (event.key === "m" && yours.floor) {
    choose(ROBOT);
    say("The robot");
  } else if (event.key === "r" && chosen !== NOTHING) turn(15);
  else if (event.key in WAYS && chosen !== NOTHING) move(...WAYS[event.key]);
  else if (event.key === "Delete" && chosen >= 0) remove();
  else return;
  event.preventDefault();
};
find("draw").onclick = () => drawing(!isDrawing);
find("turn").onclick = () => turn(30);
find("remove").onclick = remove;
find("restore").onclick = () => {
  choose(NOTHING);
  setWalls(null);
  for (const run of runs()) if (!isFree(run.world, run.here, inside())) run.put(run.world.start);
  say("All walls are as they were.");
};
