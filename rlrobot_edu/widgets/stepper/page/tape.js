// The steps of a learner, forwards and back, and its tables as they were at the position shown.

// A table of nStates rows from its entries that are not 0: their flat positions and their values.
function tableOf(nStates, nActions, [where, values]) {
  const table = Array.from({ length: nStates }, () => new Float64Array(nActions));
  where.forEach((at, i) => { table[Math.floor(at / nActions)][at % nActions] = values[i]; });
  return table;
}

// A frame is one step, as page_data.py tells it. What the tables were before the step is noted when it is first shown.
class Tape {
  // start: the tables before the first frame, and how many steps there had been; keep: so many frames are kept
  constructor(nStates, nActions, { q, visits, dropped }, keep) {
    Object.assign(this, { nActions, keep, dropped, frames: [], t: dropped });
    this.q = tableOf(nStates, nActions, q);
    this.visits = tableOf(nStates, nActions, visits);
  }

  get end() { return this.dropped + this.frames.length; }
  get first() { return this.dropped ? this.dropped + 1 : 0; } // the earliest position that can still be shown
  get frame() { return this.t > this.dropped ? this.at(this.t) : null; } // the step that led to the position shown
  at(t) { return this.frames[t - 1 - this.dropped]; }

  add(frames) {
    for (const frame of frames) this.frames.push(frame);
    const over = this.frames.length - this.keep;
    if (over <= 0) return;
    this.go(Math.max(this.t, this.dropped + over + 1)); // what is shown is kept
    this.frames.splice(0, over);
    this.dropped += over;
  }

  forward() {
    const frame = this.at(++this.t), { s, a, s2, q: [where, values] } = frame, { q, nActions } = this;
    if (!frame.old) {
      frame.old = where.map((at) => q[Math.floor(at / nActions)][at % nActions]);
      frame.qsa = q[s][a];
      frame.best = q[s2].indexOf(Math.max(...q[s2]));
    }
    where.forEach((at, i) => { q[Math.floor(at / nActions)][at % nActions] = values[i]; });
    this.visits[s][a] += 1;
  }

  back() {
    const { s, a, q: [where], old } = this.at(this.t--);
    where.forEach((at, i) => { this.q[Math.floor(at / this.nActions)][at % this.nActions] = old[i]; });
    this.visits[s][a] -= 1;
  }

  // Show position t, which is on the tape.
  go(t) {
    while (this.t < t) this.forward();
    while (this.t > t) this.back();
  }

  // Q and visits as they were at a position.
  copyAt(at) {
    const { t } = this;
    this.go(at);
    const [q, visits] = [this.q, this.visits].map((table) => table.map((row) => [...row]));
    this.go(t);
    return { q, visits };
  }

  // The frames of the latest steps, so many at most, up to the position shown.
  latest(limit) {
    return this.frames.slice(Math.max(0, this.t - this.dropped - limit), this.t - this.dropped);
  }

  // What was to be seen in the latest steps of this episode, up to the position shown.
  looks() {
    if (this.t === 0) return [startOf(this.at(1))];
    const latest = this.latest(PATH), begun = latest.findLastIndex(({ n }) => n === 1);
    const seen = latest.slice(Math.max(0, begun)).map((frame) => frame.look ?? frame.s2);
    return begun < 0 ? seen : [startOf(latest[begun]), ...seen];
  }

  // The states that were visited and the actions that were taken most recently, the latest first.
  recent(limit) {
    if (this.t === 0) return [[this.at(1).s], []];
    const states = new Set(), actions = new Set();
    for (let t = this.t; t > this.dropped && states.size < limit; t--) {
      const { s, a, s2 } = this.at(t);
      states.add(s2).add(s);
      actions.add(a);
    }
    return [[...states].slice(0, limit), [...actions].slice(0, limit)];
  }
}
const PATH = 60; // steps; as long is the trail that a robot draws behind itself
const lookBefore = (tape, frame) => frame.start ?? (frame.t > tape.dropped ? tape.at(frame.t).look : null);
const startOf = (frame) => frame.start ?? frame.s;
const over = (frame) => frame.terminated || frame.truncated;
