// The room from above: the floor with what is known there, which is painted seldom, and on it the robot, which moves.

// A canvas as sharp as the screen: its context, in CSS pixels, empty. seen: the one on the page, of the same size
function sharp(canvas, seen = canvas) {
  const ratio = window.devicePixelRatio || 1, width = seen.clientWidth, height = seen.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

// From metres to pixels: the whole of the bounds, upright, in the middle.
class View {
  constructor([xMin, yMin, xMax, yMax], width, height) {
    this.scale = Math.min(width / (xMax - xMin), height / (yMax - yMin));
    this.left = (width - this.scale * (xMax - xMin)) / 2 - this.scale * xMin;
    this.base = (height + this.scale * (yMax - yMin)) / 2 + this.scale * yMin;
  }

  at(x, y) {
    return [this.left + this.scale * x, this.base - this.scale * y];
  }

  from(left, top) {
    return [(left - this.left) / this.scale, (this.base - top) / this.scale];
  }
}

const viewOf = ({ bounds: [xMin, yMin, xMax, yMax] }, width, height) =>
  new View([xMin - 0.12, yMin - 0.12, xMax + 0.12, yMax + 0.12], width, height);

function polygon(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
}

const corners = ([x, y, half, thin, cos, sin]) =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [
    x + a * half * cos - b * thin * sin, y + a * half * sin + b * thin * cos,
  ]);

// What lies behind the robot: the floor in the colour of its value, the goal, and the walls.
// It is painted on the run's own canvas, `ground`. marked: the wall that is chosen, as a row of the world's walls
function drawFloor(canvas, run, marked, colours) {
  const { context, width, height } = sharp(run.ground, canvas), { world } = run, [xMin, yMin, xMax, yMax] = world.bounds;
  const view = viewOf(world, width, height), at = (points) => points.map(([x, y]) => view.at(x, y));
  context.fillStyle = colours.floor;
  polygon(context, at([[xMin, yMin], [xMax, yMin], [xMax, yMax], [xMin, yMax]]));
  context.fill();
  context.save();
  context.clip();
  drawValues(context, view, run, colours);
  context.restore();
  if (world.goal) drawGoal(context, view, world.goal, colours);
  for (const wall of world.walls) {
    context.fillStyle = wall === marked ? colours.chosen : colours.wall;
    polygon(context, at(corners(wall)));
    context.fill();
  }
}

// Each piece of floor where it has been: the darker, the more it expects in the state in which it was there last;
// the arrow tells what it would do there, facing as it did then.
function drawValues(context, view, { floor, simulation, world }, colours) {
  const met = [...floor.places()].map((place) => [...place, bestOf(simulation.m.q[place[2]])]);
  const most = met.reduce((high, [, , s, , best]) => Math.max(high, Math.abs(simulation.m.q[s][best])), 1e-9);
  const side = TILE * view.scale;
  for (const [x, y, s, , best] of met) {
    const value = simulation.m.q[s][best] / most, [left, top] = view.at(x, y);
    context.fillStyle = value < 0 ? colours.bump : colours.value;
    context.globalAlpha = 0.06 + 0.54 * Math.abs(value);
    context.fillRect(left - side / 2, top - side / 2, side - 1, side - 1);
  }
  context.globalAlpha = 0.55;
  context.strokeStyle = colours.ink;
  context.lineWidth = 1;
  context.beginPath();
  for (const [x, y, s, heading, best] of met) {
    if (simulation.m.q[s].some((value) => value !== 0)) arrow(context, view, x, y, heading, world.twists[best]);
  }
  context.stroke();
  context.globalAlpha = 1;
}

// A small arrow on the floor: straight on, bent to the side to which it turns, or a point where it would stand.
function arrow(context, view, x, y, heading, [v, omega]) {
  const long = 0.09, tip = heading + Math.sign(omega) * (v ? 0.7 : 1.3);
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
    context.lineTo(...view.at(...on(tip + side, 0.06, end)));
  }
}

function drawGoal(context, view, [x, y, radius], colours) {
  context.strokeStyle = context.fillStyle = colours.goal;
  context.lineWidth = 3;
  context.beginPath();
  context.arc(...view.at(x, y), radius * view.scale, 0, 7);
  context.stroke();
  context.textAlign = "center";
  context.font = "bold 16px system-ui, sans-serif";
  context.fillText("goal", ...view.at(x, y));
}

// The floor, and what moves; place: of the robot's axle, which may lie between two steps. Tells the view.
function drawRobot(canvas, run, place, isChosen, colours) {
  const { context, width, height } = sharp(canvas), { world, trail, bumps } = run;
  const view = viewOf(world, width, height), pieces = 12, each = TRAIL / pieces;
  context.drawImage(run.ground, 0, 0, width, height);
  context.lineWidth = 2.5;
  context.strokeStyle = colours.trail;
  for (let first = 0; first + 1 < trail.length; first += each) { // it fades
    context.globalAlpha = Math.min(1, (first + each) / trail.length);
    context.beginPath();
    context.moveTo(...view.at(...trail[first]));
    for (const point of trail.slice(first + 1, first + each + 1)) context.lineTo(...view.at(...point));
    if (first + each >= trail.length) context.lineTo(...view.at(...place));
    context.stroke();
  }
  context.lineWidth = 2;
  context.strokeStyle = colours.bump;
  bumps.forEach(([x, y], i) => { // a cross where it bumped
    context.globalAlpha = (i + 1) / bumps.length;
    const [left, top] = view.at(x, y);
    context.beginPath();
    for (const side of [-5, 5]) {
      context.moveTo(left - 5, top - side);
      context.lineTo(left + 5, top + side);
    }
    context.stroke();
  });
  context.globalAlpha = 1;
  drawBase(context, view, world, place, isChosen, colours);
  return view;
}

function drawBase(context, view, world, place, isChosen, colours) {
  const [x, y, theta] = place, cos = Math.cos(theta), sin = Math.sin(theta);
  const from = (a, b) => [x + a * cos - b * sin, y + a * sin + b * cos]; // from its axle
  world.kernels.look(place, world.rays, world.inset + world.range, world.walls, world.lengths);
  context.strokeStyle = colours.beam;
  context.lineWidth = 1.5;
  context.setLineDash([2, 4]);
  context.beginPath();
  world.rays.forEach(([a, b, ahead, aside], i) => {
    const used = world.inputs.some((input) => input.name === world.lasers[i]);
    if (!used) return; // only the lasers that the task looks at
    context.moveTo(...view.at(...from(a + ahead * world.inset, b + aside * world.inset)));
    context.lineTo(...view.at(...from(a + ahead * world.lengths[i], b + aside * world.lengths[i])));
  });
  context.stroke();
  context.setLineDash([]);
  context.fillStyle = colours.robot;
  polygon(context, world.outline.map(([a, b]) => view.at(...from(a - world.axle, b))));
  context.fill();
  context.lineWidth = isChosen ? 4 : 2;
  context.strokeStyle = isChosen ? colours.chosen : colours.card;
  context.stroke();
  context.fillStyle = colours.card; // the nose: it points ahead
  polygon(context, [[0.2, 0], [0.06, 0.11], [0.06, -0.11]].map(([a, b]) => view.at(...from(a - world.axle, b))));
  context.fill();
}
