// Two lives of an hour, and the moments at which a robot's state was new to it. Nothing is drawn here.

const HOUR = 3600; // steps of a second
const NOBODY = "TOSL+SR", NEIGHBOURS = "TOSL+QBIASSR"; // whom the two robots ask
const BUMP = -2, PAYS = 1; // a step bumps if its reward is at most this; it pays above that
const AFTER = 10; // steps by which a choice is judged
const LEAST_SAY = 0.1; // who says less of the favourite is no adviser

const freshLife = (method, walls) => newSimulation({ ...about.parameters, task: "wander_1k", method, luck: 0 }, walls);
const kindOf = (r) => (r <= BUMP ? "bump" : r > PAYS ? "paid" : "idle");

// An hour as it was. At time t: places of the axle, states, the actions that were chosen there, and the rewards of the
// steps that led there; metres and bumps so far; firsts: the times at which a state was new.
function lifeOf(method, walls, steps = HOUR) {
  const simulation = freshLife(method, walls), { world } = simulation, n = steps + 1, seen = new Set();
  const life = {
    method, walls, world, steps, places: [], s: new Int32Array(n), a: new Int32Array(n), r: new Float64Array(n),
    metres: new Float64Array(n), bumps: new Int32Array(n), firsts: [],
  };
  simulation.begin();
  for (let t = 0; t <= steps; t++) {
    if (t > 0) {
      life.r[t] = simulation.step().r;
      const [x, y] = world.place, [fromX, fromY] = life.places[t - 1];
      life.metres[t] = life.metres[t - 1] + Math.hypot(x - fromX, y - fromY);
      life.bumps[t] = life.bumps[t - 1] + (life.r[t] <= BUMP ? 1 : 0);
    }
    life.places.push(Array.from(world.place));
    [life.s[t], life.a[t]] = simulation.pending;
    if (!seen.has(life.s[t])) life.firsts.push(t);
    seen.add(life.s[t]);
  }
  return life;
}

// For each input the states that share all others with s, s among them.
function setsOf(shape, s) {
  let stride = shape.reduce((n, bins) => n * bins, 1);
  return Array.from(shape, (bins) => {
    stride /= bins;
    const first = s - (Math.floor(s / stride) % bins) * stride;
    return Array.from({ length: bins }, (_, k) => first + k * stride);
  });
}

// The moments at which a robot that asks stood in a new state, all but its first. Of each: who is similar, with what it
// knew of them when it chose (`q`), when it was there last (`seen`, -1: never) and which input differs; the chances by
// which it chose, and what each action would have paid.
function momentsOf(life) {
  const simulation = freshLife(life.method, life.walls), trial = freshLife(life.method, life.walls).world;
  const last = new Map(), { m } = simulation, found = [];
  const isFirst = new Set(life.firsts);
  simulation.begin();
  for (let t = 1; t < life.steps; t++) {
    last.set(life.s[t - 1], t - 1);
    const s = life.s[t];
    let similar = [];
    if (isFirst.has(t)) { // the action is chosen before the step's own update, so the rows are copied before it
      const sets = setsOf(m.shape, s);
      similar = sets.flatMap((set, input) => set.filter((state) => state !== s).map((state) => (
        { state, input, q: Array.from(m.q[state]), seen: last.get(state) ?? -1 })));
    }
    simulation.step();
    if (!isFirst.has(t)) continue;
    const pays = trial.twists.map((_, a) => {
      trial.put(life.places[t]);
      return trial.step(a)[1];
    });
    const moment = { t, s, shape: m.shape, temperature: m.now.temperature, scale: m.parameters.q_scale, similar, pays };
    moment.known = similar.filter(({ seen }) => seen >= 0);
    moment.chances = Array.from(m.probabilities);
    found.push(moment);
  }
  return found;
}

// With which chances it would choose, by the library's kernels, had it remembered `changed`: rows of Q by state.
function chancesOf({ s, shape, temperature, scale, similar }, changed = {}) {
  const none = new Float64Array(about.worlds.wander_1k.nActions), q = [];
  for (const { state, q: row } of similar) q[state] = changed[state] ?? row;
  const rows = Array.from({ length: shape.reduce((n, bins) => n * bins, 1) }, (_, k) => q[k] ?? none);
  const found = biasOf({ shape, states: { [s]: { sets: setsOf(shape, s) } }, temperature }, rows, scale, s);
  return { chances: Array.from(found.qbiassr), lot: Array.from(found.sr), bias: Array.from(found.bias) };
}

// The actions that move a robot alike, as one motion; straight ones first, then arcs, spins, and standing still.
function motionsOf({ twists, actions, stepTime }) {
  const found = [];
  twists.forEach(([v, omega], a) => {
    const same = found.find((motion) => motion.v === v && motion.omega === omega);
    if (same) same.actions.push(a);
    else found.push({ v, omega, actions: [a], called: actions[a].split(",")[0] });
  });
  const fastest = Math.max(...found.map(({ v }) => v)), rank = ({ v, omega }) => (omega ? (v ? 1 : 2) : v ? 0 : 3);
  for (const motion of found) {
    const { v, omega } = motion, side = omega > 0 ? 0 : 1;
    motion.sign = omega ? (v ? "↖↗" : "↺↻")[side] : v ? (v === fastest ? "⇈" : "↑") : "■";
    if (v === fastest) motion.called += ", fast";
    motion.path = pathOf(v, omega, stepTime);
  }
  return found.sort((a, b) => rank(a) - rank(b) || b.v - a.v || b.omega - a.omega);
}

// Where the arrow of a motion runs, in the robot's own frame [m]: from its rim on, straight ahead as far as a step leads.
function pathOf(v, omega, seconds) {
  const parts = Array.from({ length: 25 }, (_, i) => i / 24);
  if (!v && !omega) return [];
  if (!v) return parts.map((p) => 0.5 + p * 2.2).map((turn) => [0.42 * Math.cos(turn), Math.sign(omega) * 0.42 * Math.sin(turn)]);
  if (!omega) return parts.map((p) => [0.24 + p * v * seconds, 0]);
  const radius = 0.62;
  return parts.map((p) => p * 1.1).map((turn) =>
    [0.24 + radius * Math.sin(turn), Math.sign(omega) * radius * (1 - Math.cos(turn))]);
}

const sum = (list, of) => list.reduce((total, x) => total + of(x), 0);
const mostBy = (list, of) => list.reduce((best, x) => (of(x) > of(best) ? x : best));
const chanceOf = (chances, { actions }) => sum(actions, (a) => chances[a]);
const lotOf = ({ actions }) => actions.length / about.worlds.wander_1k.nActions;
const favouriteOf = (chances, motions) => mostBy(motions, (motion) => chanceOf(chances, motion) / motion.actions.length);

// What a similar state adds to the bias of a motion: the mean of its actions.
function sayOf({ shape }, { input, q }, { actions }) {
  return sum(actions, (a) => q[a]) / actions.length / (shape[input] * shape.length);
}

// The moments at which the robot then did what its memories favour; without any, all moments.
function followedOf(life, moments, motions) {
  const followed = moments.filter(({ t, chances }) => favouriteOf(chances, motions).actions.includes(life.a[t]));
  return followed.length ? followed : moments;
}

// Of these the one with the most advisers; of several the last.
function firstShown(life, moments, motions) {
  const advisers = (moment) => {
    const favourite = favouriteOf(moment.chances, motions);
    return moment.similar.filter((one) => Math.abs(sayOf(moment, one, favourite)) >= LEAST_SAY).length;
  };
  return followedOf(life, moments, motions).reduce((best, moment) => (advisers(moment) >= advisers(best) ? moment : best));
}

// The moment at which asking raised the chance of a bump most.
function mostWrong(moments) {
  const rise = ({ pays, chances }) => sum([...pays.keys()], (a) => (pays[a] <= BUMP ? chances[a] - 1 / pays.length : 0));
  return mostBy(moments, rise);
}

// What the steps from t on earned, and what as many of its hour earn on average.
const earnedFrom = ({ r }, t) => sum(Array.from(r.subarray(t + 1, t + 1 + AFTER)), (reward) => reward);
const usuallyEarned = ({ r, steps }) => (AFTER * sum(Array.from(r), (reward) => reward)) / steps;

// The moment at which asking had at least doubled a motion's chance, the robot did that, and its next steps earned least.
function leastEarned(life, moments, motions) {
  const isAdvised = ({ t, chances }) => {
    const favourite = favouriteOf(chances, motions);
    return chanceOf(chances, favourite) >= 2 * lotOf(favourite) && t + AFTER <= life.steps;
  };
  const advised = followedOf(life, moments, motions).filter(isAdvised);
  return mostBy(advised.length ? advised : moments, ({ t }) => -earnedFrom(life, t));
}
