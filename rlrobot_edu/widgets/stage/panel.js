// What is told and can be pressed beside the picture: numbers, a sentence, the motions, who advises, and the link.

const MARKS = ["●", "▲", "■", "◆", "★"];
const SIDE = { bump: "red", paid: "green", idle: "" };
let told = "", scored = "";

const inputName = (i) => lives[1].world.words[i][0].replace("laser ", "").replace("front", "ahead");
// A chance in words; blanks in it do not break.
function percent(x) {
  if (x < 0.005) return "<\u00a01\u00a0%";
  return `${x > 0.9945 ? Math.min(99.9, 100 * x).toFixed(1) : Math.round(100 * x)}\u00a0%`;
}
const minus = (text) => text.replace("-", "−");
const numberText = (x) => minus(String(+x.toFixed(2)));
const sayText = (x) => (Math.abs(x) < 0.005 ? "0" : `${x > 0 ? "+" : ""}${minus(x.toFixed(2))}`);
const capital = (text) => text[0].toUpperCase() + text.slice(1);

function element(kind, properties, ...children) {
  const { dataset, ...rest } = properties, made = Object.assign(document.createElement(kind), rest);
  Object.assign(made.dataset, dataset);
  made.append(...children);
  return made;
}
const markOf = (input) => {
  const mark = element("span", { className: "mark", textContent: MARKS[input] });
  mark.style.background = `var(--input-${input + 1})`;
  mark.setAttribute("aria-hidden", "true");
  return mark;
};

function tell(html) {
  if (html === told) return;
  told = html;
  find("said").innerHTML = html;
}

function tellScores({ scores, size: zoom }, t) {
  const text = String([scores, zoom, t]);
  if (text === scored) return;
  scored = text;
  ["nobody", "neighbours"].forEach((id, i) => {
    const score = find(id), { metres } = lives[i];
    score.style.transform = `translate(${scores[i][0]}px, ${scores[i][1]}px)`;
    score.style.setProperty("--zoom", zoom);
    score.querySelector("b").textContent = Math.round(metres[t]);
  });
}

function fillPanel() {
  const chances = chancesNow();
  find("motions").replaceChildren(...motions.map((motion, i) => {
    const button = element("button", { onclick: () => { [chosen, layout] = [i, null]; refreshed("motions", i); } },
      element("span", { textContent: motion.sign, ariaHidden: "true" }), element("span", { textContent: motion.called }),
      element("span", { className: "bar" }, element("i", {}), element("u", {})), element("output", {}));
    button.setAttribute("aria-pressed", i === chosen);
    button.setAttribute("aria-label", `${motion.called}: ${percent(chanceOf(chances, motion))}; by lot ${percent(lotOf(motion))}`);
    button.querySelector("u").style.left = `${100 * lotOf(motion)}%`;
    return button;
  }));
  const all = moment.known.map((one, i) => {
    const say = sayNow(one), isMute = !speaks({ say }), words = `the laser ${inputName(one.input)} differs: ${sayText(say)}`;
    const button = element("button", {
      title: words, className: isMute && ghost !== i ? "mute" : "", onclick: () => { ghost = ghost === i ? -1 : i; refreshed("ghosts", i); },
    }, markOf(one.input), isMute && ghost !== i ? "" : sayText(say));
    button.setAttribute("aria-pressed", i === ghost);
    button.setAttribute("aria-label", words);
    return element("li", {}, button);
  });
  find("ghosts").replaceChildren(...all);
  const heard = moment.known.filter((one) => speaks({ say: sayNow(one) }));
  const lasers = [...new Set(heard.map(({ input }) => input))].sort();
  find("marks").replaceChildren("The laser that read another distance: ", ...lasers.map((i) => element("span", {}, markOf(i), inputName(i))));
  find("lead").textContent = all.length
    ? `Pale discs: itself, earlier, where all its lasers but one read the same. A number: how much that speaks for “${motions[chosen].called}”.`
    : "No similar state is known.";
  fillSlider();
  const advisers = moment.known.length;
  canvas.setAttribute("aria-label", `The right robot in its room, in minute ${Math.floor(moment.t / 60)}, in a state that is new to it. ` +
    `${advisers} of ${moment.similar.length} similar states are known. ${capital(motions[chosen].called)}: ${percent(chanceOf(chances, motions[chosen]))}.`);
}

// After something was chosen: the same again, with the keyboard where it was.
function refreshed(list, i) {
  layout = null;
  fillPanel();
  find(list).querySelectorAll("button")[i]?.focus();
  keepLink();
  wake();
}

function fillSlider() {
  const one = moment.known[ghost], motion = motions[chosen];
  find("what").hidden = !one;
  if (!one) return;
  const a = motion.actions[0], value = changed.get(`${one.state} ${chosen}`) ?? one.q[a];
  find("asked").replaceChildren(`What if “${motion.called}” had been worth `, element("b", { textContent: numberText(value) }),
    ` there? It remembers ${numberText(one.q[a])}.`);
  find("value").value = value;
}

// A memory that is another than it has: of the ghost that is chosen, for the motion that is chosen.
function remember(value) {
  changed.set(`${moment.known[ghost].state} ${chosen}`, value);
  layout = null;
  const chip = find("ghosts").querySelectorAll("button")[ghost];
  chip.className = "";
  chip.lastChild.textContent = sayText(sayNow(moment.known[ghost]));
  fillSlider();
  keepLink();
  wake();
}

// Bars and sentence, as they are s seconds after the camera came.
function tellMoment(s) {
  const chances = chancesNow(), part = eased((s - TIMES.arrow) / 0.8), motion = motions[chosen];
  [...find("motions").children].forEach((button, i) => {
    const share = mixed(lotOf(motions[i]), chanceOf(chances, motions[i]), part);
    button.querySelector("i").style.width = `${100 * share}%`;
    button.querySelector("output").textContent = percent(share);
  });
  tell(sentence(s, motion, `${percent(lotOf(motion))} → ${percent(chanceOf(chances, motion))}`));
}

// In large type what they say, at once; below it how that came.
function sentence(s, motion, rise) {
  const n = moment.known.length, heard = moment.known.filter((one) => speaks({ say: sayNow(one) })).length;
  if (changed.size) {
    const truth = percent(chanceOf(moment.chances, motion));
    return `<b>If it remembered that: ${motion.called}, ${rise}.</b> In truth it was ${truth}.`;
  }
  const finding = `<b>${adviceOn(motion, n, heard)}</b>`, chance = `Chance of “${motion.called}”: ${rise}.`;
  if (s < 0.9) return `${finding} It never read its lasers like this: its own table is empty.`;
  if (n && s < 2.3) return `${finding} ${n === 1 ? "Once" : `${capital(String(n))} times`} all its readings but <em>one</em> were the same; ${heard || "none"} taught it something.`;
  return stepPart(s) < 0.9 && !calm.matches ? `${finding} ${chance}` : `${finding} ${chance} ${drawn()}`;
}

// What memories say of a motion. n: how many it has; heard: how many of them say something
function adviceOn(motion, n, heard) {
  if (!n) return "It has no memory of a similar place: it draws lots.";
  if (!heard) return "Its memories of similar places know nothing of worth.";
  if (chanceOf(moment.chances, motion) < lotOf(motion)) return "Its memories of similar places speak more for other motions.";
  return `${heard === 1 ? "One memory of a similar place says" : `${heard} memories of similar places say`}: ${deedOf(motion)}.`;
}
const deedOf = ({ called }) => (called.startsWith("ahead") ? `drive ${called}` : called);

// Which step it took, and what that paid.
function drawn() {
  const a = lives[1].a[moment.t], taken = motions.find(({ actions }) => actions.includes(a)), r = lives[1].r[moment.t + 1], kind = kindOf(r);
  const paid = { bump: `a bump, ${numberText(r)}`, paid: `reward +${numberText(r)}`, idle: `reward ${numberText(r)}` }[kind];
  const favourite = favouriteOf(moment.chances, motions), isAdvised = favourite === motions[chosen] && moment.known.some((one) =>
    speaks({ say: sayNow(one) }));
  if (isAdvised && moment === least) {
    const [earned, usual] = [earnedFrom(lives[1], moment.t), usuallyEarned(lives[1])].map((x) => numberText(Math.round(x)));
    return `Its next ten steps <span class="red">earned ${earned}</span>; ten steps usually earn ${usual}.`;
  }
  const isWrong = isAdvised && moment.pays[favourite.actions[0]] <= BUMP, told = `<span class="${SIDE[kind]}">${paid}.</span>`;
  if (isWrong && taken === favourite) return `It did that: ${told} Its memories misled it.`;
  if (isWrong) return `That would bump. By chance it did “${taken.called}”: ${told}`;
  return `${taken === motions[chosen] ? "It did that" : `By chance it did “${taken.called}”`}: ${told}`;
}

// The link holds the moment, the motion, the ghost, what it is to remember, and the walls.
function linkNow() {
  const parts = [];
  if (moment && phase === "ask") {
    parts.push(`t=${moment.t}`, `motion=${chosen}`);
    if (ghost >= 0) parts.push(`ghost=${moment.known[ghost].state}`);
    if (changed.size) parts.push(`what=${[...changed].map(([key, value]) => `${key.replace(" ", ",")},${value}`).join(";")}`);
  }
  if (walls) parts.push(`walls=${walls.map(String).join(";") || "none"}`);
  return `#${parts.join("&")}`;
}

function keepLink() {
  try {
    history.replaceState(null, "", linkNow());
  } catch { /* a page within a page may not */ }
}

const linked = () => new URLSearchParams(location.hash.slice(1));

// Show what a link tells of a moment; what it tells wrongly does no harm.
function follow(link) {
  const wanted = momentsNow().find(({ t }) => t === Number(link.get("t")));
  if (!link.has("t") || !wanted) return false;
  ask(wanted, true);
  if (motions[link.get("motion")]) chosen = Number(link.get("motion"));
  ghost = link.has("ghost") ? moment.known.findIndex(({ state }) => state === Number(link.get("ghost"))) : -1;
  for (const told of (link.get("what") ?? "").split(";").filter(Boolean)) {
    const [state, i, value] = told.split(",").map(Number);
    const isKnown = moment.known.some((one) => one.state === state);
    if (isKnown && motions[i] && Math.abs(value) <= 100) changed.set(`${state} ${i}`, value);
  }
  layout = null;
  fillPanel();
  keepLink();
  return true;
}
