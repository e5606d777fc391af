// A learner's simulation in a page: random numbers, the learner's memory, worlds, and the loop in which they take turns.
// The learning itself, the robot's motion and the draws from a model are the library's kernels, which program.py
// translates; what stands here does what agent.py, memory.py, robot_env.py and model_env.py do around them.
"use strict";

// numpy's default generator, PCG64 (O'Neill 2014): a state of 128 bits; `state`, `inc` as numpy tells them, in hex;
// half: the upper 32 bits of a draw of which the lower ones are used up, if there are any.
function pcg64({ state, inc, half: kept = null }) {
  const mask64 = (1n << 64n) - 1n, mask128 = (1n << 128n) - 1n, multiplier = 0x2360ed051fc65da44385df649fccf645n;
  let now = BigInt(state), half = kept === null ? null : BigInt(kept);
  const step = BigInt(inc);
  const next = () => { // 64 bits
    now = (now * multiplier + step) & mask128;
    const mixed = (now >> 64n) ^ (now & mask64), turn = now >> 122n;
    return ((mixed >> turn) | (mixed << (64n - turn))) & mask64;
  };
  return {
    random: () => Number(next() >> 11n) / 9007199254740992, // uniform in [0, 1), of 53 bits
    either() { // 0 or 1, as integers(2): of 64 bits numpy first uses the lower half, then the upper one
      const bits = half ?? next();
      half = half === null ? bits >> 32n : null;
      return Number((bits >> 31n) & 1n);
    },
  };
}

// By what the values are multiplied before a softmax: 100 / Qmax, as parameters.py has it.
const scaleOf = ({ r_max, gamma }) => 100 / (r_max / (1 - gamma));

// A memory in which nothing has been learned yet, for reduced traces. shape: bins of each input; parameters: all of
// memory.py's SETTINGS but q_scale; kernels: among them its trace_steps.
function newMemory(shape, nActions, parameters, kernels) {
  const { gamma, lam, smallest_trace, temperature } = parameters;
  const nStates = shape.reduce((n, bins) => n * bins, 1), n = kernels.trace_steps(gamma, lam, smallest_trace);
  const reduced = kernels.trace_steps(gamma, lam, 0.01), queue = Math.max(4, Math.min(reduced, Math.floor(nStates / 4))); // as memory.py, also for full traces
  const table = (kind) => Array.from({ length: nStates }, () => new kind(nActions));
  return {
    q: table(Float64Array), e: table(Float64Array), visits: table(Int32Array),
    register: new Int32Array(Math.min(n + 1, nStates)),
    queue_states: new Int32Array(queue), queue_rewards: new Float64Array(queue), queue_count: new Int32Array(nStates),
    shape: Int32Array.from(shape),
    probabilities: new Float64Array(nActions).fill(1 / nActions), bias: new Float64Array(nActions),
    parameters: { ...parameters, q_scale: scaleOf(parameters) },
    now: { temperature, q_old: 0, register_size: 0, queue_size: 0, queue_unique: 0, queue_end: 0 },
  };
}

// What remains of worlds when an episode begins and when a step is done: the steps are counted, and the end is told.
class World {
  constructor(about) {
    Object.assign(this, about);
    this.t = 0;
  }

  // A step counted: [next state, reward, terminated, truncated].
  stepped(s, r, terminated) {
    this.t += 1;
    return [s, r, terminated, !terminated && this.episodeSteps > 0 && this.t >= this.episodeSteps];
  }
}

// Places that a table leads through; `seen` tells the state that the robot sees at each place.
class ModelWorld extends World {
  constructor(about, kernels, random) {
    super(about);
    Object.assign(this, { kernels, random, place: 0 });
  }

  reset() {
    this.t = 0;
    this.place = this.first();
    return this.seen[this.place];
  }

  step(a) {
    const [place, r, terminated] = this.outcome(a);
    this.place = place;
    return this.stepped(this.seen[place], r, terminated);
  }

  first() {
    return this.kernels.draw_start(this.tables, this.random.random());
  }

  outcome(a) {
    const u = this.random.random(), v = this.random.random();
    return this.kernels.draw_outcome(this.tables, this.place, a, u, v);
  }
}

// The cells of cell_robot.py: an action has one outcome where the box stays, and two where it moves.
class CellWorld extends ModelWorld {
  first() {
    return this.tables.starts[0];
  }

  outcome(a) {
    const { offsets, s_next: after, r } = this.tables;
    const moves = this.random.random() < this.boxMoves;
    const i = offsets[this.place * this.nActions + a] + (moves ? 1 + this.random.either() : 0);
    return [after[i], r[i], false];
  }
}

// The mobile base among walls; see kinematic/base.py. Readings are the robot's sensors by their names.
class BaseWorld extends World {
  constructor(about, kernels) {
    super(about);
    this.kernels = kernels;
    for (const name of ["hull", "rays"]) this[name] = this[name].map((row) => Float64Array.from(row));
    this.build(this.walls);
    this.lengths = new Float64Array(this.rays.length);
    this.touch = new Float64Array(7);
    this.place = Float64Array.from(this.start);
  }

  // Other walls than those it had; the robot looks at them at its next step.
  build(walls) {
    this.walls = walls.map((wall) => Float64Array.from(wall));
    this.near = new Int32Array(walls.length);
  }

  reset() {
    return this.put(this.start);
  }

  // An episode begins at this place of the axle: x, y [m], heading [rad].
  put(place) {
    this.t = this.stepsAtGoal = 0;
    this.place = Float64Array.from(place);
    this.readings = this.sense(this.place);
    return this.stateOf(this.readings);
  }

  step(a) {
    const [v, omega] = this.twists[a], before = this.readings;
    const { place, stepTime, hull, radius, moment, walls, near, touch } = this;
    this.kernels.drive(place, v, omega, stepTime, hull, radius, moment, walls, near, touch);
    this.readings = this.sense(this.place);
    this.stepsAtGoal = this.kernels.goal && this.kernels.goal(this.readings) ? this.stepsAtGoal + 1 : 0;
    const terminated = this.stepsAtGoal >= this.goalSteps;
    return this.stepped(this.stateOf(this.readings), this.kernels.reward(before, this.readings), terminated);
  }

  // What the sensors tell at a place of the axle: x, y [m], heading [rad].
  sense(place) {
    const { inset, range, axle, lengths } = this;
    this.kernels.look(place, this.rays, inset + range, this.walls, lengths);
    const readings = {
      x: place[0] - axle * Math.cos(place[2]), y: place[1] - axle * Math.sin(place[2]), theta: place[2],
    };
    for (let i = 0; i < lengths.length; i++) {
      readings[this.lasers[i]] = Math.min(Math.max(lengths[i] - inset, 0), range);
    }
    return readings;
  }

  // The number of the state in which a robot is that senses this; see variables.py.
  stateOf(readings) {
    let s = 0;
    for (const { name, cuts, sectors } of this.inputs) {
      const x = readings[name];
      const bin = cuts ? cuts.filter((cut) => cut < x).length : Math.ceil((x * sectors) / (2 * Math.PI) - 0.5) + sectors;
      s = cuts ? s * (cuts.length + 1) + bin : s * sectors + (bin % sectors);
    }
    return s;
  }
}

// A learner in a world: step() by step(), as rl.learn does it.
class Simulation {
  constructor(kernels, memory, world, random) {
    Object.assign(this, { kernels, m: memory, world, random, t: 0, pending: null, last: null });
  }

  // luck: the random number by which the first action is chosen, in place of the one that is drawn
  // place: where the robot is put, in place of the start
  begin(luck = null, place = null) {
    const s = place ? this.world.put(place) : this.world.reset(), drawn = this.random.random();
    this.kernels.begin_episode(this.m);
    this.pending = [s, this.kernels.select(this.m, s, luck ?? drawn)];
  }

  // reward: what the step pays in place of what the world pays; luck: as above, for the next action
  step(reward = null, luck = null) {
    if (this.pending === null) this.begin();
    const [s, a] = this.pending, before = this.m.q[s][a];
    const [sNext, paid, terminated, truncated] = this.world.step(a), r = reward ?? paid, drawn = this.random.random();
    const [aNext, delta] = this.kernels.learn_step(this.m, s, a, r, sNext, terminated, luck ?? drawn);
    this.pending = terminated || truncated ? null : [sNext, aNext];
    this.t += 1;
    this.last = { s, a, r, sNext, aNext, delta, before, after: this.m.q[s][a], terminated, truncated };
    return this.last;
  }
}
