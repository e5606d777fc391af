// The bias of one state in numbers, by the library's kernels, and in sentences.

// How QBIASSR chooses in state s, beside how SR would choose; q: a row for each state; scale: of both softmaxes.
// sets: for each input the states that share all others with s; members: all states that have a say, s first,
// each with the number of the one input in which it differs; flows: for each action what each line of its columns carries,
// from a state to the mean of a set and from that to the bias.
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
  const members = [[s, null], ...others], means = sets.map(mean), all = sets.map((_, i) => i);
  const flows = Array.from(sr, (_, a) => [
    ...members.flatMap(([k, input]) => (input === null ? all : [input]).map((i) => q[k][a] / sets[i].length)),
    ...means.map((x) => x[a]),
  ]);
  return { sets, members, means, bias: m.bias, sr, qbiassr: m.probabilities, flows };
}

// A value: two decimals, or two digits that count where two decimals would hide it: −0.30, −0.0075, 476.9. Only 0 is 0.00.
function amount(x) {
  const size = Math.abs(x);
  if (size < SMALLEST) return "0.00";
  if (size < 0.1) return tidy(general(x, 2));
  return size < 100 ? tidy(x.toFixed(2)) : number(x);
}
const SMALLEST = 1e-9; // less is what rounding leaves of a sum

// Two probabilities in percent, with as many decimals as it takes to tell them apart.
function percents(p, other, decimals) {
  const [one, two] = [p, other].map((x) => `${(100 * x).toFixed(decimals)} %`);
  return one === two && Math.abs(p - other) > SAME ? percents(p, other, decimals + 1) : [one, two];
}
const SAME = 1e-6; // probabilities that differ by less count as the same

const summand = (x, i) => (i && x <= -SMALLEST ? `(${amount(x)})` : amount(x));
const whole = (text) => `<span class="rl-whole">${text}</span>`;
const vector = (x) => whole(`(${Array.from(x, amount).join(", ")})`);

// The mark of an input on its colour; the state itself, which is in every set, has the marks of all.
function marksHtml({ inputs }, input) {
  return (input === null ? inputs : [inputs[input]]).map(({ sign, colour }) =>
    `<span class="rl-mark" style="background:${colour}">${sign}</span>`).join("");
}

// Above the title, by the state's own row of Q.
const question = (row) => (row.some(Boolean) ? "What do similar states advise the robot here?"
  : "The robot has learned nothing here. Who can advise it?");

// The action whose probability the bias changes most.
function mostChanged({ sr, qbiassr }) {
  const changes = qbiassr.map((p, a) => Math.abs(p - sr[a]));
  return changes.indexOf(Math.max(...changes));
}

// What the similar states bring into the bias of action a, without the state's own value, which is in every set.
const fromOthers = (a, q, { sets, bias }, s) => bias[a] - (q[s][a] * sets.reduce((sum, set) => sum + 1 / set.length, 0)) / sets.length;

// In large type: the action whose probability the bias changes most, and whether that is the similar states' doing.
function findingHtml({ actions }, q, s, found) {
  const { sr, qbiassr, bias, members } = found, a = mostChanged(found), [before, now] = percents(sr[a], qbiassr[a], 0);
  const rises = qbiassr[a] > sr[a], advice = fromOthers(a, q, found, s), isTheirs = Math.abs(advice) >= Math.abs(bias[a] - advice);
  const name = `“${escaped(actions[a])}”`, change = `${rises ? "rises" : "falls"} from <span>${before} to ${now}</span>`;
  const told = before === now ? `Similar states change nothing here: ${name} keeps <span>${now}</span>`
    : isTheirs && advice > 0 && rises ? `Similar states speak for ${name}: its chance ${change}`
      : isTheirs && advice < 0 && !rises ? `Similar states speak against ${name}: its chance ${change}`
        : `With its bias, the chance of ${name} ${change}`;
  return `<b>${told}</b>How likely the robot is to choose it here, without and with the advice of ${members.length - 1} similar states.`;
}

// What the reader sees, in words: stage is the number of columns, and a the action of the first three.
function saidHtml(about, q, s, a, stage, { sets, means, bias, sr, qbiassr }) {
  const { inputs, states, actions } = about, action = `<b>${escaped(actions[a])}</b>`;
  const named = (i) => `${marksHtml(about, i)}&nbsp;${escaped(inputs[i].name)}`;
  const mean = (terms, result) => whole(`(${terms.map(summand).join(" + ")}) / ${terms.length}`) +
    ` = <b>${amount(result)}</b>`;
  const each = (what) => sets.map((set, i) => `${named(i)}: ${what(set, i)}`).join("; ");
  const text = [
    () => `its own row of <i>Q</i> says ${amount(q[s][a])} for ${action}.`,
    () => "similar states share all inputs with it but one. The state itself is in every set. " +
      `${each((set) => set.map((k) => whole(`${k} ${escaped(states[k].text)}`)).join(", "))}.`,
    () => `the mean of each set for ${action}. ${each((set, i) => mean(set.map((k) => q[k][a]), means[i][a]))}.`,
    () => `the bias for ${action} is the mean of the means, ${mean(means.map((x) => x[a]), bias[a])}.`,
    () => `bias ${vector(bias)} for ${escaped(actions.join(", "))}; added to <i>Q</i>(<i>s</i>): ` +
      `${vector(bias.map((x, i) => x + q[s][i]))}. The softmax compares all actions: ` +
      `<i>P</i> = ${Array.from(qbiassr, (p, b) => percents(p, sr[b], 1)[0]).join(", ")}.`,
  ];
  return `State ${s} (${escaped(states[s].words)}): ${text[stage]()}`;
}

// What the marks and the lines mean.
function legendHtml(about, s, stage) {
  const meanings = isRoom(about) ? [" place", " place", " heading", " something ahead"] : [];
  const names = about.inputs.map(({ name }, i) => `${marksHtml(about, i)}&nbsp;${escaped(name)}${meanings[i] ?? ""}`).join(", ");
  return `The robot is in state ${s}. A similar state differs from it in one input alone: ${names}. ` +
    (stage < 2 ? "" : "The wider a line, the more it brings; a dashed one brings less than 0.");
}

// What the bars mean, below the columns.
function barsHtml({ temperature }, scale) {
  const bar = (kind) => `<i class="rl-key ${kind}"></i>`;
  return `${bar("rl-sr")}without the bias, ${bar("rl-qbiassr")}with it. The chances are the softmax of <i>Q</i>(<i>s</i>), and of ` +
    `<i>Q</i>(<i>s</i>)&nbsp;+&nbsp;bias(<i>s</i>), both times <span class="rl-whole">100 / <i>Q</i><sub>max</sub> = ${given(scale)}</span>, ` +
    `at <i>T</i>&nbsp;=&nbsp;${given(temperature)}.`;
}
