// The bias of one state in numbers, by the library's kernels, and in HTML: the formulas of the paper's example and bars.

const BAR = 80; // length of the bar of a probability of 1 [px]

// How QBIASSR chooses in state s, beside how SR would choose; q: a row for each state; scale: of both softmaxes.
// sets: for each input the states that share all others with s; members: all states that have a say, s first,
// each with the number of the one input in which it differs.
function biasOf({ shape, states, temperature }, q, scale, s) {
  const { sets } = states[s], room = () => new Float64Array(q[s].length);
  const m = { q, shape, bias: room(), probabilities: room(), parameters: { q_scale: scale }, now: { temperature } };
  kernels.sr(m, s);
  const sr = m.probabilities.slice();
  kernels.qbiassr(m, s);
  const mean = (set) => { // a set is a table of one input, in which each state has a say
    const means = room();
    kernels.compute_bias(set.map((k) => q[k]), [set.length], 0, means);
    return means;
  };
  const others = sets.flatMap((set, i) => set.filter((k) => k !== s).map((k) => [k, i]));
  return { sets, members: [[s, null], ...others], means: sets.map(mean), bias: m.bias, sr, qbiassr: m.probabilities };
}

function twoDecimals(x) { // with a true minus sign, which never stands before zero
  const text = x.toFixed(2);
  return +text === 0 ? "0.00" : text.replace("-", "−");
}

const vector = (x) => `<span class="rl-whole">(${Array.from(x, twoDecimals).join(", ")})</span>`;

// The mark of an input on its colour, after a number; without an input that of the state itself.
function chip({ inputs, here }, input, text = "") {
  const { sign, colour, ink } = inputs[input] ?? here;
  return `<span class="rl-chip" style="background:${colour};color:${ink}">${`${text} ${sign}`.trim()}</span>`;
}

const labelOf = ({ inputs }, input, k) => (input === null ? `▸${k}◂` : `${k} ${inputs[input].sign}`);

function saidHtml({ states, actions }, s, { bias }) {
  return `State ${s} (${escaped(states[s].words)}): bias ${vector(bias)} for ${escaped(actions.join(", "))}.`;
}

// What the colours and marks mean while state s is shown.
function legendHtml(about, s) {
  const others = about.inputs.map(({ name }, i) => `${chip(about, i)}&nbsp;${escaped(name)}`).join(", ");
  return `${chip(about, null, `▸${s}◂`)} is the state itself, a member of every set.<br>` +
    `The others share all inputs with it but one: ${others}.`;
}

// Softmax with and without the bias as pairs of bars.
function choiceHtml({ actions, temperature }, q, scale, s, { bias, sr, qbiassr }) {
  const bar = (p, kind) => `<i class="rl-length ${kind}" style="width:${Math.round(BAR * p)}px"></i>${(100 * p).toFixed(1)} %`;
  const rows = actions.map((name, a) => `<tr><th scope="row">${escaped(name)}</th>` +
    `<td>${bar(sr[a], "rl-sr")}<br>${bar(qbiassr[a], "rl-qbiassr")}</td></tr>`);
  const key = (kind) => `<i class="rl-length ${kind}" style="width:20px"></i>`;
  return `<h4>What it does to the choice in state&nbsp;${s}</h4><table>${rows.join("")}</table>` +
    `${key("rl-sr")}SR: softmax of <i>Q</i>(<i>s</i>) = ${vector(q[s])}<br>` +
    `${key("rl-qbiassr")}QBIASSR: softmax of <i>Q</i>(<i>s</i>) + bias(<i>s</i>) = ${vector(biased(q[s], bias))}<br>` +
    `Both first multiply by 100⁄<i>Q</i><sub>max</sub> = ${given(scale)}; <i>T</i>&nbsp;=&nbsp;${given(temperature)}.`;
}

const biased = (row, bias) => row.map((x, a) => x + bias[a]);

// The means, their average and what is chosen from, as in the paper's example, numbers for the symbols.
function formulasHtml(about, q, s, { sets, means, bias }) {
  const { inputs, states, actions } = about, own = (k, text) => (k === s ? `<b>${text}</b>` : text);
  const row = (left, symbols, values, result, kind = "") => `<tr class="${kind}"><th scope="row">${left}</th>` +
    `<td>= ${symbols}<br>= ${values} = <b>${vector(result)}</b></td></tr>`;
  const average = (terms) => `1⁄${terms.length} · [${terms.join(" + ")}]`;
  const nameOf = (i) => `bias<sub>${escaped(inputs[i].name)}</sub>`;
  const rows = sets.map((set, i) => row(
    `${chip(about, i)} ${nameOf(i)}(<i>s</i>)`, average(set.map((k) => own(k, `<i>Q</i>${escaped(states[k].text)}`))),
    average(set.map((k) => own(k, vector(q[k])))), means[i],
  ));
  rows.push(
    row("<b>bias(<i>s</i>)</b>", average(sets.map((_, i) => `${chip(about, i)} ${nameOf(i)}`)), average(means.map(vector)),
      bias, "rl-total"),
    row("<i>Q</i>(<i>s</i>)<sub>biased</sub>", "<i>Q</i>(<i>s</i>) + bias(<i>s</i>)", `${vector(q[s])} + ${vector(bias)}`,
      biased(q[s], bias), "rl-total"),
  );
  return `<h4>The formulas, with the numbers of state ${s}</h4>In each ( ) one number an action: ` +
    `${escaped(actions.join(", "))}. Bold: the state itself, a member of every set.<table>${rows.join("")}</table>`;
}
