// The room in 3D on a canvas, by a projection: from metres to pixels, and the floor, walls, ways and robots there.

const WALL_HIGH = 0.22, BODY_HIGH = 0.15, EYE = 0.09; // heights of walls, robots and beams [m]
const DOWN = 1.0, AWAY = 13; // the camera looks down by this angle [rad], so far from the middle of the floor [m]
const THICK = 0.1; // of the walls around the room [m]
const SHADOW = [0.75, -0.45]; // of what is one metre high [m]

// From metres to pixels and back. left, top, wide: where the picture lies [px]; its height follows
class Camera {
  constructor([xMin, yMin, xMax, yMax], [left, top, wide]) {
    Object.assign(this, { left, top, wide, x: (xMin + xMax) / 2, y: (yMin + yMax) / 2 });
    const raised = [0, WALL_HIGH].flatMap((z) => [xMin - THICK, xMax + THICK].flatMap((x) =>
      [yMin - THICK, yMax + THICK].map((y) => this.seen(x, y, z))));
    const [across, down] = [0, 1].map((axis) => raised.map((spot) => spot[axis]));
    this.zoom = wide / (Math.max(...across) - Math.min(...across));
    this.corner = [Math.min(...across), Math.min(...down)];
    this.high = this.zoom * (Math.max(...down) - Math.min(...down));
    this.scale = this.zoom / AWAY; // pixels of a metre in the middle of the floor
    this.eye = [this.x, this.y - AWAY * Math.cos(DOWN), AWAY * Math.sin(DOWN)];
  }

  // A point at a distance of 1 from the eye: to the right, and down.
  seen(x, y, z) {
    const [ahead, up] = [Math.cos(DOWN), Math.sin(DOWN)], far = AWAY + (y - this.y) * ahead - z * up;
    return [(x - this.x) / far, -((y - this.y) * up + z * ahead) / far];
  }

  at(x, y, z = 0) {
    const [across, down] = this.seen(x, y, z);
    return [this.left + this.zoom * (across - this.corner[0]), this.top + this.zoom * (down - this.corner[1])];
  }

  // The point of the floor at a pixel.
  from(left, top) {
    const across = (left - this.left) / this.zoom + this.corner[0], up = -((top - this.top) / this.zoom + this.corner[1]);
    const y = (up * AWAY) / (Math.sin(DOWN) - up * Math.cos(DOWN));
    return [this.x + across * (AWAY + y * Math.cos(DOWN)), this.y + y];
  }
}

function polygon(context, spots) {
  context.beginPath();
  spots.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
}

function fill(context, spots, colour) {
  context.fillStyle = colour;
  polygon(context, spots);
  context.fill();
}

// A colour between two of the form rgb(…).
function between(one, other, part) {
  const [from, to] = [one, other].map((colour) => colour.match(/[\d.]+/g).map(Number));
  return `rgb(${[0, 1, 2].map((i) => Math.round(from[i] + part * (to[i] - from[i]))).join(",")})`;
}

// The corners of a wall on the floor, in turn to the left; half as far again as the wall with `wider` [m].
const footOf = ([x, y, half, thin, cos, sin]) => [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [
  x + a * half * cos - b * thin * sin, y + a * half * sin + b * thin * cos,
]);

// The points of an outline in the robot's frame, on the floor; place: of its axle.
function footOfRobot({ outline, axle }, [x, y, heading]) {
  const cos = Math.cos(heading), sin = Math.sin(heading);
  return outline.map(([a, b]) => [x + (a - axle) * cos - b * sin, y + (a - axle) * sin + b * cos]);
}

// A body with upright sides: those that can be seen, and its top. foot: convex, in turn to the left
function solid(context, camera, foot, high, top, side, dark) {
  foot.forEach(([x, y], i) => {
    const [toX, toY] = foot[(i + 1) % foot.length], out = [toY - y, x - toX];
    if (out[0] * (camera.eye[0] - x) + out[1] * (camera.eye[1] - y) <= 0) return;
    const face = [camera.at(x, y), camera.at(toX, toY), camera.at(toX, toY, high), camera.at(x, y, high)];
    fill(context, face, between(side, dark, Math.abs(out[0]) / Math.hypot(...out)));
  });
  fill(context, foot.map(([x, y]) => camera.at(x, y, high)), top);
}

function shadow(context, camera, foot, high, colours) {
  const [x, y] = SHADOW.map((far) => far * high), ends = foot.map(([a, b]) => [a + x, b + y]);
  context.fillStyle = colours.shadow;
  context.beginPath();
  foot.forEach((from, i) => { // what the foot sweeps on its way to the shadow's end
    const next = (i + 1) % foot.length, swept = [from, foot[next], ends[next], ends[i]].map((spot) => camera.at(...spot));
    const turn = (swept[1][0] - swept[0][0]) * (swept[2][1] - swept[0][1]) - (swept[1][1] - swept[0][1]) * (swept[2][0] - swept[0][0]);
    (turn > 0 ? swept : swept.reverse()).forEach(([a, b], j) => (j ? context.lineTo(a, b) : context.moveTo(a, b)));
    context.closePath();
  });
  context.fill();
}

// The floor with what lies on it. way: an image of the size of the picture, if there is one; dim: how much of it is seen
function drawFloor(context, camera, world, colours, way, dim = 1) {
  const [xMin, yMin, xMax, yMax] = world.bounds, { globalAlpha: whole } = context;
  fill(context, [[xMin, yMin], [xMax, yMin], [xMax, yMax], [xMin, yMax]].map((spot) => camera.at(...spot)), colours.floor);
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  context.globalAlpha = 0.6 * whole;
  context.beginPath();
  for (let metre = -2; metre <= 2; metre++) {
    for (const [from, to] of [[[metre, yMin], [metre, yMax]], [[xMin, metre], [xMax, metre]]]) {
      context.moveTo(...camera.at(...from));
      context.lineTo(...camera.at(...to));
    }
  }
  context.stroke();
  context.globalAlpha = whole;
  for (const wall of world.walls) if (!isAround(world, wall)) shadow(context, camera, footOf(wall), WALL_HIGH, colours);
  context.globalAlpha = dim * whole;
  if (way?.width && way.height) context.drawImage(way, camera.left, camera.top, camera.wide, camera.high); // none while the page is hidden
  context.globalAlpha = whole;
}

// Whether a body at a point stands before a wall, seen from the eye: on its side of the plane that parts the two.
function isBefore({ eye }, [x, y, half, thin, cos, sin], [px, py]) {
  const own = ([a, b]) => [(a - x) * cos + (b - y) * sin, (b - y) * cos - (a - x) * sin];
  const [along, across] = own([px, py]), [eyeAlong, eyeAcross] = own(eye);
  if (Math.abs(across) > thin) return Math.sign(across) * eyeAcross > thin;
  return Math.sign(along) * eyeAlong > half;
}

// Walls and bodies from back to front. bodies: each with a place and what draws it; chosen: a wall's number, or -1
function drawUpright(context, camera, world, colours, bodies, chosen = -1) {
  const order = Array.from(world.walls, (wall, i) => ({ wall, i })).sort((a, b) => b.wall[1] - a.wall[1]);
  for (const body of [...bodies].sort((a, b) => b.place[1] - a.place[1])) {
    let after = -1;
    order.forEach(({ wall, place }, i) => {
      if (wall ? isBefore(camera, wall, body.place) : place[1] > body.place[1]) after = i;
    });
    order.splice(after + 1, 0, body);
  }
  for (const { wall, i, draw } of order) {
    if (draw) draw();
    else {
      const tone = i === chosen ? colours.focus : colours.wall;
      solid(context, camera, footOf(wall), WALL_HIGH, between(tone, "rgb(255,255,255)", 0.28), between(tone, colours.black, 0.12), between(tone, colours.black, 0.36));
    }
  }
}

// A robot: its body in a colour, its nose in that of the rim, and a mark behind it; a ghost has no shadow and a dashed rim.
function drawRobot(context, camera, world, place, { tone, rim, ink, mark = "", isGhost = false }, colours) {
  const [x, y, heading] = place, foot = footOfRobot(world, place), high = BODY_HIGH;
  if (!isGhost) shadow(context, camera, foot, high, colours);
  solid(context, camera, foot, high, tone, between(tone, colours.black, 0.25), between(tone, colours.black, 0.4));
  context.strokeStyle = rim;
  context.lineWidth = isGhost ? 2 : 1.5;
  context.setLineDash(isGhost ? [5, 3] : []);
  polygon(context, foot.map(([a, b]) => camera.at(a, b, high)));
  context.stroke();
  context.setLineDash([]);
  const nose = { outline: [[0.235, 0], [0.13, 0.085], [0.13, -0.085]], axle: world.axle };
  fill(context, footOfRobot(nose, place).map(([a, b]) => camera.at(a, b, high)), rim);
  if (!mark) return;
  context.fillStyle = ink;
  context.font = `${Math.max(13, Math.round(0.2 * camera.scale))}px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const [left, top] = camera.at(x - 0.1 * Math.cos(heading), y - 0.1 * Math.sin(heading), high);
  context.fillText(mark, left, top + 1);
}

// A laser's beam as far as a state can tell: to the last cut; beyond it is dotted. shift: of the robot that is drawn
function drawBeam(context, camera, world, place, input, tone, wide, [dx, dy] = [0, 0]) {
  const { rays, inset, range, lengths, lasers, inputs } = world, { name, cuts } = inputs[input], laser = lasers.indexOf(name);
  const [a, b, ahead, aside] = rays[laser], [x, y, heading] = place, cos = Math.cos(heading), sin = Math.sin(heading);
  world.kernels.look(place, rays, inset + range, world.walls, lengths);
  const last = cuts.at(-1) + inset, isNear = lengths[laser] <= last, far = Math.min(lengths[laser], last);
  const at = (along) => {
    const [p, q] = [a + along * ahead, b + along * aside];
    return camera.at(x + dx + p * cos - q * sin, y + dy + p * sin + q * cos, EYE);
  };
  context.strokeStyle = context.fillStyle = tone;
  context.lineWidth = wide;
  context.setLineDash(isNear ? [] : [wide, 1.6 * wide]);
  context.beginPath();
  context.moveTo(...at(inset));
  context.lineTo(...at(far));
  context.stroke();
  context.setLineDash([]);
  if (!isNear) return;
  context.beginPath();
  context.arc(...at(far), 1.4 * wide, 0, 7);
  context.fill();
}

// The way of a life, painted step by step on an image of its own: a line where a step paid, a dot where the robot stood
// or turned, a cross where it bumped.
class Way {
  constructor(life, wide, ratio) {
    const camera = new Camera(life.world.bounds, [0, 0, wide]);
    Object.assign(this, { life, camera, image: document.createElement("canvas"), t: 0 });
    this.image.width = Math.ceil(wide * ratio);
    this.image.height = Math.ceil(camera.high * ratio);
    this.context = this.image.getContext("2d");
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  // Paint it as far as time t, anew if it has been painted further.
  to(t, colours) {
    if (t < this.t) {
      this.context.clearRect(0, 0, this.camera.wide, this.camera.high);
      this.t = 0;
    }
    while (this.t < t) this.paint((this.t += 1), colours);
    return this.image;
  }

  paint(t, colours) {
    const { context, camera, life: { places, r } } = this, kind = kindOf(r[t]), size = camera.wide / 600;
    const [left, top] = camera.at(...places[t].slice(0, 2));
    context.strokeStyle = context.fillStyle = { paid: colours.green, bump: colours.red, idle: colours.grey }[kind];
    context.lineWidth = (kind === "bump" ? 2 : 2.4) * size;
    context.globalAlpha = { paid: 0.5, bump: 0.9, idle: 0.35 }[kind];
    context.beginPath();
    if (kind === "idle") {
      context.arc(left, top, 1.4 * size, 0, 7);
      context.fill();
      return;
    }
    if (kind === "paid") {
      context.moveTo(...camera.at(...places[t - 1].slice(0, 2)));
      context.lineTo(left, top);
    } else {
      const half = 4.5 * size;
      for (const side of [-half, half]) {
        context.moveTo(left - half, top - side);
        context.lineTo(left + half, top + side);
      }
    }
    context.stroke();
  }
}
