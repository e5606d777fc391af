// Hands: what a mouse, a finger or a key does to walls, ribbons and buttons; and the beginning.

const NEAR = 0.1, STEP = 0.05, TURN = 15; // how near to a wall one must be [m]; a key moves it so far [m], turns it [°]
const PULL = 0.4; // of a ribbon's memory, for each pixel
const LATER_MS = 900; // after the last key the hours are lived anew
let held = null, later = 0;

const inside = () => walls ?? wallsInside(lives[1].world);
const cameraNow = () => new Camera(lives[1].world.bounds, placesOf(1).rooms[1]);
const pixel = (event) => {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};
const wallAt = (x, y) => inside().findIndex((wall) => distanceTo(wall, x, y) < (FINGER.matches ? 2 : 1) * NEAR);
const mayStand = (wall) => distanceTo(wall, ...lives[1].world.start) > lives[1].world.radius;

// The nearest ribbon that is near enough, or -1.
function ribbonAt(spot) {
  const far = layoutNow().ghosts.map((one) => (speaks(one) ? Math.max(0, distanceToCurve(one.curve, spot) - one.width / 2) : Infinity));
  const least = Math.min(...far);
  return least < (FINGER.matches ? 18 : 10) ? far.indexOf(least) : -1;
}

// A wall elsewhere in both rooms; the lives there are lived when it has come to rest.
function placeWall(i, wall) {
  const moved = intoRoom(lives[1].world, wall);
  if (!mayStand(moved)) return say("There the robots begin.");
  walls = Object.assign([...inside()], { [i]: moved });
  for (const { world } of lives) world.build(allWalls(world, walls));
  return wake();
}

function liveAnew() {
  clearTimeout(later);
  later = 0;
  find("restore").hidden = walls === null;
  begin(AGAIN_MS);
  say(`Both robots have lived their hour anew: ${Math.round(lives[0].metres[HOUR])} and ${Math.round(lives[1].metres[HOUR])} metres.`);
}
function soon() {
  clearTimeout(later);
  later = setTimeout(liveAnew, LATER_MS);
}

// The number of a wall among all of the world, those around the room first.
const chooseWall = (i) => { wallChosen = i < 0 ? -1 : lives[1].world.walls.length - inside().length + i; wake(); };
const wallInHand = () => wallChosen - (lives[1].world.walls.length - inside().length);

canvas.addEventListener("touchstart", (event) => { // a finger that has taken something does not move the page
  const spot = pixel(event.touches[0]);
  if (phase === "ask" && (wallAt(...cameraNow().from(...spot)) >= 0 || ribbonAt(spot) >= 0)) event.preventDefault();
}, { passive: false });
canvas.onpointerdown = (event) => {
  if (phase === "race") return ask(firstNow());
  const spot = pixel(event), [x, y] = cameraNow().from(...spot), i = wallAt(x, y), ribbon = i < 0 ? ribbonAt(spot) : -1;
  if (i >= 0) {
    held = { i, from: [x, y], wall: inside()[i], moved: false };
    chooseWall(i);
  } else if (ribbon >= 0) {
    ghost = ribbon;
    layout = null;
    fillPanel();
    held = { pulled: spot, value: Number(find("value").value) };
  } else chooseWall(-1);
  if (held) canvas.setPointerCapture(event.pointerId);
  return wake();
};
canvas.onpointermove = (event) => {
  if (!held) return;
  const spot = pixel(event);
  if (held.pulled) {
    const value = Math.round(held.value + PULL * (held.pulled[1] - spot[1]));
    if (Math.abs(spot[1] - held.pulled[1]) > 2) remember(Math.max(-100, Math.min(100, value)));
    return;
  }
  const [x, y] = cameraNow().from(...spot), [left, top, ...rest] = held.wall;
  if (Math.hypot(x - held.from[0], y - held.from[1]) < 0.03 && !held.moved) return;
  held.moved = true;
  placeWall(held.i, [left + x - held.from[0], top + y - held.from[1], ...rest]);
};
canvas.onpointerup = canvas.onpointercancel = () => {
  const { moved = false } = held ?? {};
  held = null;
  if (moved) liveAnew();
};

const WAYS = { ArrowLeft: [-STEP, 0], ArrowRight: [STEP, 0], ArrowUp: [0, STEP], ArrowDown: [0, -STEP] };
canvas.onkeydown = (event) => {
  if (phase !== "ask") return;
  const n = inside().length, i = wallInHand(), wall = wallChosen < 0 ? null : inside()[i];
  if (event.key === "w" && n) {
    const next = wallChosen < 0 ? 0 : (i + 1) % n;
    chooseWall(next);
    say(`Wall ${next + 1} of ${n}. Arrows move it, r turns it.`);
  } else if (wall && event.key in WAYS) {
    const [dx, dy] = WAYS[event.key];
    placeWall(i, [wall[0] + dx, wall[1] + dy, ...wall.slice(2)]);
    soon();
  } else if (wall && event.key === "r") {
    placeWall(i, [...wall.slice(0, 3), wall[3] + TURN]);
    soon();
  } else return;
  event.preventDefault();
  event.stopPropagation();
};
canvas.onblur = () => (later ? liveAnew() : chooseWall(-1));

document.onkeydown = (event) => {
  if (event.target.tagName === "INPUT" || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "Escape" && phase === "race") ask(firstNow());
  else if (event.key === "ArrowRight" && phase === "ask") next(1);
  else if (event.key === "ArrowLeft" && phase === "ask") next(-1);
};
find("next").onclick = () => next(1);
find("wrong").onclick = () => ask(wrongNow(), true);
find("again").onclick = () => { moment = null; race(RACE_MS); keepLink(); };
find("restore").onclick = () => { walls = null; liveAnew(); find("next").focus(); };
find("value").oninput = () => remember(Number(find("value").value));

addEventListener("resize", () => { size(); wake(); });
const recoloured = () => { colours = coloursOf(canvas); ways = null; size(); wake(); };
followTheme(recoloured);
matchMedia("(forced-colors: active)").onchange = recoloured;
calm.onchange = wake;

colours = coloursOf(canvas);
const beginning = linked();
walls = wallsFrom(beginning.get("walls"), freshLife(NOBODY).world);
find("restore").hidden = walls === null;
begin(RACE_MS);
if (!follow(beginning) && calm.matches) ask(firstNow(), true);
