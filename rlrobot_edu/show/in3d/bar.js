// What stands around meshcat's viewer: its size, what it is told, and a bar with the time.
const [view, bar, replay, play, time, caption, live, turn, chase, flat, plan, chart, hint, finding, key, lit, strip, marks, library, scene, paid] =
  ["view", "bar", "replay", "play", "time", "caption", "live", "turn", "chase", "flat", "plan", "chart", "hint", "finding", "key", "lit", "strip", "marks", "library", "scene", "paid"]
    .map(id => document.getElementById(id));
const MEAN_OF = 50;  // steps
let viewer, rate = 30, rewards = [], sums = [], means = [], notes = [], count = 0, last = 0, at = 0, shown, opens, opensAt;
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
  replay.hidden = turn.hidden = chase.hidden = flat.hidden = true;
  caption.textContent = text;
}

const bytesOf = text => Uint8Array.from(atob(text), sign => sign.charCodeAt());
const inflate = bytes => new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();

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
    standFor(w / h);
    resize(w, h);
    viewer.render();  // another size has wiped the picture
  };
  const obey = viewer.handle_command.bind(viewer);
  viewer.handle_command = command => {
    if (command.type === "replay") replayed(command);
    else if (command.type === "stands") placesOf(command);
    else if (Array.isArray(command)) command.forEach(each => viewer.handle_command_bytearray(each));
    else obey(command);
  };
  const load = viewer.set_animation.bind(viewer);
  viewer.set_animation = (animations, options) => {
    rate = animations[0]?.clip.fps ?? rate;
    animations.forEach(jumpIfBeam);
    load(animations, options);
    for (const action of viewer.animator.actions) action.play();
    viewer.animator.playing = false;  // the time is this bar's
    last = Math.round(viewer.animator.duration * rate);
    if (opens === "at its end") playing = false;
    at = playing ? 0 : Math.min(opensAt, last);
    followLink();
  };
  new ResizeObserver(() => { viewer.set_3d_pane_size(); shown = undefined; }).observe(view);
}

// A film of the last steps, or none: then the page is live.
function replayed(command) {
  if (!command.names.length) {
    viewer.animator.clear();
    [last, at, notes, opens] = [0, 0, [], ""];
    flat.hidden = plan.hidden = true;
    marks.replaceChildren();
    flat.setAttribute("aria-pressed", false);
    return;
  }
  ({notes, opens} = command);
  opensAt = opens === "at its end" || command.telling < 0 ? Infinity : command.telling;  // where nothing moves
  tell(command);
  layOut(command);
  viewer.handle_command({type: "set_animation", animations: animationsOf(command), options: {}});
}

// The room is light or dark as the page is: what has a colour of the light palette gets its twin.
const TWINS = ["floor", "wall", "line", "blue", "ink"], TRAIL_IN_THE_DARK = 1.4;  // times as bright
function repaint() {
  const {Color} = MeshCat.THREE, light = coloursOf(lit), now = coloursOf(view.firstChild), isDark = light.floor !== now.floor;
  const twins = new Map(TWINS.map(name => [new Color(light[name]).getHex(), now[name]]));
  viewer.scene.traverse(({material}) => {
    if (!material?.color) return;
    if (material.vertexColors) return material.color.setScalar(isDark ? TRAIL_IN_THE_DARK : 1);
    const first = material.userData.first ??= material.color.getHex();
    if (twins.has(first)) material.color.set(twins.get(first));
  });
  viewer.set_dirty();
}
followColours(repaint);

// What is new: `commands` of meshcat's, and before them those that are `packed` in one piece; the rewards of the steps,
// the last ones of `count`; the view in words; whether the page around it is light or dark
let heard = Promise.resolve();
const hear = told => heard = heard.then(() => take(told));  // one after the other
async function take(told) {
  if (told.theme) document.documentElement.dataset.theme = told.theme;
  if (told.title) view.ariaLabel = told.title;
  if (told.packed?.byteLength) viewer.handle_command_bytearray(new Uint8Array(await inflate(told.packed)));
  for (const command of told.commands) viewer.handle_command_bytearray(command);
  repaint();
  ({rewards, count} = told);
  sums = [];
  let sum = 0, recent = 0;
  means = rewards.map((r, i) => {
    sums.push(sum += r);
    recent += r - (rewards[i - MEAN_OF] ?? 0);
    return recent / Math.min(i + 1, MEAN_OF);
  });
  replay.hidden = !last;
  if (last) {
    colourStrip(rewards.slice(-last - 1));
    markMoments();
  } else tellLive(means.at(-1), Math.min(count, MEAN_OF));
  chase.hidden = !body();
  chase.textContent = rolls() ? "Chase camera" : "Follow the gripper";
  bar.hidden = !last && !count && !body();
  chart.hidden = count <= last + 1 || rewards.length < 3;  // a film shows the sum so far
  shown = undefined;
}

// Below the slider each step has the colour of its part of the way.
function colourStrip(paid) {
  const {loss} = film.map, colour = r => `var(--${loss !== null && r <= loss ? "red" : r > 0 ? "green" : "grey"})`;
  const stops = paid.map((r, i) => `${colour(r)} ${100 * i / paid.length}% ${100 * (i + 1) / paid.length}%`);
  strip.style.background = stops.length ? `linear-gradient(to right, ${stops.join()})` : "";
}

// Time

const branch = path => path.reduce((it, name) => it?.children[name], viewer.scene_tree);
const node = path => branch(path)?.object;
const body = () => node(["meshcat", "robot", "body"]);
const before = () => Math.max(0, count - last - 1);  // steps before those of the film
const number = () => last ? before() + Math.min(Math.floor(at + 1e-6), last) + 1 : count;
const signed = (number, digits) => (number < 0 ? "−" : "+") + Math.abs(+number.toPrecision(digits));

function show() {
  const step = number(), end = last ? before() + last + 1 : count, i = rewards.length - 1 - (end - step);
  if (last) {
    viewer.animator.seek(Math.min(at, last) / rate);
    [time.min, time.max, time.value] = [before() + 1, end, step];
  }
  for (const [first, {children}] of Object.entries(branch(["meshcat", "trail"])?.children ?? {})) {  // it grows with the way
    const band = children["<object>"]?.object;
    if (!band) continue;
    band.geometry.setDrawRange(0, last ? 6 * Math.max(0, step - first) : Infinity);
  }
  shown = at;
  const words = [last ? momentAt(step - 1 - before()) : ""].filter(Boolean);
  if (i in rewards) {
    words.push(`reward ${signed(rewards[i], 4)}`);
    words.push(chart.hidden ? `sum so far ${signed(sums[i], 4)}` : `mean of the last ${Math.min(step, MEAN_OF)} steps: ${signed(means[i], 2)}`);
  }
  if (last && notes[step - 1 - before()]) words.push(notes[step - 1 - before()]);
  caption.textContent = (end ? `step ${step}` : "") + (last ? ` of ${end}` : "") + (words.length ? ": " + words.join(" · ") : "");
  if (!chart.hidden) plot(i);
  if (!plan.hidden) drawMap();
  viewer.set_dirty();
}

function go(step) {
  playing = false;
  at = Math.min(Math.max(step - 1 - before(), 0), last);
  settle();
}
const moves = {
  first: () => go(0), back: () => go(number() - 1), step: () => go(number() + 1), last: () => go(Infinity),
  play: () => {
    if (!playing && at >= last) at = 0;  // from the end it begins again
    playing = !playing;
    if (!playing) at = Math.min(Math.round(at), last);  // what is told is true of whole steps
    settle();
  },
};
const keys = {ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last"};
function followLink() {
  if (location.hash === "#still") go(Infinity);
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

let then = performance.now();
function tick(now) {
  const seconds = Math.min(0.5, Math.max(0, now - then) / 1000);
  then = now;
  if (playing && last) at = at > last + rate ? 0 : at + seconds * rate;  // at the end it rests for a second
  play.textContent = playing ? "‖ Pause" : "▶▶ Play";
  if (at !== shown) show();
  if (pressed(turn)) goRound(seconds);
  if (chasing() && body()) { follow(seconds); viewer.set_dirty(); }
  requestAnimationFrame(tick);
}
