// The page: settings, the time that passes, what is told, and what is dragged.

const find = (id) => document.getElementById(id);
const [picture, curveCanvas, story, spoken] = ["picture", "curve", "story", "spoken"].map(find);
const PER_FRAME = [[0.1, "6 steps a second"], [1, "1 step a frame"], [10, "10 a frame"], [100, "100 a frame"],
  [1000, "1,000 a frame"], [10000, "10,000 a frame"]];
const MOST_MS = 12; // of learning in a frame, so that the picture stays smooth
const TRAIL = 240, BUMPS = 600; // steps for which its way is drawn, and the places where it bumped
const RECENT = 1000; // steps of the mean that is told
const VALUES = {
  alpha: { label: "α, learning rate", values: [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1], of: () => true },
  gamma: { label: "γ, discount", values: [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99], of: () => true },
  lam: { label: "λ, length of traces", values: [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1], of: (m) => /^(SL|TOSL)/.test(m) },
  temperature: { label: "T, temperature", values: [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50], of: (m) => /SR$/.test(m) },
  epsilon: { label: "ε, share of chance", values: [0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1], of: (m) => /EG$/.test(m) },
};
const number = (x) => x.toFixed(Math.abs(x) >= 1000 ? 0 : Math.abs(x) >= 100 ? 1 : 2).replace("-", "−");

const settings = { ...beginning, luck: 0, speed: 10, ...about.parameters };
let colours = inColours(NAMES), life, curve, before = null, trail, bumps, moved = {};
let playing = true, owed = 0, from = null, view = null, chosen = -1, pointed = null, told = 0;
let since = { moment: 0, t: 0 }, rate = 0; // steps a second, counted anew twice a second

// Begin a life with the present settings.
function begin() {
  life = newLife(settings, moved);
  curve = new Curve();
  trail = [];
  bumps = [];
  from = null;
  owed = 0;
  since = { moment: performance.now(), t: 0 };
  const { bounds, drawn, actionsCalled } = life.world;
  const [wide, high] = bounds
    ? [bounds[2] - bounds[0], bounds[3] - bounds[1]]
    : [0, 1].map((axis) => 1 + Math.max(...drawn.map(({ cell }) => cell[axis])));
  picture.style.aspectRatio = `${wide} / ${high}`;
  find("called").textContent = actionsCalled;
  live(1);
}

// Begin again after a change: what was learned until now stays as the curve before, with what has changed since.
function change(name, was) {
  if (curve.means.length) before = Object.assign(curve, { called: was === undefined ? "" : `, with ${name} ${was}` });
  if (name === "task") before = null;
  begin();
  keepLink();
  say("It starts again, with the same luck.");
}

const here = () => (life.world.drawn ? life.world.drawn[life.world.place] : Array.from(life.world.place));

// Live so many steps, or as many as MOST_MS allow.
function live(n) {
  const begun = performance.now();
  let done = 0;
  while (done < n && (done % 20 || performance.now() - begun < MOST_MS)) {
    if (n - done <= 1) from = here();
    const { r, truncated, terminated } = life.step();
    curve.add(r);
    done += 1;
    if (!life.world.walls) continue;
    const [x, y] = life.world.place;
    if (trail.push([x, y]) > TRAIL) trail.shift();
    if (r <= -2) bumps.push([x, y, life.t]);
    if (terminated || truncated) trail = [];
  }
  bumps = bumps.filter(([, , t]) => t > life.t - BUMPS);
}

function frame() {
  const n = settings.speed;
  if (playing) {
    owed += n;
    const whole = Math.floor(owed);
    if (whole >= 1) live(whole);
    owed -= whole;
  }
  draw(n < 1 && playing ? owed : 1);
  requestAnimationFrame(frame);
}

// Draw all; part: of the last step that is over, where time is slow.
function draw(part) {
  const world = life.world, now = here();
  if (world.walls) {
    const turn = (b, a) => ((((b - a) % (2 * Math.PI)) + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
    const far = !from || Math.hypot(now[0] - from[0], now[1] - from[1]) > 0.5 || part >= 1;
    const between = from && [0, 1].map((i) => from[i] + part * (now[i] - from[i]));
    const place = far ? now : [...between, from[2] + part * turn(now[2], from[2])];
    view = drawRoom(picture, world, place, trail, bumps, chosen, colours);
  } else {
    view = drawCells(picture, world, now, world.arrows && bestArrow, colours);
  }
  if (performance.now() - told < (settings.speed < 1 ? 0 : 200)) return;
  told = performance.now();
  tell();
}

const bestArrow = (at) => {
  const q = life.m.q[life.world.seen[at]];
  return q.every((value) => value === 0) ? "" : life.world.arrows[bestOf(q)];
};
const bestOf = (q) => q.reduce((best, value, a) => (value > q[best] ? a : best), 0); // the first of several

function summary() {
  const recent = curve.means.slice(-Math.max(1, Math.round(RECENT / curve.window)));
  if (!recent.length) return "It has just begun.";
  const mean = recent.reduce((sum, each) => sum + each, 0) / recent.length, n = recent.length * curve.window;
  return `Mean reward of the last ${n.toLocaleString("en")} steps: ${number(mean)}.`;
}

// All that is said in words and numbers.
function tell() {
  const { s, a, r, sNext, delta, before: was, after } = life.last, world = life.world;
  const seconds = life.t * (world.stepTime || 0), hours = Math.floor(seconds / 3600);
  const minutes = Math.floor((seconds % 3600) / 60);
  const lived = world.stepTime ? `, ${hours ? `${hours} h ` : ""}${minutes} min of its life` : "";
  const passed = (performance.now() - since.moment) / 1000;
  if (passed > 0.5) {
    rate = (life.t - since.t) / passed;
    since = { moment: performance.now(), t: life.t };
  }
  const pace = playing && rate > 100 ? ` · ${Math.round(rate).toLocaleString("en")} steps a second` : "";
  story.textContent = `Step ${life.t.toLocaleString("en")}${lived}${pace}`;
  const mean = summary();
  find("mean").textContent = mean + (before ? ` Dashed: the run before${before.called}.` : "");
  find("update").textContent = `In state ${s} it did “${world.actions[a]}” and got r = ${String(r).replace("-", "−")}, in state ${sNext}. ` +
    `δ = ${number(delta)}, so Q(s, a) went from ${number(was)} to ${number(after)}.`;
  drawCurves(curveCanvas, curve, before, colours);
  curveCanvas.setAttribute("aria-label", `Curve of rewards: ${mean}`);
  picture.setAttribute("aria-label", `${world.called}, seen from above: ${mean}`);
  showRow(pointed);
}

// A state in words: the bin of each input.
function inWords(s) {
  return life.world.words.map(([name, bins], i) => {
    const stride = life.world.shape.slice(i + 1).reduce((n, each) => n * each, 1);
    return `${name} ${bins[Math.floor(s / stride) % bins.length]}`;
  }).join(", ");
}

// The row of Q of a state: that under the pointer, or else the robot's own.
function showRow(state) {
  const s = state === null ? life.last.sNext : state, q = life.m.q[s], best = bestOf(q);
  const visits = life.m.visits[s].reduce((sum, n) => sum + n, 0);
  find("where").textContent = state === null ? "What it knows where it stands" : "What it knows where you point";
  find("state").textContent = `State ${s}: ${inWords(s)}. Met ${visits.toLocaleString("en")} times.`;
  const most = Math.max(1e-9, ...q.map(Math.abs));
  find("actions").tBodies[0].replaceChildren(...life.world.actions.map((action, a) => {
    const row = document.createElement("tr"), bar = document.createElement("div");
    for (const text of [a === best ? `${action} (best)` : action, number(q[a])]) row.insertCell().textContent = text;
    bar.className = q[a] < 0 ? "bar below" : "bar";
    bar.style.width = `${(100 * Math.abs(q[a])) / most}%`;
    row.insertCell().append(bar);
    row.className = a === best ? "best" : "";
    return row;
  }));
}

const say = (words) => { spoken.textContent = words; };

function play(on) {
  playing = on;
  find("play").textContent = on ? "Pause" : "Play";
  if (!on) say(`Paused: ${summary()}`);
  told = 0;
}

// What the address holds: settings, and walls that were moved.
function keepLink() {
  const parts = Object.entries(settings).map(([name, value]) => `${name}=${encodeURIComponent(value)}`);
  const walls = Object.entries(moved).map(([i, place]) => `${i}:${Array.from(place, (x) => +x.toFixed(4)).join(",")}`);
  if (walls.length) parts.push(`walls=${walls.join(";")}`);
  find("link").href = `#${parts.join("&")}`;
  try {
    history.replaceState(null, "", `#${parts.join("&")}`);
  } catch { /* a page within a page may not */ }
}

function readLink() {
  const given = new URLSearchParams(location.hash.slice(1));
  for (const [name, value] of given) {
    const x = Number(value);
    if (name in VALUES && VALUES[name].values.includes(x)) settings[name] = x;
    else if (name === "luck" && about.lucks[x]) settings.luck = x;
    else if (name === "speed" && PER_FRAME.some(([speed]) => speed === x)) settings.speed = x;
    else if (name === "method" && about.methods.some((method) => method.name === value)) settings.method = value;
    else if (name === "task" && Object.hasOwn(about.worlds, value)) settings.task = value;
  }
  for (const wall of (given.get("walls") || "").split(";")) {
    const [i, place] = wall.split(":"), numbers = (place || "").split(",").map(Number);
    if (numbers.length === 6 && numbers.every(Number.isFinite)) moved[Number(i)] = numbers;
  }
}

// The choices of a setting, in the list of its name.
function options(name, entries) {
  const select = find(name);
  select.replaceChildren(...entries.map(([value, text]) => new Option(text, value, false, value === settings[name])));
  select.onchange = () => {
    const was = settings[name];
    settings[name] = typeof was === "number" ? Number(select.value) : select.value;
    if (name === "task") moved = {};
    if (name === "speed") keepLink();
    else change(name, was);
    sliders();
  };
}

// The sliders that the method listens to.
function sliders() {
  find("sliders").replaceChildren(...Object.entries(VALUES).filter(([, { of }]) => of(settings.method)).map(
    ([name, { label, values }]) => {
      const line = document.createElement("label"), value = document.createElement("span");
      const input = Object.assign(document.createElement("input"), {
        type: "range", min: 0, max: values.length - 1, value: values.indexOf(settings[name]), name,
      });
      const show = () => {
        value.textContent = values[input.value];
        input.setAttribute("aria-valuetext", values[input.value]);
      };
      input.oninput = show;
      input.onchange = () => {
        const was = settings[name];
        settings[name] = values[input.value];
        change(label.split(",")[0], was);
      };
      show();
      line.append(label, value, input);
      return line;
    },
  ));
}

// Walls: dragged, or moved by keys.
const inside = () => life.world.walls || [];
function wallAt(x, y) {
  return inside().findIndex(([cx, cy, half, thin, cos, sin]) => {
    const dx = x - cx, dy = y - cy, near = 0.08;
    return Math.abs(dx * cos + dy * sin) < half + near && Math.abs(dy * cos - dx * sin) < thin + near;
  });
}
function moveWall(i, dx, dy, turn = 0) {
  const wall = inside()[i], angle = Math.atan2(wall[5], wall[4]) + turn;
  wall[0] += dx;
  wall[1] += dy;
  [wall[4], wall[5]] = [Math.cos(angle), Math.sin(angle)];
  moved[i] = wall;
  life.world.readings = life.world.sense(life.world.place);
  keepLink();
}
const place = (event) => {
  const box = picture.getBoundingClientRect();
  return view.from(event.clientX - box.left, event.clientY - box.top);
};
let held = null;
picture.addEventListener("touchstart", (event) => { // a finger on a wall moves it; elsewhere it moves the page
  if (wallAt(...place(event.touches[0])) >= 0) event.preventDefault();
}, { passive: false });
picture.onpointerdown = (event) => {
  const [x, y] = place(event), i = wallAt(x, y);
  chosen = i;
  if (i < 0) return;
  held = { i, x, y };
  picture.setPointerCapture(event.pointerId);
};
picture.onpointermove = (event) => {
  const [x, y] = place(event);
  if (held) {
    moveWall(held.i, x - held.x, y - held.y);
    Object.assign(held, { x, y });
  } else pointed = stateAt(x, y);
};
picture.onpointerup = picture.onpointercancel = () => { held = null; };
picture.onpointerleave = () => { pointed = null; };
picture.ondblclick = (event) => {
  const i = wallAt(...place(event));
  if (i >= 0) moveWall(i, 0, 0, Math.PI / 6);
};

// The state that the robot would be in at a point, with its present heading; null where it cannot be.
function stateAt(x, y) {
  const world = life.world;
  if (world.walls) {
    const [xMin, yMin, xMax, yMax] = world.bounds;
    if (x < xMin || x > xMax || y < yMin || y > yMax || wallAt(x, y) >= 0) return null;
    return world.stateOf(world.sense([x, y, world.place[2]]));
  }
  const now = here(), same = (a, b) => String(a) === String(b);
  const there = world.drawn.findIndex(({ cell, heading, box }) =>
    same(cell, [Math.floor(x), Math.floor(y)]) && heading === now.heading && same(box, now.box));
  return there < 0 ? null : world.seen[there];
}

const WAYS = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, 0.05], ArrowDown: [0, -0.05] };
picture.onkeydown = (event) => {
  const walls = inside();
  if (event.key === "w" && walls.length) {
    chosen = (chosen + 1) % walls.length;
    say(`Wall ${chosen + 1} of ${walls.length}`);
  } else if (event.key === "r" && chosen >= 0) moveWall(chosen, 0, 0, Math.PI / 12);
  else if (event.key in WAYS && chosen >= 0) moveWall(chosen, ...WAYS[event.key]);
  else return;
  event.preventDefault();
};
document.onkeydown = (event) => {
  if (event.key !== " " || /^(BUTTON|SELECT|INPUT)$/.test(event.target.tagName)) return;
  event.preventDefault();
  play(!playing);
};

readLink();
find("link").hidden = location.protocol === "about:"; // within a notebook there is no address
options("task", Object.entries(about.worlds).map(([name, { called }]) => [name, called]));
options("method", about.methods.map(({ name, called }) => [name, called]));
options("speed", PER_FRAME);
options("luck", about.lucks.map((_, i) => [i, `seed ${i}`]));
find("play").onclick = () => play(!playing);
find("again").onclick = () => change();
matchMedia("(prefers-color-scheme: dark)").onchange = () => { colours = inColours(NAMES); };
begin();
sliders();
if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
  while (life.t < 3600) live(3600 - life.t); // an hour of its life, at once
  play(false);
}
keepLink();
requestAnimationFrame(frame);
