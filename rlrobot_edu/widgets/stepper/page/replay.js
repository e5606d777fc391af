// The learner's simulation again, in this page, from where it began: the library's kernels in the same world with the same
// random numbers, and from one step on otherwise if the reader wishes. It makes frames as page_data.py does.

// What an equation needs at a frame: a simulation that was replayed may have gone on by another method and other settings.
const aboutAt = (about, frame) => ({ ...about, ...about.methods[frame?.method], parameters: frame?.parameters ?? about.parameters });

// The random number by which a softmax, or any other choice that goes through its probabilities, takes action a.
const luckFor = (p, a) => p.slice(0, a).reduce((sum, x) => sum + x, 0) + p[a] / 2;

const QUEUE = ["queue_states", "queue_rewards", "queue_count"]; // of loop evasion

class Replay {
  // replayData: what replay.py tells; settings: parameters that are to be others, from the step `from` on
  // fork: method: number of another algorithm from there on; reward: what that step is to pay; luck: by which its
  // action is to be chosen, and whether the step begins an episode
  constructor(about, replayData, settings, { from = 1, method = null, reward = null, luck = null, begins = false } = {}) {
    const { kernels, world, memory, random, place, scene } = replayData;
    const made = new { BaseWorld, ModelWorld, CellWorld }[world.kind](world, kernels, pcg64(random.world));
    const m = newMemory(world.shape, world.nActions, memory.parameters, kernels);
    m.q = tableOf(m.q.length, world.nActions, memory.q);
    m.visits = tableOf(m.q.length, world.nActions, memory.visits);
    for (const name of QUEUE) m[name].set(memory[name]);
    Object.assign(m.now, memory.now, { register_size: 0 });
    this.simulation = new Simulation(kernels, m, made, pcg64(random.agent));
    Object.assign(this, { about, place, scene, settings, from, method, reward, luck, begins, episode: 0, n: 0 });
    if (from === 1) this.turn(); // before the first action is chosen
  }

  // From here on the settings are others.
  turn() {
    const { settings, method, simulation } = this, before = simulation.m, { q, e, visits, probabilities, bias, now } = before;
    const m = newMemory(before.shape, probabilities.length, { ...before.parameters, ...settings }, simulation.kernels);
    Object.assign(m, { q, e, visits, probabilities, bias });
    Object.assign(m.now, now, "temperature" in settings ? { temperature: settings.temperature } : {});
    const register = before.register.subarray(0, now.register_size), room = m.register.length; // another λ: another length
    m.register.set(register.subarray(0, room));
    register.subarray(room).forEach((s) => e[s].fill(0));
    m.now.register_size = Math.min(register.length, room);
    if (m.queue_states.length === before.queue_states.length) for (const name of QUEUE) m[name].set(before[name]);
    else Object.assign(m.now, { queue_size: 0, queue_unique: 0, queue_end: 0 });
    simulation.m = m;
    if (!method) return; // 0 is its own
    const { kernels, pending } = simulation;
    simulation.kernels = { ...kernels, select: kernels[`select_${method}`], learn_step: kernels[`learn_step_${method}`] };
    this.about = { ...this.about, ...this.about.methods[method] };
    if (pending) m.now.q_old = q[pending[0]][pending[1]]; // TOSL begins as if it had missed nothing
    this.turned = method;
  }

  // The next step, as a frame.
  step() {
    const { simulation, from } = this, begins = simulation.pending === null, t = simulation.t + 1;
    if (begins) {
      simulation.begin(t === from ? this.luck : null);
      this.episode += 1;
      this.n = 0;
    }
    if (t === from && from > 1) this.turn();
    const { about } = this, { nActions } = about, { m } = simulation;
    const start = begins ? this.look() : undefined, [s, a] = simulation.pending, { q_old: qOld, temperature } = m.now;
    const e = begins ? 0 : m.e[s][a], p = Array.from(m.probabilities);
    const bias = about.isBiased ? Array.from(m.bias) : null, traces = this.traces(s, a, begins);
    const before = m.q.map((row) => row.slice());
    const luck = t + 1 === from && !this.begins ? this.luck : null, where = [], values = [];
    const { r, sNext: s2, aNext, delta, terminated, truncated } = simulation.step(t === from ? this.reward : null, luck);
    m.q.forEach((row, i) => row.forEach((value, j) => {
      if (value !== before[i][j]) {
        where.push(i * nActions + j);
        values.push(value);
      }
    }));
    const next = before[s2], mean = () => next.reduce((sum, value, i) => sum + value * m.probabilities[i], 0);
    const qNext = terminated ? 0 : { taken: next[aNext], best: Math.max(...next), mean: mean() }[about.next];
    return { t: simulation.t - 1, s, a, r, s2, a2: terminated ? null : aNext, delta, terminated, truncated, p, bias, temperature,
      episode: this.episode, n: ++this.n, start, look: this.look(), qNext, e, qOld, traces, q: [where, values],
      pNext: Array.from(m.probabilities), parameters: m.parameters, method: this.turned };
  }

  // Flat positions and values of the traces that the pairs before still have, and of (s, a) as its visit leaves it.
  traces(s, a, begins) {
    const { m } = this.simulation, { nActions, trace } = this.about, where = [], values = [];
    if (!trace) return [where, values];
    const size = m.now.register_size, register = m.register.subarray(0, size);
    const goes = !begins && size === m.register.length && !register.includes(s) ? register[size - 1] : -1;
    if (!begins) {
      for (const state of new Set(register)) {
        m.e[state].forEach((e, i) => {
          if (e === 0 || state === goes || (state === s && i === a)) return;
          where.push(state * nActions + i);
          values.push(e);
        });
      }
    }
    const e = begins ? 0 : m.e[s][a], alpha = m.parameters.alpha;
    where.push(s * nActions + a);
    values.push({ accumulating: e + 1, replacing: 1, dutch: (1 - alpha) * e + 1 }[trace]);
    return [where, values];
  }

  // What is to be seen now; undefined where that is the state itself.
  look() {
    const { world } = this.simulation, { scene } = this;
    if (!scene) return undefined;
    const place = world.readings ? ["x", "y", "theta"].map((name) => world.readings[name]) : this.cellPlace();
    const [x0, y0, theta0] = this.place, turn = place[2] - theta0, cos = Math.cos(turn), sin = Math.sin(turn);
    const moved = ([x, y]) => [place[0] + (x - x0) * cos - (y - y0) * sin, place[1] + (x - x0) * sin + (y - y0) * cos];
    const box = world.drawn ? world.drawn[world.place].box : null;
    const aside = box ? box.map((at, i) => at - scene.box[i]) : [0, 0];
    const solids = scene.solids.map(([role, points]) =>
      [role, role === "object" ? points.map(([x, y]) => [x + aside[0], y + aside[1]]) : points]);
    const [x, y] = moved(scene.place);
    return { place: [x, y, scene.place[2] + turn], solids, beams: this.beams(), box };
  }

  cellPlace() {
    const { cell, heading } = this.simulation.world.drawn[this.simulation.world.place];
    return [cell[0] - 0.5, cell[1] - 0.5, (heading * Math.PI) / 180];
  }

  beams() {
    const { world } = this.simulation;
    if (!world.rays) return [];
    const [x, y, theta] = world.place, cos = Math.cos(theta), sin = Math.sin(theta);
    return world.rays.flatMap(([a, b, ahead, aside], i) => {
      if (!this.scene.beams.length) return [];
      const at = (far) => [a + ahead * far, b + aside * far];
      const from = ([u, v]) => [x + u * cos - v * sin, y + u * sin + v * cos];
      return [[...from(at(world.inset)), ...from(at(Math.min(world.lengths[i], world.inset + world.range)))]];
    });
  }
}
