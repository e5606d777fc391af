// What a room, the things in it and its robot look like. Lengths in metres; z points upward.
const T = MeshCat.THREE;
const colour = code => new T.Color(code).convertSRGBToLinear();
const matt = (code, more = {}) => new T.MeshLambertMaterial({color: colour(code), ...more});
const glossy = code => new T.MeshPhongMaterial({color: colour(code), specular: 0x2a2a2a, shininess: 40});
const DARK = glossy("#24272c"), METAL = glossy("#a9b0b8"), RUBBER = matt("#1b1c1e");

function mesh(geometry, material, x = 0, y = 0, z = 0) {
  const it = new T.Mesh(geometry, material);
  it.position.set(x, y, z);
  it.castShadow = it.receiveShadow = true;
  return it;
}

// An upright prism about the origin on a convex base [[x, y], …]; bevel: width of its broken edges
function prism(base, height, bevel = 0) {
  const shape = new T.Shape(base.map(([x, y]) => new T.Vector2(x, y)));
  const cut = {bevelSize: bevel, bevelThickness: bevel, bevelOffset: -bevel, bevelSegments: 2, bevelEnabled: bevel > 0};
  return new T.ExtrudeGeometry(shape, {depth: height - 2 * bevel, ...cut}).translate(0, 0, bevel - height / 2);
}
const rectangle = (l, w) => [[l / 2, w / 2], [-l / 2, w / 2], [-l / 2, -w / 2], [l / 2, -w / 2]];
const box = (l, w, h, bevel = 0) => prism(rectangle(l, w), h, bevel);
const cylinder = (radius, height) => new T.CylinderGeometry(radius, radius, height, 48).rotateX(Math.PI / 2);
const pairs = numbers => Array.from({length: numbers.length >> 1}, (_, i) => numbers.slice(2 * i, 2 * i + 2));

function plain({shape, size}) {
  if (shape === "box") return box(...size, Math.min(0.01, 0.2 * Math.min(...size)));
  if (shape === "cylinder") return cylinder(...size);
  if (shape === "sphere") return new T.SphereGeometry(size[0], 32, 24);
  return prism(pairs(size.slice(0, -1)), size.at(-1));
}

// A Pioneer: a slim body between the wheels, a band of sonars, and a dark deck as wide as what bumps into walls
function pioneer({size}, coat) {
  const hull = pairs(size.slice(0, -1)), height = size.at(-1), waist = 0.66 * Math.max(...hull.map(([, y]) => y));
  const slim = hull.map(([x, y]) => [x * 0.96, Math.max(-waist, Math.min(waist, y))]);
  const parts = [
    mesh(prism(slim, height, 0.012), coat),
    mesh(prism(hull, 0.016, 0.006), DARK, 0, 0, height / 2),
    mesh(new T.SphereGeometry(0.035, 16, 12), RUBBER, -0.2, 0, -height / 2 - 0.045),
  ];
  for (const end of [1, -1]) {
    const rim = hull.filter(([x]) => x * end > 0.12).map(([x, y]) => [0.99 * x, 0.85 * y]);
    parts.push(mesh(prism(rim.concat([[0.1 * end, rim.at(-1)[1]], [0.1 * end, rim[0][1]]]), 0.05, 0.004), DARK, 0, 0, 0.04));
    for (let angle = -75; angle <= 75; angle += 30) {
      const [c, s] = [Math.cos(angle * Math.PI / 180), Math.sin(angle * Math.PI / 180)];
      const eye = mesh(cylinder(0.017, 0.006).rotateY(Math.PI / 2), glossy("#d9b45b"), end * (0.155 + 0.1 * c), 0.14 * s, 0.04);
      eye.rotation.z = Math.atan2(s, end * c);
      parts.push(eye);
    }
  }
  return parts;
}

function wheel({size: [radius, width]}) {
  const parts = [mesh(cylinder(radius, width), RUBBER), mesh(cylinder(0.62 * radius, width + 0.006), METAL)];
  for (let i = 0; i < 5; i++) {  // holes, so that one sees it turn
    const [x, y] = [Math.cos(i * 0.4 * Math.PI), Math.sin(i * 0.4 * Math.PI)].map(v => 0.38 * radius * v);
    parts.push(mesh(cylinder(0.12 * radius, width + 0.01), DARK, x, y));
  }
  return parts;
}

// The screen of a telepresence robot, with somebody on it
function screen({size: [l, w, h]}) {
  const canvas = Object.assign(document.createElement("canvas"), {width: 160, height: 200}), pen = canvas.getContext("2d");
  const disc = (x, y, r, code) => { pen.fillStyle = code; pen.beginPath(); pen.arc(x, y, r, 0, 7); pen.fill(); };
  pen.fillStyle = "#cfe8f7";
  pen.fillRect(0, 0, 160, 200);
  disc(80, 215, 75, "#0b4f7d");
  disc(80, 92, 42, "#e3b98f");
  disc(65, 85, 5, "#222");
  disc(95, 85, 5, "#222");
  pen.beginPath();
  pen.arc(80, 98, 17, 0.4, 2.7);
  pen.lineWidth = 4;
  pen.stroke();
  const map = Object.assign(new T.CanvasTexture(canvas), {encoding: T.sRGBEncoding});
  const face = mesh(new T.PlaneGeometry(0.85 * w, 0.85 * h), new T.MeshBasicMaterial({map}), l / 2 + 0.002);
  face.rotation.set(Math.PI / 2, Math.PI / 2, 0);
  return [mesh(box(l, w, h, 0.008), matt("#dfe3e8")), mesh(box(0.002, 0.94 * w, 0.94 * h), DARK, l / 2), face];
}

// The parts of a solid, in its own frame
function parts(solid, colours) {
  const {name, shape, role, size} = solid, coat = glossy(colours[role]);
  if (role === "goal") {
    const ring = new T.Mesh(new T.TorusGeometry(size[0], 0.012, 8, 64), matt(colours.goal));
    return [Object.assign(mesh(cylinder(...size), matt(colours.goal, {opacity: 0.4, transparent: true})), {castShadow: false}), ring];
  }
  if (role === "wheel" && shape === "cylinder") {
    if (name.endsWith("_wheel")) return wheel(solid);
    return [mesh(plain(solid), DARK), mesh(cylinder(0.6 * size[0], 1.08 * size[1]), METAL)];  // a servo in a joint
  }
  if (role === "wheel") return [mesh(plain(solid), DARK)];
  if (name === "robot/nose") {  // an arrow, to tell front from back
    const [l, w, h] = size;
    const arrow = [[l / 4, 0], [-0.75 * l, w], [-l / 2, 0], [-0.75 * l, -w]];
    return [mesh(prism(arrow, 0.012), matt("#fff"), 0, 0, -h / 2 + 0.014)];
  }
  if (name === "robot/body" && shape === "prism") return pioneer(solid, coat);
  if (name === "robot/screen") return screen(solid);
  if (name === "robot/body" && shape === "cylinder") {
    const [r, h] = size;
    const bumper = mesh(cylinder(r, 0.3 * h), DARK, 0, 0, -0.2 * h);
    return [mesh(cylinder(0.97 * r, h), coat), bumper, mesh(cylinder(0.8 * r, 0.006), matt("#2a6f9e"), 0, 0, h / 2 + 0.003)];
  }
  return [mesh(plain(solid), coat)];
}

// What is left of a convex polygon [[x, y], …] where nx·x + ny·y ≤ d
function clipped(polygon, [nx, ny, d]) {
  const over = ([x, y]) => nx * x + ny * y - d;
  return polygon.flatMap((a, i) => {
    const b = polygon[(i + 1) % polygon.length], u = over(a), v = over(b), keep = u <= 1e-9 ? [a] : [];
    return u * v < -1e-12 ? [...keep, [0, 1].map(k => a[k] + (b[k] - a[k]) * u / (u - v))] : keep;
  });
}

// The floor and the walls: what sticks out over the outside of an outer wall is cut off
function surroundings({bounds, solids}) {
  const walls = solids.filter(({name}) => name.startsWith("wall")).map(solid => {
    const [c, , , x, s, , , y] = solid.pose, [l, w] = solid.size;
    return {...solid, x, y, corners: rectangle(l, w).map(([a, b]) => [x + c * a - s * b, y + s * a + c * b]), side: [-s, c, w / 2]};
  });
  const faces = walls.flatMap(({x, y, side: [nx, ny, half]}) => [1, -1].map(k => [k * nx, k * ny, k * (nx * x + ny * y) + half]));
  const outer = faces.filter(([nx, ny, d]) => walls.every(({x, y}) => nx * x + ny * y <= d));
  const [x0, y0, x1, y1] = bounds, span = Math.max(x1 - x0, y1 - y0), cell = span > 1.8 ? 0.5 : span > 0.8 ? 0.25 : 0.05;
  const edge = walls.length ? 1 : 0;
  let base = [[x1 + edge, y1 + edge], [x0 - edge, y1 + edge], [x0 - edge, y0 - edge], [x1 + edge, y0 - edge]];
  base = outer.reduce(clipped, base);
  const group = new T.Group(), solid = new T.Group(), thick = walls.length ? 0.02 : 0.03, onTable = !walls.length;
  const side = matt(onTable ? "#8a5f38" : "#a39d90"), top = matt("#ffffff", {map: tiles(cell, onTable)});
  group.add(mesh(prism(base, thick), [top, side], 0, 0, -thick / 2 - span / 4000));
  const wallPaint = matt("#8793a1"), line = new T.LineBasicMaterial({color: 0x2b3138, opacity: 0.5, transparent: true});
  for (const {name, corners, size: [, , h]} of walls) {
    const wall = mesh(prism(outer.reduce(clipped, corners), h), wallPaint, 0, 0, h / 2);
    wall.add(new T.LineSegments(new T.EdgesGeometry(wall.geometry), line));
    solid.add(wall);
  }
  for (const {name, size: [l, w, h], pose, role} of solids.filter(({name, role}) => role === "wall" && !name.startsWith("wall"))) {
    const it = new T.Group();
    const [board, below] = [box(l, w, 0.03, 0.005), box(0.97 * l, 0.96 * w, h - 0.03)];
    if (name === "table") it.add(mesh(board, matt("#c08b55"), 0, 0, h / 2 - 0.015), mesh(below, matt("#8a5f38"), 0, 0, -0.015));
    else it.add(mesh(box(l, w, h), matt("#e6dfc8")));
    setPlace(it, pose);
    solid.add(it);
  }
  group.add(solid);
  return {group, span, cell, base, onTable};
}

// The floor's pattern: a line every `cell` metres
function tiles(cell, wood) {
  const canvas = Object.assign(document.createElement("canvas"), {width: 128, height: 128}), pen = canvas.getContext("2d");
  pen.fillStyle = wood ? "#c9976a" : "#d3cdbf";
  pen.fillRect(0, 0, 128, 128);
  pen.strokeStyle = wood ? "#b98557" : "#b1aa9a";
  pen.lineWidth = 4;
  pen.strokeRect(0, 0, 128, 128);
  const map = new T.CanvasTexture(canvas);
  map.wrapS = map.wrapT = T.RepeatWrapping;
  map.repeat.set(1 / cell, 1 / cell);
  return Object.assign(map, {encoding: T.sRGBEncoding, anisotropy: 8});
}

function setPlace(object, numbers) {
  new T.Matrix4().set(...numbers, 0, 0, 0, 1).decompose(object.position, object.quaternion, new T.Vector3());
}

function lamps(scene, [x0, y0, x1, y1], span) {
  const sun = new T.DirectionalLight("#fff6e8", 0.68), [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2], reach = 0.9 * span;
  sun.position.set(x - 0.7 * span, y - 0.5 * span, 1.9 * span);
  sun.target.position.set(x, y, 0);
  sun.castShadow = true;
  sun.shadow.mapSize.set(1024, 1024);
  Object.assign(sun.shadow.camera, {left: -reach, right: reach, top: reach, bottom: -reach, near: 0.05 * span, far: 5 * span});
  Object.assign(sun.shadow, {bias: -0.0004, normalBias: 0.002 * span, radius: 3});
  scene.add(sun, sun.target, new T.HemisphereLight("#f4f8ff", "#98917f", 0.55));
}
