// All that there is to see at the position of a tape: environment, choice, update, Q and traces, in HTML.

const REWARDS = 10; // the latest ones
const GIVEN = ["α", "γ", "(1 − α)", "1", "r"]; // numbers that somebody set; all others are computed

const named = ({ actions }, a) => (actions[a] === String(a) ? `${a}` : `${a} (${actions[a]})`);
const pane = (kind, heading, content, note = "") =>
  `<section class="${kind}"><h2>${heading}</h2>${content}${note && `<p class="note">${note}</p>`}</section>`;

// Whether an action follows the step shown, and the update takes its value.
const takesNext = ({ equation }, frame) => frame && !over(frame) && equation.join("").includes("{Q(s′, a′)}");

// The step in one sentence, with a′ if the update learns from it.
function stepInWords(about, frame) {
  if (!frame) return "Before the first step.";
  const { s, a, r, s2, a2, t, episode, n } = frame, { names } = about;
  const text = `Step ${t + 1} (episode ${episode}, its step ${n}): in state s = ${s} the agent took action ` +
    `a = ${named(names, a)} and got r = ${given(r)}; now it is in s′ = ${s2}`;
  if (frame.terminated) return `${text}, where the episode ends.`;
  if (frame.truncated) return `${text}; the time of this episode is up.`;
  return takesNext(about, frame)
    ? `${text}, where it will take a′ = ${named(names, a2)}.` : `${text}.`;
}

// The same for a beginner: what the robot did, what that paid, and whether it now thinks better of it.
function simply({ names, view, nActions }, frame) {
  if (!frame) return "";
  const { a, r } = frame, paid = r < 0 ? `cost ${given(-r)}` : r > 0 ? `earned ${given(r)}` : "brought nothing";
  return `${names.told[a]}${bumped(view, frame) ? " and bumped" : ""}. That ${paid}${learned(names, nActions, frame)}`;
}

// An action in a sentence.
const quoted = ({ actions }, a) => (actions[a] === String(a) ? `action ${a}` : `“${actions[a]}”`);

// The value of what it did before and after the update.
function valuesOf(nActions, { s, a, q, old, qsa }) {
  const at = q[0].indexOf(s * nActions + a);
  return at < 0 ? [qsa, qsa] : [old[at], q[1][at]];
}

// How the update has changed the value of what it did; a value that goes against the reward is news.
function learned(names, nActions, frame) {
  const [was, now] = valuesOf(nActions, frame), written = writerFor(was, now), what = `${quoted(names, frame.a)} here`;
  if (was === now) return `. It thinks of ${what} as before.`;
  return `${frame.r * (now - was) < 0 ? ", yet" : ", and"} it now thinks ${now > was ? "better" : "worse"} of ${what}: ` +
    `${written(was)} → ${written(now)}.`;
}

// Why: what the step was worth, beside what was expected of it; empty for an update whose target is not known.
function why({ equation, parameters, nActions }, frame) {
  if (!frame || !equation.join("").includes("s′")) return "";
  const { r, qsa, qNext, delta, terminated } = frame, next = terminated ? 0 : parameters.gamma * qNext, worth = r + next;
  const [was, now] = valuesOf(nActions, frame), written = writerFor(worth, qsa), product = `${given(parameters.gamma)}·${number(qNext)}`;
  const comes = terminated ? "nothing comes next" : `what comes next is worth ${next ? `${number(next)} (${product})` : "0"}`;
  const than = delta > 0 ? "more than" : delta < 0 ? "less than" : "just";
  const told = `Why: the step paid ${given(r)} and ${comes}. Together that is ${written(worth)}, ${than} the ${written(qsa)} expected.`;
  if (was === now || delta * (now - was) > 0) return told;
  return `${told} The value ${now > was ? "rises" : "falls"} all the same: the update also carries on what the step before changed.`;
}

const percent = (x) => `${general(100 * x, 3)} %`;

// The choice as a sentence: the chance of the action, and whether another had more.
function chosen({ names }, { a, p }) {
  const best = p.indexOf(Math.max(...p)), likelier = p.filter((x) => x > p[a]).length;
  const name = (b) => `“${escaped(names.actions[b])}”`;
  if (!likelier) return `${name(a)} had a chance of ${percent(p[a])}; no action had more`;
  return `${name(a)} had a chance of ${percent(p[a])}; ${name(best)} had more, ${percent(p[best])}`;
}

function viewHtml(always, tape) {
  const { frame } = tape, about = aboutAt(always, frame), { names, nStates } = about, shown = windowOf(tape), most = largest(tape.q, about.rMax);
  const plainly = `<b class="simply">${escaped(frame ? simply(about, frame) : "Before the first step.")}</b>`;
  const reason = why(about, frame), because = reason && `<p class="why">${escaped(reason)}</p>`;
  const said = `<div class="said"><span>${escaped(stepInWords(about, frame))}</span></div>`;
  const begins = frame && frame.n === 1, ends = frame && over(frame);
  const badge = (begins ? '<span class="badge">episode begins</span>' : "") +
    (ends ? '<span class="badge">episode ends</span>' : "");
  const columns = names.outputs ? `Columns: actions (${escaped(names.outputs)}). ` : "Columns: actions. ";
  const world = pane("world", about.view.heading, worldHtml(about, tape, most) + rewards(tape, most));
  const heat = frame && about.isSoftmax ? `, temperature T = ${given(frame.temperature)}` +
    (frame.temperature > about.parameters.temperature ? " (loop evasion)" : "") : "";
  const choice = pane("choice", "What it has learned here, <i>Q</i>, and how it chose", choiceHtml(about, tape, shown),
    frame && `In state ${frame.s}${heat}, ${chosen(about, frame)}.`);
  const update = pane("update", "The update with this step’s numbers", updateHtml(about, frame, most));
  const q = folded(about, "all", `All ${nStates} states: ${othersChanged(frame)}`, pane("q", `Q: ${shown.says}`,
    qHtml(about, tape, shown, follows(about, tape)), `${columns}${scaleHtml(most)} · never tried. Framed: changed by this step, ` +
    "▲ up, ▼ down, old → new, or by how much where both look the same; double frame: (s, a)."));
  const traces = about.hasTraces
    ? folded(about, "traces", "Traces e, as this update used them: how much each pair shares in what is learned in this step",
      `<section class="traces">${tracesHtml(about, tape, shown)}</section>`)
    : `<p class=note>${escaped(about.algorithm)} keeps no traces: only Q(s, a) changes.</p>`;
  // what happened and where come first; then what it knew, the reason, the equation and the tables
  const right = `${choice}${because}${update}${said}${q}${traces}`;
  return `<div class="did">${plainly} ${badge}</div><div class="panes">` +
    `<div class="left">${world}</div><div class="right">${right}</div></div>`;
}

// What a reader unfolds, and finds unfolded at the next step.
function folded({ open = {} }, name, summary, content) {
  return `<details class="${name}" data-kept="${name}"${open[name] ? " open" : ""}><summary>${summary}</summary>${content}</details>`;
}

// How many values the step changed beside that of what it did.
function othersChanged(frame) {
  const n = frame ? frame.q[0].length - 1 : 0;
  return n > 0 ? `${n} other value${n > 1 ? "s" : ""} changed, too` : "no other value changed";
}

// The pairs whose value the update took for what follows: (s′, a′), the best one, or all of s′.
function follows({ equation }, { frame, nActions }) {
  if (!frame || frame.terminated) return [];
  const text = equation.join("");
  if (text.includes("{Q(s′, a′)}")) return [[frame.s2, frame.a2]];
  return (text.includes("max") ? [frame.best] : count(nActions)).map((a) => [frame.s2, a]);
}

// A line of the latest rewards, the present one last; a bar where an episode begins.
function rewards(tape, most) {
  const chip = ({ n, r }) => `${n === 1 ? "<i>|</i>" : ""}<b style="background:${tint(r, most)}">${given(r)}</b>`;
  const chips = tape.latest(REWARDS).map(chip).join("");
  return `<p class="rewards" title="The latest rewards; | an episode begins">latest rewards: ${chips}</p>`;
}

// Each action, the chosen one marked: its chance, with a biased selection its bias, and its value where the robot was
// and where it is now.
function choiceHtml(about, tape, { actions }) {
  const { names, isBiased } = about, { frame } = tape, states = frame ? [...new Set([frame.s, frame.s2])] : [];
  const value = qCells(about, tape, follows(about, tape));
  const place = (s) => (s !== frame.s ? "where it is now" : frame.s === frame.s2 ? "where it was and is" : "where it was");
  const heads = states.map((s) => `<th title="${escaped(stateInWords(names, s))}">state ${s},<br>${place(s)}</th>`).join("");
  const row = (a) => {
    const p = frame ? frame.p[a] : 0, chosen = frame && a === frame.a;
    const bias = isBiased ? `<td${frame ? ` data-bias="${a}">${number(frame.bias[a])}` : ">"}</td>` : "";
    return `<tr${chosen ? " class=on" : ""}><th>${chosen ? "▶ " : ""}${escaped(names.rows[a])}</th>` +
      `<td class="bar"><b style="width:${(100 * p).toFixed(1)}%"></b></td><td>${frame ? percent(p) : ""}</td>${bias}` +
      `${states.map((s) => value(s, a)).join("")}</tr>`;
  };
  const rest = frame && actions.length < frame.p.length ? 1 - actions.reduce((sum, a) => sum + frame.p[a], 0) : null;
  const note = rest === null ? "" : `<p class="note">all other actions together: ${percent(Math.max(0, rest))}</p>`;
  return `<table><tr><th>action</th><th colspan=2>chance</th>${isBiased ? "<th>bias</th>" : ""}${heads}</tr>` +
    `${actions.map(row).join("")}</table>${note}`;
}

// The equations of a step, each a list of terms: a symbol, the number below it, and its exact value; and a note.
function explained(about, frame) {
  const { alpha, gamma, lam } = about.parameters, { qsa, delta, r, e, qOld } = frame;
  const after = frame.q[1][frame.q[0].indexOf(frame.s * about.nActions + frame.a)] ?? qsa, lines = [];
  const write = writerFor(qsa, after);
  const numbers = { "α": alpha, "(1 − α)": 1 - alpha, "γ": gamma, 1: 1, r, "δ": delta, "Q(s, a)": qsa, "e(s, a)": e,
    Q_old: qOld, change: after - qsa };
  const results = { "δ": delta, "Q(s, a)": after, "e(s, a)": frame.traces[1].at(-1) };
  const change = alpha * (about.trace === "dutch" ? delta + qsa - qOld : delta);
  const ofQ = (symbol) => (symbol === "Q(s, a)" ? write : number);
  const usual = !about.trace ? "" : `Every other pair with a trace changes by ${number(change)}·e. ` +
    `Then all traces fade to ${general(gamma * lam, 3)}·e.`;
  for (const line of about.equation) {
    const [, left, sign, right] = /^(.*?) ([←=]) (.*)$/.exec(line);
    const terms = right.split(/(\{[^}]*\})/).flatMap((piece) => {
      if (!piece.startsWith("{")) return [...piece.replaceAll(" ", "")].map((each) => ({ symbol: each, text: each }));
      const symbol = piece.slice(1, -1), value = symbol.includes("s′") ? frame.qNext : numbers[symbol];
      return [{ symbol, value, text: GIVEN.includes(symbol) ? given(value) : value < 0 ? `(${ofQ(symbol)(value)})` : ofQ(symbol)(value) }];
    });
    const result = terms.length > 1
      ? [{ symbol: "", text: "=" }, { symbol: "", text: ofQ(left)(results[left]), value: results[left] }] : [];
    const leftSide = { symbol: left, text: left.replace("(s, a)", `(${frame.s}, ${frame.a})`) };
    lines.push([leftSide, { symbol: sign, text: sign }, ...terms, ...result]);
    numbers[left] = results[left]; // what a line has set, the next one takes
  }
  if (frame.terminated) return { lines, note: `Terminal: nothing follows s′, so its value counts as 0. ${usual}` };
  if (frame.truncated) return { lines, note: `Time is up, but the world would go on: the value of s′ counts. ${usual}` };
  return { lines, note: usual };
}

const asText = (line) => line.map(({ text }) => ("+−←=".includes(text) ? ` ${text} ` : text)).join("").trim();

// The terms of a line in groups that stay on one line of the page: each begins with a sign outside of all brackets.
// What comes out stays beside the last of them.
function summands(line) {
  let depth = 0;
  const groups = [[]];
  for (const term of line) {
    if (depth === 0 && term.symbol && "+−←=".includes(term.text) && groups.at(-1).length) groups.push([]);
    groups.at(-1).push(term);
    depth += (term.text === "(") - (term.text === ")");
  }
  return groups;
}

function updateHtml(about, frame, most) {
  if (!frame) return '<p class="note">Press Step: the agent acts, and learns from what happens.</p>';
  const { lines, note } = explained(about, frame);
  const drawn = lines.map((line) => {
    const terms = summands(line).map((piece) => `<nobr>${piece.map((term) => termHtml(term, most)).join("")}</nobr>`);
    return `<div class="line" role="math" aria-label="${escaped(asText(line))}">${terms.join("")}</div>`;
  });
  const error = lines.length === 1 ? `TD error δ = ${number(frame.delta)}. ` : "";
  return `${drawn.join("")}<p class="note">${error}${escaped(note)}</p>`;
}

// A symbol above its number in the colour of its cell, the exact value for the mouse; it knows where it points.
function termHtml({ symbol, text, value }, most) {
  const pointsAt = symbol.includes("s′") ? "next"
    : { "Q(s, a)": "pair", "e(s, a)": "trace", r: "reward" }[symbol] ?? "";
  const kind = "+−←=".includes(text) ? "sign" : pointsAt && `to-${pointsAt}`;
  let told = kind ? ` class="${kind}"` : "";
  if (value !== undefined) {
    told += ` title="${value}"`;
    if (pointsAt) told += ` style="background:${pointsAt === "trace" ? traceTint(value) : tint(value, most)}"`;
  }
  const name = escaped(symbol).replace("Q_old", "Q<sub>old</sub>");
  return `<span${told}><i>${name}</i><b>${escaped(text)}</b></span>`;
}
