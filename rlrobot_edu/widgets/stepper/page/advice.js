// Whose advice is a bias? The library's selection chooses once more, by the values of one state at a time.

// What each state has added to the bias of action a in state s, the most first: [state, its Q, its share]; the sum;
// and the probabilities that a choice without similar states would have had.
function advice({ q, visits, shape, parameters, temperature }, s, a) {
  const zeros = q.map((row) => row.map(() => 0)), room = () => q[s].map(() => 0);
  const m = { q: zeros, visits, shape, now: { temperature }, bias: room(), probabilities: room() };
  m.parameters = { q_scale: scaleOf(parameters) };
  const said = count(q.length).filter((k) => q[k][a]).map((k) => {
    zeros[k][a] = q[k][a];
    choice(m, s);
    zeros[k][a] = 0;
    return [k, q[k][a], m.bias[a]];
  }).filter(([, , share]) => share).sort((one, other) => Math.abs(other[2]) - Math.abs(one[2]));
  choice(Object.assign(m, { q, shape: [] }), s); // no inputs, no similar states
  return { said, sum: said.reduce((sum, [, , share]) => sum + share, 0), alone: m.probabilities };
}

// The states behind the bias of an action, in the choice of the step shown; without one, of the action that was taken.
function adviceHtml(always, tape, asked) {
  const { frame, t } = tape, about = aboutAt(always, frame), { names } = about, { shape } = names;
  if (!frame) return '<p role="status">Before the first step nothing has been chosen.</p>';
  const { s, bias, temperature } = frame, a = asked ?? frame.a, { visits } = tape.copyAt(frame.t);
  // SARSA and its relatives choose before they learn from the step before, Q-learning after it
  const found = [frame.t, frame.t - 1].filter((at) => at >= tape.dropped)
    .map((at) => advice({ q: tape.copyAt(at).q, visits, shape, parameters: about.parameters, temperature }, s, a))
    .find(({ sum }) => Math.abs(sum - bias[a]) <= 1e-5 * Math.max(1, Math.abs(bias[a])));
  if (!found) return `<p role="status">The advice in step ${t} is unknown: the values of that time are not kept.</p>`;
  const most = Math.max(...found.said.map(([, , share]) => Math.abs(share)), 1e-300), own = binsOf(names, s);
  const unlike = (k) => (k === s ? "the state itself" : binsOf(names, k).flatMap((bin, i) => (bin === own[i] ? []
    : `${names.inputs[i]} = ${readingsOf(names, k)[i]}`)).join(", "));
  const rows = found.said.map(([k, value, share]) => `<tr><th>${k}</th><td class="words">${escaped(unlike(k))}</td>` +
    `<td data-at="${k * about.nActions + a}" style="background:${tint(value, about.rMax)}">${number(value)}</td>` +
    `<td style="background:${tint(share, most)}">${signed(share)}</td></tr>`);
  const heading = `<tr><th>state</th><th>it differs in</th><th>its Q</th><th>its share</th></tr>`;
  const said = `<b>bias(${s}, ${escaped(named(names, a))}) = ${number(bias[a])} in step ${t}.</b> With it the probability of this ` +
    `action was ${frame.p[a].toFixed(3)}; by Q alone it would have been ${found.alone[a].toFixed(3)}. `;
  return `<p role="status">${said}${rows.length ? "Whose advice it was:" : "No similar state has a value for it."}</p>` +
    `${rows.length ? `<table class="advice">${heading}${rows.join("")}</table><p class="note">Click a Q: who paid for it?</p>` : ""}`;
}
