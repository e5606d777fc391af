// Time, camera and pointer: a replay of the feed's frames, or the frames as a server tells them.
const element = id => document.getElementById(id);
const [view, bar, replay, play, time, caption, live, scale, chase, chart, hint] =
  ["view", "bar", "replay", "play", "time", "caption", "live", "scale", "chase", "chart", "hint"].map(element);
const LONGEST = 2000;  // frames that a live view keeps
if (self === top) document.documentElement.classList.add("alone");

function say(text) {
  bar.hidden = false;
  replay.hidden = scale.hidden = chase.hidden = true;
  caption.textContent = text;
}
let viewer;
try { viewer = new MeshCat.Viewer(view, false); }
catch (error) { say("This browser shows no 3D pictures: WebGL is switched off."); throw error; }
viewer.gui.domElement.style.display = "none";
viewer.set_3d_pane_size = () => {};  // the size is ours
const {renderer} = viewer, camera = new T.PerspectiveCamera(35, 1, 0.01, 100);
viewer.controls.dispose();
camera.up.set(0, 0, 1);
const controls = new viewer.controls.constructor(camera, view);
Object.assign(controls, {enableZoom: false, maxPolarAngle: 0.49 * Math.PI, screenSpacePanning: true});
renderer.outputEncoding = T.sRGBEncoding;
renderer.shadowMap.type = T.PCFShadowMap;

let scene, world, robot = {}, beams = [], trail, frames = [], rewards = [], at = 0, moved = true, touched = false;
let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;

// The room

function build(room, {places}) {
  for (const solid of room.solids) solid.pose ??= places[solid.name];
  scene = new T.Scene();
  world = {...surroundings(room), room, obstacles: []};
  world.group.traverse(it => { if (it.isMesh) world.obstacles.push(it); });
  scene.add(world.group);
  lamps(scene, room.bounds, world.span);
  robot = {};
  for (const solid of room.solids.filter(({role}) => role !== "wall")) {
    robot[solid.name] = new T.Group().add(...parts(solid, room.colours));
    setPlace(robot[solid.name], solid.pose);
    scene.add(robot[solid.name]);
  }
  world.rolls = room.solids.some(({name}) => name.endsWith("_wheel"));
  const top = Math.max(...room.solids.filter(({name}) => name.startsWith("robot")).map(({pose, size}) => pose[11] + size.at(-1) / 2));
  world.middle = top / 2;
  world.back = world.rolls ? 1.1 + 0.8 * top : 0.9 * world.span;
  [beams, frames, rewards, at] = [[], [], [], 0];
  trail = new T.Mesh(new T.BufferGeometry(), new T.MeshBasicMaterial({vertexColors: true, side: T.DoubleSide, transparent: true, depthWrite: false}));
  trail.frustumCulled = false;
  scene.add(trail);
  scale.textContent = `grid ${world.cell} m`;
  touched = false;
  fit();
}

// The camera sees the floor and the walls, and of what is high the middle of the room
function fit() {
  const {room: {solids, bounds: [x0, y0, x1, y1]}, base, onTable} = world, high = Math.max(...solids.map(({pose, size}) => pose[11] + size.at(-1) / 2));
  const points = base.flatMap(([x, y]) => [-0.03, Math.min(high, 0.4)].map(z => new T.Vector3(x, y, z)));
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2], [l, w] = [x1 - x0, y1 - y0].map(v => 0.3 * v);
  for (const [dx, dy] of rectangle(l, w)) points.push(new T.Vector3(x + dx, y + dy, high));
  const [turn, rise] = onTable ? [0.35, 0.55] : [0, 1];
  const back = new T.Vector3(Math.sin(turn) * Math.cos(rise), -Math.cos(turn) * Math.cos(rise), Math.sin(rise));
  const right = new T.Vector3(Math.cos(turn), Math.sin(turn), 0), up = back.clone().cross(right);
  const tall = Math.tan(camera.fov * Math.PI / 360), wide = tall * camera.aspect, target = new T.Vector3(x, y, 0);
  let distance = 0;
  for (let i = 0; i < 12; i++) {
    const seen = points.map(point => point.clone().sub(target)).map(p => [p.dot(right), p.dot(up), p.dot(back)]);
    distance = 1.05 * Math.max(...seen.map(([r, u, b]) => b + Math.max(Math.abs(r) / wide, Math.abs(u) / tall)));
    const [across, along] = [0, 1].map(k => seen.map(p => p[k] / (distance - p[2])));
    target.addScaledVector(right, (Math.max(...across) + Math.min(...across)) / 2 * distance);
    target.addScaledVector(up, (Math.max(...along) + Math.min(...along)) / 2 * distance);
  }
  Object.assign(camera, {near: distance / 100, far: distance * 10});
  controls.target.copy(target);
  camera.position.copy(target).addScaledVector(back, distance);
  camera.updateProjectionMatrix();
  controls.update();
  moved = true;
}

function resize() {
  const {clientWidth: w, clientHeight: h} = view;
  if (!w || !h) return;  // hidden: from an aspect of 0 no camera comes back
  renderer.setSize(w, h);
  camera.aspect = w / h;
  camera.updateProjectionMatrix();
  if (world && !touched && !chasing()) fit();
  if (scene) renderer.render(scene, camera);  // another size has wiped the picture
  moved = true;
}

// Frames

function add(told) {
  for (const frame of told) {
    const poses = {};
    for (const [name, numbers] of Object.entries(frame.places)) setPlace(poses[name] = new T.Object3D(), numbers);
    const leader = poses["robot/body"], before = frames.at(-1);
    const rays = frame.beams.map(([start, end]) => {
      const [from, to] = [start, end].map(p => new T.Vector3(...p)), length = from.distanceTo(to);
      const way = length > 1e-6 ? to.clone().sub(from).divideScalar(length) : new T.Vector3(1, 0, 0);
      if (!leader) return {from, way, length};
      const back = leader.quaternion.clone().invert();
      return {from: from.sub(leader.position).applyQuaternion(back), way: way.applyQuaternion(back), length};
    });
    // too far for one step: it was put back to the start
    const jumps = before && leader && leader.position.distanceTo(before.poses["robot/body"].position) > 0.25 * world.span;
    if (isStep(frame)) rewards = [...rewards, frame.reward].slice(-MEAN_OF);
    const mean = rewards.reduce((sum, r) => sum + r, 0) / rewards.length;
    frames.push({...frame, step: frame.step ?? frames.length + 1, poses, leader, rays, jumps, mean});
  }
  while (feed.live && frames.length > LONGEST) {
    frames.shift();
    at = Math.max(0, at - 1);
  }
  if (told.length && frames[0].leader) lay();
  moved = true;
}

const caster = new T.Raycaster(), hair = new T.CylinderGeometry(0.5, 0.5, 1, 6).rotateZ(Math.PI / 2), ball = new T.SphereGeometry(1, 10, 8);
function beam(i) {
  if (beams[i]) return beams[i];
  const red = colour(world.room.colours.beam), material = new T.MeshBasicMaterial({color: red, opacity: 0.6, transparent: true, depthWrite: false});
  beams[i] = {line: new T.Mesh(hair, material), hit: new T.Mesh(ball, new T.MeshBasicMaterial({color: red}))};
  scene.add(beams[i].line, beams[i].hit);
  return beams[i];
}

// How everything is at a time between two frames. A beam goes on to the next wall: half way between two lengths it may end in the air.
function show() {
  const last = frames.length - 1, i = Math.min(Math.floor(at), last), a = frames[i], b = frames[Math.min(i + 1, last)];
  const part = b.jumps ? 0 : at - i;
  for (const [name, group] of Object.entries(robot)) {
    const [from, to] = [a.poses[name], b.poses[name]];
    if (!from || !to) continue;
    group.position.lerpVectors(from.position, to.position, part);
    group.quaternion.slerpQuaternions(from.quaternion, to.quaternion, part);
  }
  const leader = robot["robot/body"] ?? new T.Group(), ahead = new T.Vector3(1, 0, 0);
  const width = camera.position.distanceTo(leader.position) / 350;  // the same on the screen near and far
  a.rays.forEach((ray, k) => {
    const {line, hit} = beam(k), start = ray.from.clone(), way = ray.way.clone();
    if (a.leader) { start.applyQuaternion(leader.quaternion).add(leader.position); way.applyQuaternion(leader.quaternion); }
    let length = ray.length;
    if (part > 0) {
      caster.set(start, way);
      length = caster.intersectObjects(world.obstacles)[0]?.distance ?? Math.max(length, b.rays[k]?.length ?? 0);
    }
    line.scale.set(Math.max(length, 1e-6), width, width);
    line.quaternion.setFromUnitVectors(ahead, way);
    line.position.copy(start).addScaledVector(way, length / 2);
    hit.scale.setScalar(1.3 * width);
    hit.position.copy(start).addScaledVector(way, length);
  });
  trail.geometry.setDrawRange(0, 6 * i);
  if (a !== shown) tell(a);
}

// What stands beside the picture

let shown, ended = false;
function tell(frame) {
  shown = frame;
  if (ended) return;
  const of = feed.live ? "" : ` of ${frames.length}`, rewarded = isStep(frame);
  const mean = rewarded ? ` · mean of the last ${Math.min(MEAN_OF, frame.step)}: ${signed(+frame.mean.toFixed(2), 4)}` : "";
  const told = rewarded ? `: reward ${signed(frame.reward, 4)}${mean}` : "";
  caption.textContent = frame.step ? `step ${frame.step}${of}${told}` : "";  // a live view before the first step
  time.value = frames.indexOf(frame) + 1;
  bar.hidden = frames.length < 2 && !feed.live;
  chart.hidden = !rewarded || frames.length < 3;
  if (!chart.hidden) plot(frame);
}

// Camera and pointer

const chasing = () => chase.getAttribute("aria-pressed") === "true";
const yaw = q => Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
// What the chase camera looks at: the middle of the robot's height, which may be far above its body
const aim = ({x, y, z}) => new T.Vector3(x, y, Math.max(z, world.middle));
let heading = 0;
function follow(seconds) {
  const {position, quaternion} = robot["robot/body"], turn = Math.atan2(Math.sin(yaw(quaternion) - heading), Math.cos(yaw(quaternion) - heading));
  const soft = turn * (1 - Math.exp(-2.5 * seconds)), offset = camera.position.clone().sub(controls.target);
  heading += soft;
  controls.target.copy(aim(position));
  camera.position.copy(controls.target).add(offset.applyAxisAngle(new T.Vector3(0, 0, 1), soft));
  moved = moved || Math.abs(soft) > 1e-4;
}
chase.onclick = () => {
  chase.setAttribute("aria-pressed", !chasing());
  chase.textContent = chasing() ? "Whole room" : "Chase camera";
  if (!chasing()) return fit();
  const {position, quaternion} = robot["robot/body"], back = world.back;
  heading = yaw(quaternion);
  controls.target.copy(aim(position));
  const from = heading + (world.rolls ? Math.PI : -1.2);  // from behind; an arm would hide its own gripper
  camera.position.copy(controls.target).add(new T.Vector3(back * Math.cos(from), back * Math.sin(from), 0.6 * back));
  camera.near = back / 50;
  moved = true;
};
controls.addEventListener("start", () => { touched = true; });
controls.addEventListener("change", () => { moved = true; });
// the wheel scrolls the page until somebody clicks into the picture
view.addEventListener("pointerdown", () => { controls.enableZoom = hint.hidden = true; });
view.addEventListener("pointerleave", () => { controls.enableZoom = false; hint.hidden = true; });
view.addEventListener("wheel", () => { hint.hidden = controls.enableZoom; }, {passive: true});
time.oninput = () => {
  playing = false;
  at = time.value - 1;
  moved = true;
};

let then = performance.now();
function tick(now) {
  const seconds = Math.min(0.5, Math.max(0, now - then) / 1000), last = frames.length - 1, before = at;
  then = now;
  if (feed.live) at = Math.min(last, at + seconds * Math.max(1 / (frames[last]?.seconds || 1e-3), (last - at - 1) / 0.3));
  else if (playing && last > 0) at = at > last + 1 / feed.seconds ? 0 : at + seconds / feed.seconds;  // at the end it rests for a second
  play.textContent = playing ? "‖ Pause" : "▶▶ Play";
  moved = moved || (at !== before && before <= last);
  if (last >= 0 && moved) show();
  if (chasing() && robot["robot/body"]) follow(seconds);
  if (moved && scene) {
    moved = false;
    controls.update();
    renderer.render(scene, camera);
  }
  requestAnimationFrame(tick);
}

function take(news) {
  if (news.frames.length && news.room) build(news.room, news.frames[0]);
  if (world) add(news.frames);
  if (news.frames.length && news.room) at = Math.max(0, frames.length - 2);
}

function end() {
  ended = true;
  say("The live view has ended.");
}
new ResizeObserver(resize).observe(view);
if (feed.live) {
  replay.hidden = true;
  addEventListener("message", ({source, data}) => {
    if (source !== parent || ended) return;
    take(data);
    if (data.closed) end();
  });
  parent.postMessage("ready", "*");  // what came before is told now
} else if (feed.room) {
  build(feed.room, feed.frames.at(-1));
  add(feed.frames);
  time.max = frames.length;
  chase.hidden = !robot["robot/body"];
}
requestAnimationFrame(tick);
