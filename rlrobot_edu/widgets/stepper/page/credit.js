// Who paid for a value? The library's updates run a second time, on numbers that remember of which they were made.

// A number: value; parts: the numbers that it was made of, each with by how much it grows with them
class Made {
  constructor(value, parts) {
    Object.assign(this, { value, parts, at: book.length });
    book.push(this);
  }

  valueOf() { return this.value; }
}
let book = []; // all numbers made by the updates that run now, the oldest first

// What credit_kernels.py lets the updates call in place of + − ·; plain numbers stay plain.
function made(value, ...parts) {
  const kept = parts.filter(([x, by]) => x instanceof Made && by !== 0);
  return kept.length ? new Made(value, kept) : value;
}
const $plus = (x, y) => (y === 0 ? x : made(x + y, [x, 1], [y, 1]));
const $minus = (x, y) => made(x - y, [x, 1], [y, -1]);
const $times = (x, y) => made(x * y, [x, +y], [y, +x]);
const $negative = (x) => made(-x, [x, -1]);

// The rewards of a tape's steps, and which values they paid, at any of its positions.
class Ledger {
  constructor({ nStates, nActions }, tape) {
    const { q } = tape.copyAt(tape.dropped);
    Object.assign(this, { tape, nActions, dropped: tape.dropped, book: [], rewards: [], learned: [] });
    this.m = { q, register: new Int32Array(nStates), now: { q_old: 0 }, e: q.map((row) => new Float64Array(row.length)) };
  }

  // Learn from all steps that the tape has. Throws an error where the numbers are not those of the tape.
  grow() {
    book = this.book;
    while (this.dropped + this.rewards.length < this.tape.end) this.learn(this.tape.at(this.dropped + this.rewards.length + 1));
    return this;
  }

  // The update of one step, with its traces as they were.
  learn(frame) {
    const { m, nActions } = this, { s, a, s2, a2, n, e, qOld, traces: [where, values], q: [changed, after] } = frame;
    const place = (at) => [Math.floor(at / nActions), at % nActions], pair = s * nActions + a, states = new Set();
    m.e.forEach((row) => row.fill(0));
    where.forEach((at, i) => {
      const [x, b] = place(at);
      m.e[x][b] = at === pair ? e : values[i];
      states.add(x);
    });
    m.register.set([...states]);
    m.now.register_size = states.size;
    if (n === 1) m.now.q_old = 0;
    else if (+m.now.q_old !== qOld) m.now.q_old = +m.q[s][a] === qOld ? m.q[s][a] : qOld; // a fork, or the tape's first step
    m.parameters = { ...updates.parameters, ...frame.parameters };
    m.probabilities = frame.pNext;
    const paid = new Made(frame.r, []);
    updates.kernels[`update_${frame.method ?? 0}`](m, s, a, paid, s2, a2 ?? -1, frame.terminated);
    changed.forEach((at, i) => {
      const [x, b] = place(at);
      if (+m.q[x][b] === after[i]) return;
      throw new Error(`From step ${frame.t + 1} on the payments are unknown: the settings were changed while it learned.`);
    });
    this.rewards.push(paid);
    this.learned.push(new Map([pair, ...where].map((at) => [at, m.q[place(at)[0]][place(at)[1]]])));
  }

  // Q(s, a) as it is after step t, with all that it was made of; a plain number where no reward came to it.
  value(t, s, a) {
    const at = s * this.nActions + a;
    for (let i = t - this.dropped - 1; i >= 0; i--) if (this.learned[i].has(at)) return this.learned[i].get(at);
    return 0;
  }

  // What each step paid for a number, the first one that is kept first: its derivative, from it back to the rewards.
  shares(x) {
    const grows = new Float64Array(this.book.length);
    if (x instanceof Made) grows[x.at] = 1;
    for (let at = x.at ?? -1; at >= 0; at--) {
      if (grows[at] !== 0) for (const [part, by] of this.book[at].parts) grows[part.at] += by * grows[at];
    }
    return this.rewards.map((paid) => grows[paid.at] * paid);
  }

  // What step k has paid for each value after step t: rows of actions. From the reward forwards.
  paidBy(k, t) {
    const grows = new Float64Array(this.book.length), paid = this.rewards[k - this.dropped - 1];
    grows[paid.at] = 1;
    for (let at = paid.at + 1; at < grows.length; at++) {
      for (const [part, by] of this.book[at].parts) grows[at] += by * grows[part.at];
    }
    return this.m.q.map((row, s) => row.map((_, a) => (grows[this.value(t, s, a).at] ?? 0) * paid));
  }
}

const signed = (x) => (x > 0 ? `+${number(x)}` : number(x));
const MOST_TOLD = 3, MOST_LIT = 12; // shares in words, and on the map

// Who paid for Q(s, a), or for its lead over Q(s, rather); step: whose payments are shown, by default the largest.
// Sets tape.lit, what the map shows: steps and their shares.
function paidHtml(about, tape, { s, a, rather = null, step = null }) {
  tape.ledger = tape.ledger?.dropped === tape.dropped ? tape.ledger : new Ledger(about, tape);
  const ledger = tape.ledger.grow(), { t, dropped } = tape, { names, parameters } = about;
  const of = (b) => ledger.shares(ledger.value(t, s, b)), own = of(a), others = rather === null ? null : of(rather);
  const shares = own.slice(0, t - dropped).map((share, i) => share - (others ? others[i] : 0));
  const value = tape.q[s][a] - (others ? tape.q[s][rather] : 0), most = Math.max(...shares.map(Math.abs), 1e-300);
  const order = count(shares.length).filter((i) => shares[i]).sort((i, j) => Math.abs(shares[j]) - Math.abs(shares[i]) || i - j);
  const frameOf = (i) => tape.at(dropped + i + 1), rest = value - shares.reduce((sum, x) => sum + x, 0);
  tape.lit = order.slice(0, MOST_LIT).map((i) => [frameOf(i), shares[i] / most]);
  const name = (b) => `Q(${s}, ${escaped(named(names, b))})`;
  const told = order.slice(0, MOST_TOLD).map((i) => {
    const { t: at, s: state, a: action, r } = frameOf(i);
    return `<button name="${at + 1}" title="What else it paid">step ${at + 1}</button>, ` +
      `a = ${escaped(named(names, action))} in s = ${state} for r = ${given(r)}: <b>${signed(shares[i])}</b>` +
      (others ? ` (${lead(names, a)} ${signed(own[i])}, ${lead(names, rather)} ${signed(others[i])})` : "");
  });
  const before = Math.abs(rest) > 1e-9 ? ` What was known before: ${signed(rest)}.` : "";
  const visits = count(t - dropped).filter((i) => frameOf(i).s === s).slice(-MOST_TOLD).map((i) => goHtml(dropped + i + 1));
  const seen = `<p>State ${s}${names.inputs.length ? ` is ${escaped(stateInWords(names, s))}` : ""}. ` +
    (visits.length ? `Last steps there: ${visits.join(" ")}.` : "No step there.") +
    (others && about.isSoftmax ? ` By Q alone, at T = ${given(parameters.temperature)}, that makes ${lead(names, a)} ` +
      `${number(Math.exp(value * scaleOf(parameters) / parameters.temperature))} times as probable.` : "") + "</p>";
  const said = `<b>${name(a)}${others ? ` − ${name(rather)}` : ""} = ${number(value)}.</b> ` +
    (told.length ? `${order.length} of ${t - dropped} steps paid for it; most: ${told.join("; ")}.` : "No step has paid for it.") + before;
  const bars = shares.map((share, i) => share && `<rect data-step="${dropped + i + 1}" x="${i}" width="1" ` +
    `y="${share > 0 ? 1 - share / most : 1}" height="${Math.abs(share) / most}" fill="${share > 0 ? BLUE : VERMILION}"/>`);
  const chosen = step ?? (order.length ? dropped + order[0] + 1 : null), at = chosen - dropped - 1;
  const mark = chosen === null || chosen > t ? "" : `<rect class="chosen" x="${at}" width="1" y="0" height="2"/>`;
  const line = `<svg class="time" viewBox="0 0 ${Math.max(shares.length, 1)} 2" preserveAspectRatio="none" role="img" ` +
    `aria-label="The share of each step.">` +
    `<path d="M0,1H${shares.length}"/>${bars.filter(Boolean).join("")}${mark}</svg>`;
  return `<p role="status">${said}</p>${seen}${line}<p class="note">Each step that paid, from step ${dropped + 1} to step ${t}: up, it raised ` +
    `the number; down, it lowered it. Click a bar. Rings on the map: where.</p>${mark && stepPaidHtml(about, tape, chosen)}`;
}

const lead = ({ rows }, a) => escaped(rows[a]);
const goHtml = (k) => `<button data-go="${k}">→ ${k}</button>`;

// All values that one step paid for, in the places of Q.
function stepPaidHtml(about, tape, k) {
  const paid = tape.ledger.paidBy(k, tape.t), most = Math.max(...paid.flat().map(Math.abs), 1e-300), { s, a, r } = tape.at(k);
  const cell = (x, b) => {
    const share = paid[x][b], kind = x === s && b === a ? ' class="pair"' : "";
    return share ? `<td${kind} style="background:${tint(share, most)}">${short(share)}</td>` : `<td class="dot">·</td>`;
  };
  return `<section class="traces"><h2>What step ${k} has paid, cell by cell: a = ${escaped(named(about.names, a))} in s = ${s}, ` +
    `r = ${given(r)} ${goHtml(k)}</h2>${blocks(about, cell, windowOf(tape), null)}</section>`;
}

// Where the steps that paid were taken: circles, the larger the more, blue for what raised the number.
function litHtml({ lit = [] }, placeOf) {
  return lit.map(([frame, share]) => [placeOf(frame), share]).filter(([place]) => place).map(([[x, y], share]) =>
    `<circle class="lit" cx="${x}" cy="${y}" r="${(0.05 + 0.17 * Math.sqrt(Math.abs(share))).toFixed(3)}" ` +
    `stroke="${share > 0 ? BLUE : VERMILION}"${share > 0 ? "" : ' stroke-dasharray="3 2"'}/>`).join("");
}
