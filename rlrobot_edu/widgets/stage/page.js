// The page: two lives race through their hour, and then one moment is asked about. Time, and what is on the canvas.

const find = (id) => document.getElementById(id);
const FONT = ROOM_LETTERS;
ROOM_COLOURS.push("input-1", "input-2", "input-3", "input-4", "input-5", "on-input", "black", "shadow"); // which coloursOf reads
const RACE_MS = 5000, AGAIN_MS = 3000, REST_MS = 900, CAMERA_MS = 1000;
const SCORE_HIGH = 98, UNDER = 64; // height of the numbers above a room, and of those at the question on a phone [px]
const canvas = find("picture"), calm = matchMedia("(prefers-reduced-motion: reduce)");
const FINGER = matchMedia("(pointer: coarse)");

let colours, W, H, ratio, lives, moments = [], least, motions, walls = null;
let ways, phase = "race", begun = 0, raceMs = RACE_MS, arrived = 0, isNear = false; // isNear: the camera is there already
let moment = null, chosen = 0, ghost = -1, changed = new Map(), layout = null; // changed: "state motion" -> value
let wallChosen = -1, wallMoved = null, isMoving = false;

const wideEnough = matchMedia("(min-width: 1000px)"); // as style.css has it
const isNarrow = () => !wideEnough.matches;

// Since the camera came to the moment.
function seconds() {
  return calm.matches ? 99 : (performance.now() - arrived) / 1000;
}

const say = (text) => { find("spoken").textContent = text; };

// How high a picture is, as a part of how wide.
const shapeOf = (world) => new Camera(world.bounds, [0, 0, 1]).high;

function size() {
  const { world } = lives[1], shape = shapeOf(world), top = find("stage").getBoundingClientRect().top + scrollY;
  W = find("stage").clientWidth;
  H = isNarrow() ? Math.round(W * shape) + UNDER : Math.max(500, Math.min(620, innerHeight - top - find("honest").offsetHeight - 62));
  find("stage").style.height = `${H}px`;
  ratio = devicePixelRatio || 1;
  canvas.width = Math.round(W * ratio);
  canvas.height = Math.round(H * ratio);
  const wide = Math.max(placesOf(1).rooms[1][2], placesOf(0).rooms[1][2]), until = ways ? ways.map(({ t }) => t) : [0, 0];
  ways = lives.map((life) => new Way(life, wide, ratio));
  ways.forEach((way, i) => way.to(Math.min(until[i], way.life.steps), colours));
  layout = null;
  document.body.style.setProperty("--panel", `${isNarrow() ? W : W - placesOf(1).rooms[1][2] - 28}px`);
}

// Where rooms [left, top, wide] and numbers [left, top] are; near: 0 in the race, 1 at the question.
function placesOf(near) {
  const shape = shapeOf(lives[1].world), mix = (from, to) => from.map((x, i) => mixed(x, to[i], near));
  if (isNarrow()) {
    const wide = (H - 12) / 2 / shape, one = wide * shape;
    return {
      rooms: [mix([0, 0, wide], [W / 2 - 54, 2, 48]), mix([0, one + 12, wide], [0, UNDER, W])],
      scores: [mix([wide + 14, one / 2 - 40], [0, 0]), mix([wide + 14, one * 1.5 - 44], [W / 2, 0])], size: mixed(0.8, 0.62, near),
      clock: [wide + 14, 22, W - wide - 14],
    };
  }
  const wide = Math.min((W - 56) / 2, (H - SCORE_HIGH) / shape), side = (W - 56 - 2 * wide) / 2;
  const last = Math.min(0.56 * W, H / shape), panel = W - last - 28;
  const race = [[side, SCORE_HIGH, wide], [side + wide + 56, SCORE_HIGH, wide]];
  return {
    rooms: [mix(race[0], [156, 4, 84]), mix(race[1], [W - last, 0, last])],
    scores: [mix([race[0][0], 0], [0, 0]), mix([race[1][0], 0], [Math.max(panel / 2, 252), 0])], size: mixed(1, 0.8, near),
    clock: null,
  };
}

// Live both hours anew, and let them race.
function begin(ms) {
  lives = [NOBODY, NEIGHBOURS].map((method) => lifeOf(method, walls));
  motions ??= motionsOf(lives[1].world);
  find("bumps").textContent = ` (these two: ${lives.map(({ bumps }) => bumps[HOUR]).join(" and ")})`;
  [moments, moment, ways, wallChosen] = [[], null, null, -1];
  race(ms);
  keepLink();
}

function race(ms) {
  [phase, raceMs, begun, isNear] = ["race", ms, performance.now(), false];
  document.body.classList.add("racing");
  ways = null;
  size();
  tell("Their first hour, in five seconds.");
  wake();
}

function momentsNow() {
  if (!moments.length) {
    moments = momentsOf(lives[1]);
    least = leastEarned(lives[1], moments, motions);
  }
  return moments;
}

// Ask about a moment; quick: without the camera's way.
function ask(which, quick = false) {
  moment = which;
  [changed, ghost, layout, wallChosen] = [new Map(), -1, null, -1];
  chosen = motions.indexOf(favouriteOf(moment.chances, motions));
  const says = (one) => Math.abs(sayOf(moment, one, motions[chosen]));
  moment.known.sort((a, b) => says(b) - says(a));
  isNear = isNear || quick || calm.matches;
  arrived = performance.now() + (isNear ? 0 : CAMERA_MS);
  phase = "ask";
  if (isNear) document.body.classList.remove("racing");
  isNear ||= calm.matches;
  fillPanel();
  keepLink();
  wake();
}

const firstNow = () => firstShown(lives[1], momentsNow(), motions);
const wrongNow = () => { // first where it bumped by its memories; from there on, where its next steps earned least
  const bumped = mostWrong(momentsNow());
  return moment === bumped ? least : bumped;
};
const next = (way) => {
  const all = momentsNow(), i = moment ? all.indexOf(moment) : 0;
  ask(all[(i + way + all.length) % all.length], true);
};

// The rows of Q that are others than it remembers, by state.
function rowsNow() {
  const rows = {};
  for (const [key, value] of changed) {
    const [state, i] = key.split(" ").map(Number);
    rows[state] ??= [...moment.known.find((one) => one.state === state).q];
    for (const a of motions[i].actions) rows[state][a] = value;
  }
  return rows;
}
const chancesNow = () => (changed.size ? chancesOf(moment, rowsNow()).chances : moment.chances);
function sayNow(one) {
  return sayOf(moment, { ...one, q: rowsNow()[one.state] ?? one.q }, motions[chosen]);
}

function layoutNow() {
  if (layout) return layout;
  const camera = new Camera(lives[1].world.bounds, placesOf(1).rooms[1]);
  const ghosts = moment.known.map((one) => ({ ...one, at: lives[1].places[one.seen] }));
  layout = laidOut(camera, lives[1].world, moment, lives[1].places[moment.t], ghosts, moment.known.map(sayNow), isNarrow());
  return layout;
}

function wake() {
  if (isMoving) return;
  isMoving = true;
  requestAnimationFrame(frame);
}

function frame(now) {
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, W, H);
  isMoving = phase === "race" ? drawRace(context, now) : drawAsk(context, now);
  if (isMoving) requestAnimationFrame(frame);
}

function drawLife(context, camera, i, t, dim) {
  const life = lives[i], { world } = life, look = { tone: colours.blue, rim: colours.card };
  drawFloor(context, camera, world, colours, ways[i].to(t, colours), dim);
  drawUpright(context, camera, world, colours, [
    { place: life.places[t], draw: () => drawRobot(context, camera, world, life.places[t], look, colours) }]);
}

// A frame of the race; tells whether there is a next one.
function drawRace(context, now) {
  const part = calm.matches ? 1 : Math.max(0, Math.min(1, (now - begun) / raceMs)), t = Math.round(HOUR * part ** 1.35);
  const places = placesOf(0);
  places.rooms.forEach((rect, i) => drawLife(context, new Camera(lives[i].world.bounds, rect), i, t, 1));
  tellScores(places, t);
  drawClock(context, places.clock, t);
  if (part === 1 && !moments.length) momentsNow();
  if (calm.matches || now - begun > raceMs + REST_MS) ask(firstNow());
  return true;
}

function drawClock(context, spot, t) {
  const text = `${Math.floor(t / 60)} min`;
  context.fillStyle = colours.faint;
  context.textBaseline = "middle";
  context.font = `${spot ? 14 : 16}px ${FONT}`;
  context.textAlign = spot ? "left" : "center";
  if (!spot) return void context.fillText(text, W / 2, SCORE_HIGH + (H - SCORE_HIGH) / 2);
  const [left, top, wide] = spot;
  context.fillText(text, left, top - 14);
  context.fillStyle = colours.line;
  context.fillRect(left, top, wide, 4);
  context.fillStyle = colours.blue;
  return void context.fillRect(left, top, (wide * t) / HOUR, 4);
}

// A frame of the question: first the camera comes and time runs back, then the moment is shown.
function drawAsk(context, now) {
  const isCalm = calm.matches, part = isNear ? 1 : Math.max(0, Math.min(1, 1 - (arrived - now) / CAMERA_MS));
  const near = isNear ? 1 : eased(part), places = placesOf(near), t = Math.round(mixed(HOUR, moment.t, eased(part)));
  drawLife(context, new Camera(lives[0].world.bounds, places.rooms[0]), 0, HOUR, 1);
  tellScores(places, HOUR);
  const camera = new Camera(lives[1].world.bounds, places.rooms[1]);
  if (part < 1) {
    drawLife(context, camera, 1, t, 1 - near);
    tellMoment(0);
    return true;
  }
  isNear = true;
  document.body.classList.remove("racing"); // till then the left room is on its way across the panel
  drawMoment(context, camera, seconds());
  tellMoment(seconds());
  return !isCalm && seconds() < TIMES.end + 0.2;
}

// Whether the page shows the step that was taken, and how far [0, 1].
const stepPart = (s) => (calm.matches || changed.size ? 0 : eased((s - TIMES.step) / 0.8));

function drawMoment(context, camera, s) {
  const life = lives[1], { world } = life, here = life.places[moment.t], narrow = isNarrow(), shown = layoutNow();
  const step = stepPart(s), place = placeBetween(here, life.places[moment.t + 1], step), each = Math.min(0.11, 0.9 / Math.max(1, shown.ghosts.length));
  const seenOf = (i) => eased((s - TIMES.ghosts - i * each) / 0.4), isShown = (one, i) => speaks(one) || ghost === i;
  const ghosts = [...shown.ghosts.entries()].filter(([i, one]) => isShown(one, i) && seenOf(i) > 0);
  const bodies = ghosts.map(([i, one]) => ({ place: one.place, draw: () => {
    const rim = ghost === i ? colours.ink : colours[`input-${one.input + 1}`];
    const look = { tone: ghostTone(one.input, colours), rim, ink: colours.ink, mark: MARKS[one.input], isGhost: true };
    context.globalAlpha = seenOf(i);
    drawRobot(context, camera, world, one.place, look, colours);
    context.globalAlpha = 1;
  } }));
  bodies.push({ place, draw: () => drawRobot(context, camera, world, place, { tone: colours.blue, rim: colours.card }, colours) });
  drawFloor(context, camera, world, colours);
  for (const [i, one] of ghosts) { // ties and ribbons lie on the floor
    drawTie(context, camera, one, colours);
    const grown = eased((s - TIMES.ribbons - 0.7 * i * each) / 0.7);
    if (grown > 0) drawRibbon(context, one, grown, ghost < 0 ? 0.8 : ghost === i ? 1 : 0.4, colours);
  }
  drawUpright(context, camera, world, colours, bodies, wallChosen);
  drawBeams(context, camera, here, ghosts, s);
  const spots = [shown.robot, ...ghosts.map(([, { spot }]) => spot)], told = ghosts.filter(([i]) => ghost < 0 || i === ghost);
  const words = told.length ? drawWho(context, camera, told.map(([, one]) => one), spots, colours) : [];
  if (!calm.matches && s < TIMES.ring) drawRing(context, shown.robot, camera, eased(s / TIMES.ring), colours);
  drawAnswer(context, camera, here, place, s, { ...shown, words }, narrow);
}

// All that it reads, and which reading differs; once the arrow is there, only for the ghost that is chosen.
function drawBeams(context, camera, here, ghosts, s) {
  const { world } = lives[1], isAll = s < TIMES.arrow, inputs = isAll ? world.inputs.keys() : [moment.known[ghost]?.input ?? -1];
  for (const [i, { at, input, shift }] of ghosts) {
    if (isAll || ghost === i) drawBeam(context, camera, world, at, input, colours[`input-${input + 1}`], 3, shift);
  }
  for (const i of inputs) if (i >= 0) drawBeam(context, camera, world, here, i, colours[`input-${i + 1}`], 2.5);
}

// The arrow with its chance, and then what the step paid.
function drawAnswer(context, camera, here, place, s, shown, narrow) {
  const grown = eased((s - TIMES.arrow) / 0.7), step = stepPart(s), rect = [camera.left, camera.top, camera.wide, camera.high];
  const motion = motions[chosen], chance = mixed(lotOf(motion), chanceOf(chancesNow(), motion), eased((s - TIMES.arrow) / 0.8));
  if (grown > 0 && step < 1) {
    const tip = drawArrow(context, camera, here, motion, shown, grown, 1 - step, colours, narrow, lives[1].world.bounds);
    const badge = { text: percent(chance), small: `would ${deedOf(motion)}`, narrow };
    const others = [...shown.ghosts.map(({ spot }) => spot), ...shown.words];
    const { spot, end } = besideRobot(badgeSize(context, badge), shown.robot, tip ?? shown.robot, others, rect, 0.3 * camera.scale);
    context.globalAlpha = 1 - step;
    if (tip) drawTether(context, spot, end, colours);
    drawBadge(context, badge, spot, colours.ink, colours.back, rect);
    context.globalAlpha = 1;
  }
  if (step < 0.9) return;
  const r = lives[1].r[moment.t + 1], kind = kindOf(r), [left, top] = camera.at(place[0], place[1], BODY_HIGH);
  const tone = { paid: colours.green, bump: colours.red, idle: colours.faint }[kind];
  const text = kind === "bump" ? `bump ${numberText(r)}` : `${r > 0 ? "+" : ""}${numberText(r)}`;
  const far = 0.3 * camera.scale + (narrow ? 20 : 26), wide = 0.3 * camera.scale + (narrow ? 12 : 14) + (narrow ? 5 : 6) * text.length;
  const around = [[0, -far], [0, far], [wide, 0], [-wide, 0]].map(([dx, dy]) => [left + dx, top + dy]);
  drawBadge(context, { text, narrow }, mostFree(around, shown.ghosts, rect), tone, colours.back, rect);
}

// Of some spots the one that is farthest from all robots, and inside the room.
function mostFree(spots, robots, [left, top, wide, high]) {
  const isIn = ([x, y]) => x > left + 30 && x < left + wide - 30 && y > top + 20 && y < top + high - 20;
  const free = (spot) => Math.min(200, ...robots.map((one) => Math.hypot(one.spot[0] - spot[0], one.spot[1] - spot[1])));
  return mostBy(spots, (spot) => free(spot) - (isIn(spot) ? 0 : 1000));
}

function placeBetween(here, there, part) {
  const turned = ((((there[2] - here[2]) % (2 * Math.PI)) + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  return [mixed(here[0], there[0], part), mixed(here[1], there[1], part), here[2] + part * turned];
}
