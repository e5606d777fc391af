// A room from above on a canvas, for any page: floor, walls, things, the robot, its way, near rays, a bump, a bar.
//
//   const colours = coloursOf(canvas);                     // of look.css, light or dark as the page is; anew when it changes
//   const view = drawRoom(canvas, scene, { colours, trail, loss, near, bar });
//   view.at(x, y); view.from(left, top);                   // from metres to CSS pixels of the canvas, and back
//
// scene: as scene_data.py writes it. bounds: [xMin, yMin, xMax, yMax]; walls: a list of polygons, each [[x, y], …];
//   solids: [[role, polygon], …]; beams: [[x0, y0, x1, y1], …]; place: [x, y, heading] of the robot, or null;
//   outline: its polygon as seen from its place, x ahead. All in metres and radians.
// trail: [[x, y, r], …], the places in the order of time and the reward of the step to each; r is null where it was put.
// loss: a reward up to this one counts as lost, such as a bump's; near: a ray is drawn up to this length [m], one number or
//   one for each ray. isBump: whether it bumps, by default if the last step is lost. word: what is written at the robot then.
// bar: { step, of, reward, sum }, written below the room, with one metre; leave it out for none.
// A page with pictures of its own on the floor, or with two layers, calls the methods of Room itself, in drawRoom's order.

const ROOM_COLOURS = ["back", "card", "ink", "faint", "line", "floor", "wall", "blue", "on-blue", "green", "red", "grey",
  "orange", "focus"];
const ROOM_MARGIN = 0.02; // around the bounds, as a part of the longer side
const ROOM_BAR = 40; // height of the bar [px]
const ROOM_LETTERS = "system-ui, \"Segoe UI\", sans-serif";

// The colours by their names in show/palette.py, as they are at an element of the page.
function coloursOf(element) {
  const probe = document.createElement("i"), parent = element.parentElement ?? element;
  parent.append(probe);
  const entries = ROOM_COLOURS.map((name) => {
    probe.style.color = `var(--${name})`;
    return [name, getComputedStyle(probe).color];
  });
  probe.remove();
  return Object.fromEntries(entries);
}

// Calls `changed` when the colours are others: with the system's theme, or with that of a page around it.
function followColours(changed) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
  const watched = { attributes: true, attributeFilter: ["class", "theme", "data-theme", "data-jp-theme-light"] };
  for (const element of [document.documentElement, document.body]) new MutationObserver(changed).observe(element, watched);
}

// A canvas as sharp as the screen: its context, in CSS pixels, empty. seen: the one on the page, of the same size
function sharpCanvas(canvas, seen = canvas) {
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

// From metres to pixels: the whole of a rectangle, upright, in the middle, with one scale.
class RoomView {
  constructor([xMin, yMin, xMax, yMax], width, height) {
    this.scale = Math.min(width / (xMax - xMin), height / (yMax - yMin));
    this.left = (width - this.scale * (xMax - xMin)) / 2 - this.scale * xMin;
    this.base = (height + this.scale * (yMax - yMin)) / 2 + this.scale * yMin;
  }

  // Of a room: its bounds and the walls around them.
  static of([xMin, yMin, xMax, yMax], width, height) {
    const margin = ROOM_MARGIN * Math.max(xMax - xMin, yMax - yMin);
    return new RoomView([xMin - margin, yMin - margin, xMax + margin, yMax + margin], width, height);
  }

  at(x, y) {
    return [this.left + this.scale * x, this.base - this.scale * y];
  }

  from(left, top) {
    return [(left - this.left) / this.scale, (this.base - top) / this.scale];
  }

  // A point [a, b] as seen from a place, x ahead.
  seenFrom([x, y, heading], [a, b]) {
    const cos = Math.cos(heading), sin = Math.sin(heading);
    return this.at(x + a * cos - b * sin, y + a * sin + b * cos);
  }
}

// All of a scene. Tells the view.
function drawRoom(canvas, scene, { colours = coloursOf(canvas), trail = [], loss = null, near = null, isBump = null, word = "bump!",
  bar = null } = {}) {
  const room = new Room(canvas, scene.bounds, colours, { below: bar ? ROOM_BAR : 0 }), last = trail.at(-1);
  const isLost = loss !== null && last !== undefined && last[2] !== null && last[2] <= loss, bumps = isBump ?? isLost;
  room.floor();
  room.solids(scene.solids.filter(([role]) => role === "goal"));
  room.walls(scene.walls);
  room.trail(trail, loss);
  room.rays(scene.beams, near);
  room.solids(scene.solids.filter(([role]) => role !== "goal"));
  if (scene.place) room.robot(scene.place, scene.outline, { isBump: bumps });
  if (scene.place && bumps && word) room.word(scene.place, word);
  if (bar) room.bar(bar, loss);
  return room.view;
}

class Room {
  // below: height that is kept free below the room [px]; seen: the canvas on the page, if this one is another layer of it
  constructor(canvas, bounds, colours, { below = 0, seen = canvas } = {}) {
    Object.assign(this, { bounds, colours, ...sharpCanvas(canvas, seen) });
    this.view = RoomView.of(bounds, this.width, this.height - below);
    this.below = below;
  }

  polygon(points) {
    this.context.beginPath();
    points.forEach(([x, y], i) => this.context[i ? "lineTo" : "moveTo"](x, y));
    this.context.closePath();
  }

  // A line between points of the room.
  line(points) {
    this.context.beginPath();
    points.forEach(([x, y], i) => this.context[i ? "lineTo" : "moveTo"](...this.view.at(x, y)));
    this.context.stroke();
  }

  // paint(context, view): what a page paints on the floor, within the walls
  floor(paint = null) {
    const { context, view } = this, [xMin, yMin, xMax, yMax] = this.bounds;
    context.save();
    context.fillStyle = this.colours.floor;
    this.polygon([[xMin, yMin], [xMax, yMin], [xMax, yMax], [xMin, yMax]].map(([x, y]) => view.at(x, y)));
    context.fill();
    context.clip();
    if (paint) paint(context, view);
    context.restore();
  }

  walls(polygons, colour = this.colours.wall) {
    this.context.fillStyle = colour;
    for (const points of polygons) {
      this.polygon(points.map(([x, y]) => this.view.at(x, y)));
      this.context.fill();
    }
  }

  // Goals are rings with their name; things and parts of robots are filled.
  solids(solids) {
    const { context, view, colours } = this, fills = { object: colours.orange, robot: colours.blue, wheel: colours.ink };
    for (const [role, points] of solids) {
      const at = points.map(([x, y]) => view.at(x, y));
      this.polygon(at);
      if (role !== "goal") {
        context.fillStyle = fills[role];
        context.fill();
        continue;
      }
      context.strokeStyle = context.fillStyle = colours.green;
      context.lineWidth = 3;
      context.stroke();
      const middle = [0, 1].map((i) => at.reduce((sum, point) => sum + point[i], 0) / at.length);
      this.text("goal", ...middle, { font: `600 16px ${ROOM_LETTERS}` });
    }
  }

  // The way: green where a step gained, grey where it cost a little, red where it lost, with a cross. fades: old steps are paler
  trail(steps, loss = null, { fades = false } = {}) {
    const { context, colours } = this, isLost = (r) => loss !== null && r !== null && r <= loss;
    const colourOf = (r) => (isLost(r) ? colours.red : r > 0 ? colours.green : colours.grey);
    context.lineJoin = context.lineCap = "round";
    context.strokeStyle = colours.floor; // a rim, so that it can be told from what lies on the floor
    context.lineWidth = 6;
    context.globalAlpha = 0.75;
    const pieces = [];
    for (const step of steps) step[2] === null || !pieces.length ? pieces.push([step]) : pieces.at(-1).push(step);
    pieces.forEach((piece) => this.line(piece));
    context.lineWidth = 2.5;
    const alphaOf = (i) => (fades ? 0.15 + 0.85 * Math.ceil((10 * i) / steps.length) / 10 : 1); // ten shades
    for (let i = 1; i < steps.length;) {
      if (steps[i][2] === null) { i += 1; continue; }
      const first = i, colour = colourOf(steps[i][2]), alpha = alphaOf(i);
      while (i < steps.length && steps[i][2] !== null && colourOf(steps[i][2]) === colour && alphaOf(i) === alpha) i += 1;
      context.strokeStyle = colour;
      context.globalAlpha = alpha;
      this.line(steps.slice(first - 1, i));
    }
    context.globalAlpha = 1;
    steps.forEach(([x, y, r], i) => { if (isLost(r)) this.cross(x, y, alphaOf(i)); });
  }

  // Where it bumped.
  cross(x, y, alpha = 1) {
    const { context, view, colours } = this, [left, top] = view.at(x, y);
    context.globalAlpha = alpha;
    context.strokeStyle = colours.red;
    context.lineWidth = 2.5;
    context.beginPath();
    for (const side of [-5, 5]) {
      context.moveTo(left - 5, top - side);
      context.lineTo(left + 5, top + side);
    }
    context.stroke();
    context.globalAlpha = 1;
  }

  // Rays that are near, each with a dot at its end.
  rays(beams, near = null) {
    const { context, view, colours } = this;
    context.strokeStyle = context.fillStyle = colours.orange;
    context.lineWidth = 2;
    beams.forEach(([x0, y0, x1, y1], i) => {
      const most = Array.isArray(near) ? near[i] : near ?? Infinity;
      if (!(Math.hypot(x1 - x0, y1 - y0) < most)) return;
      this.line([[x0, y0], [x1, y1]]);
      context.beginPath();
      context.arc(...view.at(x1, y1), 3, 0, 7);
      context.fill();
    });
  }

  // The robot: its outline in blue, with a nose; red in a ring at a bump.
  robot(place, outline, { isBump = false, isChosen = false } = {}) {
    const { context, view, colours } = this, from = (point) => view.seenFrom(place, point);
    const front = Math.max(...outline.map(([x]) => x)), wide = Math.max(...outline.map(([, y]) => y));
    if (isBump) {
      context.strokeStyle = colours.red;
      context.lineWidth = 3;
      context.beginPath();
      context.arc(...view.at(place[0], place[1]), Math.max(14, 1.7 * front * view.scale), 0, 7);
      context.stroke();
    }
    context.fillStyle = isBump ? colours.red : colours.blue;
    context.strokeStyle = isChosen ? colours.focus : colours.card;
    context.lineWidth = isChosen ? 4 : 2;
    context.lineJoin = "round";
    this.polygon(outline.map(from));
    context.fill();
    context.stroke();
    context.fillStyle = colours["on-blue"];
    this.polygon([[0.77 * front, 0], [0.2 * front, 0.53 * wide], [0.2 * front, -0.53 * wide]].map(from));
    context.fill();
  }

  // A word at the robot, above its ring, or below it where there is no room.
  word([x, y], text) {
    const [left, top] = this.view.at(x, y), far = Math.max(28, 0.62 * this.view.scale);
    const half = 5 * text.length, inside = Math.max(half, Math.min(this.width - half, left));
    this.context.fillStyle = this.colours.red;
    this.text(text, inside, top > far + 10 ? top - far : top + far, { font: `700 16px ${ROOM_LETTERS}`, behind: this.colours.floor });
  }

  // Letters in the present colour; behind: colour of a rim, so that they can be read on anything
  text(text, left, top, { font = `14px ${ROOM_LETTERS}`, align = "center", behind = null } = {}) {
    const { context } = this;
    Object.assign(context, { font, textAlign: align, textBaseline: "middle", lineJoin: "round" });
    if (behind) {
      Object.assign(context, { strokeStyle: behind, lineWidth: 4 });
      context.strokeText(text, left, top);
    }
    context.fillText(text, left, top);
    return context.measureText(text).width;
  }

  // Below the room: step, reward, one metre, and the sum so far.
  bar({ step, of, reward, sum }, loss = null) {
    const { context, colours, width, view } = this, top = this.height - this.below / 2 - 2;
    const signed = (x) => `${x > 0 ? "+" : ""}${+x.toPrecision(4)}`.replace("-", "−");
    const lost = loss !== null && reward <= loss, strong = `600 15px ${ROOM_LETTERS}`;
    context.fillStyle = colours.ink;
    let left = 8 + this.text(`step ${step}`, 4, top, { font: strong, align: "left" });
    context.fillStyle = colours.faint;
    if (of) left += 4 + this.text(`of ${of}`, left, top, { align: "left" });
    context.fillStyle = lost ? colours.red : reward > 0 ? colours.green : colours.faint;
    if (reward !== null) this.text(signed(reward), left + 10, top, { font: strong, align: "left" });
    context.fillStyle = colours.faint;
    this.text(`so far ${signed(sum).replace("+", "")}`, width - 4, top, { align: "right" });
    this.metre(width / 2 + 20, top);
    if (!of) return;
    context.fillStyle = colours.line;
    context.fillRect(0, this.height - 3, width, 3);
    context.fillStyle = colours.blue;
    context.fillRect(0, this.height - 3, (width * step) / of, 3);
  }

  // One metre, or ten centimetres where the room is small, around a point of the canvas.
  metre(middle, top) {
    const { context, colours, view } = this, [long, text] = view.scale < this.width / 2 ? [view.scale, "1 m"] : [view.scale / 10, "10 cm"];
    context.strokeStyle = colours.faint;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(middle - long / 2, top + 7);
    context.lineTo(middle + long / 2, top + 7);
    context.stroke();
    context.fillStyle = colours.faint;
    this.text(text, middle, top - 3, { font: `13px ${ROOM_LETTERS}` });
  }
}
