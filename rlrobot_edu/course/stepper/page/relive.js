// The learner's life again, in this page, from where it began: the library's kernels in the same world with the same
// random numbers, by other settings if the reader wishes. It makes frames as told.py does.

class Relived {
  // lives: what lives.py tells; settings: parameters that are to be others
  constructor(about, lives, settings) {
    const { kernels, world, memory, random, place, scene } = lives, parameters = { ...memory.parameters, ...settings };
    const made = new { BaseWorld, ModelWorld, CellWorld, ChanceWorld }[world.kind](world, kernels, pcg64(random.world));
    const m = newMemory(world.shape, world.nActions, parameters, kernels);
    m.q = tableOf(m.q.length, world.nActions, memory.q);
    m.visits = tableOf(m.q.length, world.nActions, memory.visits);
    for (const name of ["queue_states", "queue_rewards", "queue_count"]) {
      if (m[name].length === memory[name].length) m[name].set(memory[name]); // another λ has another length
    }
    Object.assign(m.now, memory.now, "temperature" in settings ? { temperature: settings.temperature } : {}, { register_size: 0 });
    this.life = new Life(kernels, m, made, pcg64(random.agent));
    Object.assign(this, { about, place, scene, episode: 0, n: 0 });
  }

  // The next step, as a frame.
  step() {
    const { life, about } = this, { m } = life, begins = life.pending === null, { nActions } = about;
    if (begins) {
      life.begin();
      this.episode += 1;
      this.n = 0;
    }
    const start = begins ? this.look() : undefined, [s, a] = life.pending, { q_old: qOld, temperature } = m.now;
    const e = begins ? 0 : m.e[s][a], p = Array.from(m.probabilities);
    const bias = about.isBiased ? Array.from(m.bias) : null, traces = this.traces(s, a, begins);
    const before = m.q.map((row) => row.slice());
    const { r, sNext: s2, aNext, delta, terminated, truncated } = life.step(), where = [], values = [];
    m.q.forEach((row, i) => row.forEach((value, j) => {
      if (value !== before[i][j]) {
        where.push(i * nActions + j);
        values.push(value);
      }
    }));
    const next = before[s2], mean = () => next.reduce((sum, value, i) => sum + value * m.probabilities[i], 0);
    const qNext = terminated ? 0 : { taken: next[aNext], best: Math.max(...next), mean: mean() }[about.next];
    return { t: life.t - 1, s, a, r, s2, a2: terminated ? null : aNext, delta, terminated, truncated, p, bias, temperature,
      episode: this.episode, n: ++this.n, start, look: this.look(), qNext, e, qOld, traces, q: [where, values] };
  }

  // Flat positions and values of the traces that the pairs before still have, and of (s, a) as its visit leaves it.
  traces(s, a, begins) {
    const { m } = this.life, { nActions, trace } = this.about, where = [], values = [];
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
    const { world } = this.life, { scene } = this;
    if (!scene) return undefined;
    const place = world.readings ? ["x", "y", "theta"].map((name) => world.readings[name]) : this.cellPlace();
    const [x0, y0, theta0] = this.place, turn = place[2] - theta0, cos = Math.cos(turn), sin = Math.sin(turn);
    const moved = ([x, y]) => [place[0] + (x - x0) * cos - (y - y0) * sin, place[1] + (x - x0) * sin + (y - y0) * cos];
    const box = world.drawn ? world.drawn[world.place].box : null;
    const aside = box ? box.map((at, i) => at - scene.box[i]) : [0, 0];
    const moving = scene.moving.map(([role, points]) => [role, role === "goal" ? points
      : role === "object" ? points.map(([x, y]) => [x + aside[0], y + aside[1]]) : points.map(moved)]);
    const [x, y] = moved(scene.place);
    return { place: [x, y, scene.place[2] + turn], nose: moved(scene.nose), moving, beams: this.beams(), box };
  }

  cellPlace() {
    const { cell, heading } = this.life.world.drawn[this.life.world.place];
    return [cell[0] - 0.5, cell[1] - 0.5, (heading * Math.PI) / 180];
  }

  beams() {
    const { world } = this.life;
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
