// What stands around meshcat's viewer: its size, a bar with time and chase camera, the curve of the rewards.
const [view, bar, replay, play, time, caption, live, chase, chart, hint, packed] =
  ["view", "bar", "replay", "play", "time", "caption", "live", "chase", "chart", "hint", "packed"].map(id => document.getElementById(id));
const MEAN_OF = 50;  // steps
let viewer, rate = 30, rewards = [], means = [], count = 0, last = 0, at = 0, shown;
let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
if (self === top) document.documentElement.classList.add(location.hash === "#still" ? "still" : "alone");

// A page that is photographed is loaded only when all is drawn: a document that is being written holds it up.
const still = document.documentElement.classList.contains("still"), pending = still && document.createElement("iframe");
if (still) {
  document.body.append(pending);
  pending.contentDocument.open();
}

function say(text) {
  bar.hidden = false;
  replay.hidden = chase.hidden = true;
  caption.textContent = text;
}

async function unpack() {
  const bytes = Uint8Array.from(atob(packed.textContent), sign => sign.charCodeAt());
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

function begin() {
  try { viewer = new MeshCat.Viewer(view); }
  catch (error) { say("This browser shows no 3D pictures: WebGL is switched off."); throw error; }
  viewer.gui.domElement.style.display = "none";
  viewer.controls.dispose();
  const take = viewer.set_camera.bind(viewer), resize = viewer.set_3d_pane_size.bind(viewer);
  viewer.set_camera = camera => {
    viewer.controls.dispose();
    take(camera);
    Object.assign(viewer.controls, {enableZoom: false, maxPolarAngle: 0.49 * Math.PI});
    aimAtTarget(viewer.controls, camera);
  };
  viewer.set_3d_pane_size = () => {
    const {clientWidth: w, clientHeight: h} = view;
    if (!w || !h) return;  // hidden: from an aspect of 0 no camera comes back
    viewer.camera.zoom = Math.min(1, w / h / 1.25);  // narrow, and the whole width is still seen
    resize(w, h);
    viewer.render();  // another size has wiped the picture
  };
  const load = viewer.set_animation.bind(viewer);
  viewer.set_animation = (animations, options) => {
    rate = animations[0]?.clip.fps ?? rate;
    animations.forEach(jumpIfBeam);
    load(animations, options);
    for (const action of viewer.animator.actions) action.play();
    viewer.animator.playing = false;  // the time is this bar's
    last = Math.round(viewer.animator.duration * rate);
    time.max = last + 1;
    if (!playing) at = last;  // without motion it opens with the whole way
    followLink();
  };
  new ResizeObserver(viewer.set_3d_pane_size).observe(view);
}

// The controls keep their target in the frame of Cameras/default, but turn the camera as if that were the world's.
function aimAtTarget(controls, camera) {
  const update = controls.update.bind(controls);
  controls.update = () => {
    const hasMoved = update();
    if (!camera.parent) return hasMoved;  // it is not in the scene yet
    camera.parent.updateWorldMatrix(true, false);
    camera.lookAt(camera.parent.localToWorld(controls.target.clone()));
    return hasMoved;
  };
}

// A laser measures at whole steps: between two of them its beam stays as it was measured.
function jumpIfBeam({path, clip}) {
  if (!path.includes("beams")) return;  // a list of names
  for (const track of clip.tracks) {
    track.interpolation = MeshCat.THREE.InterpolateDiscrete;
    for (const key of track.keys) key.time -= 0.001;  // of a step: three.js rounds times, and a beam must not come late
  }
}

// Meshcat's commands, and the rewards of the steps: the last ones of `steps`
function hear(commands, paid, steps) {
  for (const command of commands) viewer.handle_command_bytearray(command);
  [rewards, count] = [paid, steps];
  let sum = 0;
  means = rewards.map((r, i) => (sum += r - (rewards[i - MEAN_OF] ?? 0)) / Math.min(i + 1, MEAN_OF));
  replay.hidden = !last;
  chase.hidden = !body();
  bar.hidden = !last && !count;
  chart.hidden = rewards.length < 3;
  shown = undefined;
}

// Time

const node = path => path.reduce((it, name) => it?.children[name], viewer.scene_tree)?.object;
const body = () => node(["meshcat", "robot", "body"]);
const number = () => last ? Math.min(Math.floor(at + 1e-6), last) + 1 : count;
const signed = (number, digits) => (number < 0 ? "−" : "+") + Math.abs(+number.toPrecision(digits));

function show() {
  const step = number(), i = last ? step - 1 : rewards.length - 1;
  if (last) {
    viewer.animator.seek(Math.min(at, last) / rate);
    node(["meshcat", "trail", "<object>"])?.geometry.setDrawRange(0, 6 * i);  // it grows with the way
    time.value = step;
  }
  shown = at;
  caption.textContent = `step ${step}` + (last ? ` of ${last + 1}` : "");
  if (i in rewards) caption.textContent += `: reward ${signed(rewards[i], 4)} · mean of the last ${Math.min(step, MEAN_OF)}: ${signed(means[i], 2)}`;
  if (!chart.hidden) plot(i);
  viewer.set_dirty();
}

function go(step) {
  playing = false;
  at = Math.min(Math.max(step - 1, 0), last);
  settle();
}
const moves = {
  first: () => go(1), back: () => go(number() - 1), step: () => go(number() + 1), last: () => go(last + 1),
  play: () => {
    playing = !playing;
    if (!playing) at = Math.min(Math.round(at), last);  // what is told is true of whole steps
    settle();
  },
};
const keys = {ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last"};
function followLink() {
  if (location.hash === "#still") go(last + 1);
  if (/^#\d+$/.test(location.hash)) go(+location.hash.slice(1));
}
let rest;
function settle() {  // what is said aloud where it stands still
  clearTimeout(rest);
  rest = setTimeout(() => {
    if (playing) return;
    live.textContent = caption.textContent;
    if (self === top) history.replaceState(null, "", "#" + number());  // a frame in a notebook has no address
  }, 500);
}
for (const button of document.querySelectorAll("#replay button")) button.onclick = moves[button.name];
document.onkeydown = event => {
  const name = keys[event.key], isButtons = event.key === " " && event.target.closest("button");
  if (!last || !name || event.ctrlKey || event.altKey || event.metaKey || isButtons) return;
  event.preventDefault();
  moves[name]();
};
time.oninput = () => go(+time.value);
addEventListener("hashchange", followLink);

// Camera and pointer

const chasing = () => chase.getAttribute("aria-pressed") === "true";
const yaw = q => Math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
let heading = 0, height = 0, whole;
function follow(seconds) {  // the camera's frame, Cameras/default, moves with the robot
  const {position: {x, y, z}, quaternion} = body(), aim = node(["Cameras", "default"]);
  const turn = Math.atan2(Math.sin(yaw(quaternion) - heading), Math.cos(yaw(quaternion) - heading));
  heading += turn * (1 - Math.exp(-2.5 * seconds));
  aim.position.set(x, y, Math.max(z, 0.4 * height));
  aim.rotation.set(0, 0, heading);
}
chase.onclick = () => {
  chase.setAttribute("aria-pressed", !chasing());
  chase.textContent = chasing() ? "Whole room" : "Chase camera";
  const {camera, controls} = viewer, aim = node(["Cameras", "default"]), robot = node(["meshcat", "robot"]);
  viewer.set_dirty();
  if (!chasing()) {
    aim.position.copy(whole.aim);
    aim.rotation.set(0, 0, 0);
    camera.position.copy(whole.eye);
    controls.target.copy(whole.target);
    return;
  }
  whole = {aim: aim.position.clone(), eye: camera.position.clone(), target: controls.target.clone()};
  controls.target.set(0, 0, 0);
  heading = yaw(body().quaternion);
  height = new MeshCat.THREE.Box3().setFromObject(robot).max.y;
  const rolls = robot.children.some(({name}) => name.endsWith("_wheel"));
  const back = rolls ? 1.1 + 0.8 * height : 1.8 * height, from = rolls ? Math.PI : -1.2;  // from behind an arm would hide its own gripper
  camera.position.set(back * Math.cos(from), 0.6 * back, -back * Math.sin(from));
  follow(0);
};
// the wheel scrolls the page until somebody clicks into the picture
view.addEventListener("pointerdown", () => { viewer.controls.enableZoom = hint.hidden = true; });
view.addEventListener("pointerleave", () => { viewer.controls.enableZoom = false; hint.hidden = true; });
view.addEventListener("wheel", () => { hint.hidden = viewer.controls.enableZoom; }, {passive: true});

let then = performance.now();
function tick(now) {
  const seconds = Math.min(0.5, Math.max(0, now - then) / 1000);
  then = now;
  if (playing && last) at = at > last + rate ? 0 : at + seconds * rate;  // at the end it rests for a second
  play.textContent = playing ? "‖ Pause" : "▶▶ Play";
  if (at !== shown) show();
  if (chasing() && body()) { follow(seconds); viewer.set_dirty(); }
  requestAnimationFrame(tick);
}

// The curve of the moving average, up to the reward of number i
function plot(i) {
  const pen = chart.getContext("2d"), [w, h, left, above] = [chart.width, chart.height, 58, 34];
  const low = Math.min(0, ...means), high = Math.max(0, ...means), y = v => above + (high - v) / (high - low || 1) * (h - above - 16);
  pen.clearRect(0, 0, w, h);
  pen.font = "20px sans-serif";
  pen.fillStyle = "#fff";
  pen.fillText(`mean reward, last ${MEAN_OF} steps`, 12, 22);
  for (const v of new Set([low, 0, high])) {
    pen.fillStyle = "#c3c9d1";
    if (v === 0 || Math.abs(y(v) - y(0)) > 24) pen.fillText(signed(v, 2).replace(/^\+0$/, "0"), 8, y(v) + 7);
    pen.fillStyle = v ? "#4a515a" : "#8a929c";
    pen.fillRect(left, y(v), w - left - 10, 1);
  }
  pen.beginPath();
  means.slice(0, i + 1).forEach((v, k) => pen.lineTo(left + k / Math.max(1, means.length - 1) * (w - left - 14), y(v)));
  pen.strokeStyle = "#f0e442";
  pen.lineWidth = 4;
  pen.stroke();
}

unpack().then(([library, commands, paid]) => {
  document.head.append(Object.assign(document.createElement("script"), {textContent: library}));
  onmessage = null;  // meshcat's GIF encoder would take each message for a frame, answer it to itself, and so on for ever
  begin();
  hear(commands.map(text => Uint8Array.from(atob(text), sign => sign.charCodeAt())), paid, paid.length);
  requestAnimationFrame(tick);
  if (still) requestAnimationFrame(() => requestAnimationFrame(() => { pending.contentDocument.close(); pending.remove(); }));
  addEventListener("message", ({source, data}) => {
    if (source !== parent) return;
    hear(data.commands.map(({buffer, byteOffset, byteLength}) => new Uint8Array(buffer, byteOffset, byteLength)), data.rewards, data.count);
  });
  if (self !== top) parent.postMessage("ready", "*");  // what came before is told now
}).catch(error => {
  if (bar.hidden) say("This page cannot be unpacked: the browser is older than 2023, or the file is damaged.");
  throw error;
});
