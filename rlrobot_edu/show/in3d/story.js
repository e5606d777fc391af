// What became of the film's steps, as the title of the page; below it what the colours mean; and moments on the slider.
const LIVE_KEY = [["green", "earned"], ["red", "lost much"], ["grey", "earned nothing or lost little"]];
const SIGNS = {reached: "★", "longest stay": "★", bump: "✕", loss: "✕"};
const ROOM_FOR_A_WORD = 0.3;  // of the slider
let story = {headline: "", key: [], aim: "", moments: []};

// element("b", {title: "…"}, child, …)
function element(kind, properties, ...children) {
  const made = Object.assign(document.createElement(kind), properties);
  made.append(...children);
  return made;
}

function tell(told) {
  story = told;
  title(told.headline);
  keyOf(told.key, told.aim);
}

function title(text) {
  finding.textContent = text || "A robot in 3D";
  finding.className = text ? "" : "unsaid";
}

// Without a film: how it fares now
function tellLive(mean, n) {
  if (!count) return tell({headline: "", key: [], aim: "", moments: []});
  title(`Live: mean reward ${signed(mean, 2)} over its last ${n} step${n === 1 ? "" : "s"}`);
  keyOf(LIVE_KEY, "");
}

function keyOf(items, aim) {
  key.hidden = !items.length && !aim;
  const words = items.map(([colour, word]) => {
    const line = element("i", {style: `background: var(--${colour})`});
    const unbroken = word.replace(/: (?=[−\d])/, ":\u00a0").replace(/(\d) m\b/g, "$1\u00a0m");
    return element("span", {}, line, ` ${unbroken}`);
  });
  key.replaceChildren(...(words.length ? ["Rewards on its way: ", ...words] : []), aim);
}

// A sign for each moment, and its word where there is room: first what was reached, then the first of the losses
function markMoments() {
  const place = step => step / last, worded = [];
  const isReached = word => SIGNS[word] === "★";
  const order = [...story.moments].sort(([, a], [, b]) => isReached(b) - isReached(a));
  marks.replaceChildren(...order.map(([step, word]) => {
    const at = place(step), isFree = worded.every(other => Math.abs(other - at) > ROOM_FOR_A_WORD);
    const text = isFree ? `${SIGNS[word]} ${word}` : SIGNS[word];
    if (isFree) worded.push(at);
    const mark = element("span", {title: `step ${step + 1 + before()}: ${word}`, onclick: () => go(step + 1 + before())}, text);
    mark.className = isReached(word) ? "reached" : "lost";
    mark.style.left = `${100 * at}%`;
    if (at > 0.6) mark.classList.add("toLeft");
    return mark;
  }));
}

// What happened at a scene of the film, from 0; empty if nothing did
function momentAt(i) {
  const words = story.moments.filter(([step]) => step === i).map(([, word]) => word);
  return words.join(" · ");
}
