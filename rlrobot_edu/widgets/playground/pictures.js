// What is drawn: the room or the cells from above, and the curve of rewards. Colours are those of style.css.

const inColours = (names) => {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
};
const NAMES = ["back", "ink", "faint", "line", "floor", "wall", "chosen", "robot", "beam", "bump", "trail", "goal",
  "box", "ghost"];

// A canvas as sharp as the screen: its context, in CSS pixels, empty.
function sharp(canvas) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
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

function polygon(context, points) {
  context.beginPath();
  points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.closePath();
}

const corners = ([x, y, half, thin, cos, sin]) =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [
    x + a * half * cos - b * thin * sin, y + a * half * sin + b * thin * cos,
  ]);

// The room of a mobile base; place: of its axle, which may lie between two steps.
function drawRoom(canvas, world, place, trail, bumps, chosen, colours) {
  const { context, width, height } = sharp(canvas), [xMin, yMin, xMax, yMax] = world.bounds;
  const view = new View([xMin - 0.12, yMin - 0.12, xMax + 0.12, yMax + 0.12], width, height);
  const at = (points) => points.map(([x, y]) => view.at(x, y));
  context.fillStyle = colours.floor;
  polygon(context, at([[xMin, yMin], [xMax, yMin], [xMax, yMax], [xMin, yMax]]));
  context.fill();
  if (world.goal) {
    const [x, y, radius] = world.goal;
    context.strokeStyle = colours.goal;
    context.lineWidth = 3;
    context.beginPath();
    context.arc(...view.at(x, y), radius * view.scale, 0, 7);
    context.stroke();
    context.fillStyle = colours.goal;
    context.textAlign = "center";
    context.font = "15px system-ui, sans-serif";
    context.fillText("goal", ...view.at(x, y));
  }
  context.lineWidth = 2;
  context.strokeStyle = colours.trail;
  for (let i = 1; i < trail.length; i++) { // it fades
    context.globalAlpha = i / trail.length;
    context.beginPath();
    context.moveTo(...view.at(...trail[i - 1]));
    context.lineTo(...view.at(...trail[i]));
    context.stroke();
  }
  context.strokeStyle = colours.bump;
  bumps.forEach(([x, y], i) => { // a cross where it bumped
    context.globalAlpha = (i + 1) / bumps.length;
    const [left, top] = view.at(x, y);
    context.beginPath();
    for (const side of [-4, 4]) {
      context.moveTo(left - 4, top - side);
      context.lineTo(left + 4, top + side);
    }
    context.stroke();
  });
  context.globalAlpha = 1;
  world.walls.forEach((wall, i) => {
    context.fillStyle = i === chosen ? colours.chosen : colours.wall;
    polygon(context, at(corners(wall)));
    context.fill();
  });
  drawBase(context, view, world, place, colours);
  return view;
}

function drawBase(context, view, world, place, colours) {
  const [x, y, theta] = place, cos = Math.cos(theta), sin = Math.sin(theta);
  const from = (a, b) => [x + a * cos - b * sin, y + a * sin + b * cos]; // from its axle
  world.kernels.look(place, world.rays, world.inset + world.range, world.walls, world.lengths);
  context.strokeStyle = colours.beam;
  context.lineWidth = 1;
  context.setLineDash([2, 3]);
  world.rays.forEach(([a, b, ahead, aside], i) => {
    const used = world.inputs.some((input) => input.name === world.lasers[i]);
    if (!used) return; // only the lasers that the task looks at
    context.beginPath();
    context.moveTo(...view.at(...from(a + ahead * world.inset, b + aside * world.inset)));
    context.lineTo(...view.at(...from(a + ahead * world.lengths[i], b + aside * world.lengths[i])));
    context.stroke();
  });
  context.setLineDash([]);
  context.fillStyle = colours.robot;
  polygon(context, world.outline.map(([a, b]) => view.at(...from(a - world.axle, b))));
  context.fill();
  context.fillStyle = colours.back; // the nose: it points ahead
  polygon(context, [[0.2, 0], [0.08, 0.1], [0.08, -0.1]].map(([a, b]) => view.at(...from(a - world.axle, b))));
  context.fill();
}

// Cells seen from above, one a pair of column and row; learned: tells of a place the action that is best there now.
function drawCells(canvas, world, place, learned, colours) {
  const { context, width, height } = sharp(canvas), cells = world.drawn.map(({ cell }) => cell);
  const columns = 1 + Math.max(...cells.map(([x]) => x)), rows = 1 + Math.max(...cells.map(([, y]) => y));
  const view = new View([-0.05, -0.05, columns + 0.05, rows + 0.05], width, height);
  const is = (some, [x, y]) => Boolean(some) && some.some(([a, b]) => a === x && b === y);
  const box = ([x, y], shrink) => {
    const [left, top] = view.at(x + shrink, y + 1 - shrink), side = view.scale * (1 - 2 * shrink);
    context.fillRect(left, top, side, side);
  };
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = `${Math.max(11, 0.26 * view.scale)}px system-ui, sans-serif`;
  const names = cells.map(String);
  new Set(names).forEach((text) => {
    const cell = text.split(",").map(Number), middle = view.at(cell[0] + 0.5, cell[1] + 0.5);
    context.fillStyle = is(world.cliff, cell) ? colours.line : colours.floor;
    box(cell, 0.02);
    context.fillStyle = colours.faint;
    if (is(world.cliff, cell)) context.fillText("cliff", ...middle);
    else if (world.goal && is([world.goal], cell)) context.fillText("goal", ...middle);
    else if (learned) context.fillText(learned(names.indexOf(text)), ...middle);
  });
  if (place.box) {
    context.fillStyle = colours.box;
    box(place.box, 0.2);
  }
  const [x, y] = view.at(place.cell[0] + 0.5, place.cell[1] + 0.5), size = 0.3 * view.scale;
  context.fillStyle = colours.robot;
  context.beginPath();
  context.arc(x, y, size, 0, 7);
  context.fill();
  if (place.heading !== null) {
    const turn = (-place.heading * Math.PI) / 180;
    context.strokeStyle = colours.back;
    context.lineWidth = size / 4;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + size * 0.9 * Math.cos(turn), y + size * 0.9 * Math.sin(turn));
    context.stroke();
  }
  return view;
}

// Rewards in windows of equal length, never more than LENGTH of them: when they are full, two become one.
class Curve {
  constructor() {
    Object.assign(this, { means: [], window: 20, sum: 0, n: 0, called: "" });
  }

  add(r) {
    this.sum += r;
    if (++this.n < this.window) return;
    this.means.push(this.sum / this.n);
    this.sum = this.n = 0;
    if (this.means.length < Curve.LENGTH) return;
    this.means = this.means.filter((_, i) => i % 2).map((mean, i) => (mean + this.means[2 * i]) / 2);
    this.window *= 2;
  }

  get steps() {
    return this.means.length * this.window;
  }
}
Curve.LENGTH = 240;

// Each number's mean with the four before it.
const smooth = (numbers) => numbers.map((_, i) => {
  const some = numbers.slice(Math.max(0, i - 4), i + 1);
  return some.reduce((sum, each) => sum + each, 0) / some.length;
});

// The curve that grows, and the one before, dashed; both from step 0 to the step that is the later.
function drawCurves(canvas, now, before, colours) {
  const { context, width, height } = sharp(canvas), curves = before ? [before, now] : [now];
  const steps = Math.max(1000, ...curves.map((curve) => curve.steps));
  const lines = curves.map((curve) => smooth(curve.means)), all = lines.flat();
  const low = Math.min(0, ...all), high = Math.max(0, ...all), span = Math.max(high - low, 0.5);
  const left = 40, bottom = height - 20, right = width - 6, top = 8;
  const x = (step) => left + ((right - left) * step) / steps, y = (r) => bottom - ((bottom - top) * (r - low)) / span;
  context.font = "12px system-ui, sans-serif";
  context.fillStyle = colours.faint;
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const r of new Set([low, 0, high])) context.fillText(r.toFixed(1), left - 4, y(r));
  context.textBaseline = "alphabetic";
  context.fillText(`${steps.toLocaleString("en")} steps`, right, height - 5);
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(left, top);
  context.lineTo(left, bottom);
  context.moveTo(left, y(0));
  context.lineTo(right, y(0));
  context.stroke();
  curves.forEach((curve, k) => {
    context.strokeStyle = curve === now ? colours.robot : colours.ghost;
    context.setLineDash(curve === now ? [] : [5, 4]);
    context.lineWidth = 2;
    context.beginPath();
    lines[k].forEach((mean, i) => {
      const point = [x((i + 1) * curve.window), y(mean)];
      if (i) context.lineTo(...point);
      else context.moveTo(...point);
    });
    context.stroke();
  });
  context.setLineDash([]);
}
