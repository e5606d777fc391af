// A run: a simulation, and what the page remembers of it: the score, the curve, its way, and what it met on the floor.

const TRAIL = 240, BUMPS = 600; // steps for which its way is drawn, and the places where it bumped
const PERIOD = 600; // steps of the score: ten minutes of its life
const TILE = 0.25; // side of a piece of floor [m]

class Run {
  constructor(settings, walls) {
    this.simulation = newSimulation(settings, walls);
    this.score = new Score();
    this.curve = new Curve(this.score);
    this.trail = [];
    this.bumps = [];
    this.isBump = false; // in the last step
    this.from = null; // where it was before the last step
    if (this.world.bounds) this.floor = new Floor(this.world.bounds);
  }

  get world() {
    return this.simulation.world;
  }

  // Where it is: x, y, heading; in the cells, what is to be drawn.
  get here() {
    return this.world.drawn ? this.world.drawn[this.world.place] : Array.from(this.world.place);
  }

  step() {
    const world = this.world, told = this.simulation.step(), { atMost } = world.score;
    const counts = atMost === null ? told.terminated : told.r <= atMost;
    this.score.add(counts, told.r);
    this.curve.note();
    if (!this.floor) return;
    const [x, y, heading] = world.place;
    this.floor.met(x, y, heading, told.sNext);
    if (this.trail.push([x, y, told.r]) > TRAIL) this.trail.shift();
    this.isBump = told.r <= -2 && !(atMost === null && told.terminated);
    if (this.isBump) this.bumps.push([x, y, this.simulation.t]);
    if (told.terminated || told.truncated) this.trail = [];
  }

  // After some steps: bumps of long ago are drawn no longer.
  forget() {
    if (this.bumps.length && this.bumps[0][2] <= this.simulation.t - BUMPS) {
      this.bumps = this.bumps.filter(([, , t]) => t > this.simulation.t - BUMPS);
    }
  }

  // Put the robot elsewhere by hand: a new episode begins there.
  put(place) {
    this.simulation.begin(null, place);
    this.trail = [];
    this.isBump = false;
    this.from = null;
  }
}

// How often it happened (a bump, an arrival) in the first PERIOD of steps and in the last, and the reward of the last.
class Score {
  constructor() {
    const recent = new Uint8Array(PERIOD), rewards = new Float64Array(PERIOD);
    Object.assign(this, { t: 0, first: 0, last: 0, recent, reward: 0, rewards });
  }

  // The last PERIOD, or what there is of it: how often it happened, and the mean reward of a step.
  get now() {
    return { t: this.t, counts: this.last, rewards: this.reward / Math.max(1, Math.min(this.t, PERIOD)) };
  }

  add(happened, reward) {
    const at = this.t % PERIOD, one = happened ? 1 : 0;
    this.last += one - this.recent[at];
    this.recent[at] = one;
    this.reward += reward - this.rewards[at];
    this.rewards[at] = reward;
    if (this.t < PERIOD) this.first += one;
    this.t += 1;
  }
}

// The floor in square pieces; of each, the state in which the robot was when it was there last, and its heading then.
class Floor {
  constructor([xMin, yMin, xMax, yMax]) {
    Object.assign(this, { xMin, yMin, columns: Math.ceil((xMax - xMin) / TILE) });
    const n = this.columns * Math.ceil((yMax - yMin) / TILE);
    this.states = new Int32Array(n).fill(-1);
    this.headings = new Float64Array(n);
  }

  met(x, y, heading, s) {
    const i = Math.floor((y - this.yMin) / TILE) * this.columns + Math.floor((x - this.xMin) / TILE);
    this.states[i] = s;
    this.headings[i] = heading;
  }

  // Of each piece where it has been: x, y of its middle, state, heading.
  * places() {
    for (let i = 0; i < this.states.length; i++) {
      if (this.states[i] < 0) continue;
      const row = Math.floor(i / this.columns), column = i % this.columns;
      yield [this.xMin + (column + 0.5) * TILE, this.yMin + (row + 0.5) * TILE, this.states[i], this.headings[i]];
    }
  }
}

const bestOf = (q) => q.reduce((best, value, a) => (value > q[best] ? a : best), 0); // the first of several
