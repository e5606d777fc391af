// The playground's room: the floor with what is known there, which is painted seldom, and on it the robot, which moves.

const corners = ([x, y, half, thin, cos, sin]) =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [
    x + a * half * cos - b * thin * sin, y + a * half * sin + b * thin * cos,
  ]);

const circle = ([x, y, radius]) => Array.from({ length: 48 }, (_, i) =>
  [x + radius * Math.cos((i * Math.PI) / 24), y + radius * Math.sin((i * Math.PI) / 24)]);

const BLOCK = 0.75; // side of a block of floor, three of its pieces, in which one arrow is drawn [m]

// The form in which room.js takes a world: the robot's place is that of its axle.
function sceneOf(world, place) {
  const { kernels, walls, rays, inset, range, lengths, axle } = world, view = (a, b) => fromPlace(place, a, b);
  kernels.look(place, rays, inset + range, walls, lengths);
  const beams = rays.map(([a, b, ahead, aside], i) =>
    [inset, lengths[i]].flatMap((long) => view(a + ahead * long, b + aside * long)));
  return { beams, place: [...view(-axle, 0), place[2]], outline: world.outline };
}

function fromPlace([x, y, heading], a, b) {
  const cos = Math.cos(heading), sin = Math.sin(heading);
  return [x + a * cos - b * sin, y + a * sin + b * cos];
}

// Up to which length each laser counts: the last cut of the task, or 0 for one that it does not look at.
const nearOf = ({ lasers, inputs }) => lasers.map((laser) =>
  Math.max(0, ...inputs.filter(({ name }) => name === laser).flatMap(({ cuts }) => cuts ?? [])));

// What lies behind the robot: the floor in the colour of its value, the goal, and the walls.
// It is painted on the run's own canvas, `ground`. marked: the wall that is chosen, as a row of the world's walls
function drawFloor(canvas, run, marked, colours) {
  const { world } = run, room = new Room(run.ground, world.bounds, colours, { seen: canvas });
  room.floor((context, view) => drawValues(context, view, run, colours));
  if (world.goal) room.solids([["goal", circle(world.goal)]]);
  room.walls(Array.from(world.walls, corners));
  if (marked) room.walls([corners(marked)], colours.focus);
}

// Each piece of floor where it has been: the darker, the more it expects in the state in which it was there last.
// An arrow tells what it would do there, facing as it did then: in each block of pieces only where it expects most.
function drawValues(context, view, { floor, simulation, world }, colours) {
  const met = [...floor.places()].map((place) => [...place, bestOf(simulation.m.q[place[2]])]);
  const most = met.reduce((high, [, , s, , best]) => Math.max(high, Math.abs(simulation.m.q[s][best])), 1e-9);
  const side = TILE * view.scale;
  for (const [x, y, s, , best] of met) {
    const value = simulation.m.q[s][best] / most, [left, top] = view.at(x, y);
    context.fillStyle = value < 0 ? colours.red : colours.green;
    context.globalAlpha = 0.06 + 0.54 * Math.abs(value);
    context.fillRect(left - side / 2, top - side / 2, side - 1, side - 1);
  }
  context.globalAlpha = 0.6;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  for (const [x, y, , heading, best] of hopeful(met, simulation.m.q)) arrow(context, view, x, y, heading, world.twists[best]);
  context.stroke();
  context.globalAlpha = 1;
}

// Of each block of floor the piece where it expects most, if that is more than nothing.
function hopeful(met, q) {
  const found = new Map(), valueOf = ([, , s, , best]) => q[s][best];
  for (const piece of met) {
    const block = [0, 1].map((axis) => Math.floor(piece[axis] / BLOCK)).join();
    if (valueOf(piece) > (found.has(block) ? valueOf(found.get(block)) : 0)) found.set(block, piece);
  }
  return found.values();
}

// A small arrow on the floor: straight on, bent to the side to which it turns, or a point where it would stand.
function arrow(context, view, x, y, heading, [v, omega]) {
  const long = 0.14, tip = heading + Math.sign(omega) * (v ? 0.7 : 1.3);
  const on = (angle, far, [a, b] = [x, y]) => [a + far * Math.cos(angle), b + far * Math.sin(angle)];
  if (!v && !omega) {
    context.moveTo(...view.at(x - 0.02, y));
    context.lineTo(...view.at(x + 0.02, y));
    return;
  }
  const end = on(tip, long);
  context.moveTo(...view.at(...on(heading, -long)));
  context.lineTo(...view.at(x, y));
  context.lineTo(...view.at(...end));
  for (const side of [2.5, -2.5]) {
    context.moveTo(...view.at(...end));
    context.lineTo(...view.at(...on(tip + side, 0.08, end)));
  }
}

// The floor, and what moves; place: of the robot's axle, which may lie between two steps. Tells the view.
// isSlow: whether single steps can be seen, and so a bump
function drawRobot(canvas, run, place, { isChosen, isSlow }, colours) {
  const { world, trail, bumps } = run, room = new Room(canvas, world.bounds, colours);
  const { beams, place: middle, outline } = sceneOf(world, place), isBump = isSlow && run.isBump;
  const { ground } = run;
  if (ground.width && ground.height) room.context.drawImage(ground, 0, 0, room.width, room.height); // none while the page is hidden
  room.trail(trail.length ? [...trail.slice(0, -1), [place[0], place[1], trail.at(-1)[2]]] : [], null, { fades: true });
  bumps.forEach(([x, y], i) => room.cross(x, y, (i + 1) / bumps.length));
  room.rays(beams, nearOf(world));
  room.robot(middle, outline, { isBump, isChosen });
  if (isBump) room.word(middle, "bump!");
  return room.view;
}
