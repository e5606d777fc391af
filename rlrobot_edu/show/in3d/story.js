// What became of the film's steps, as the title of the page; below it what the colours mean; and moments on the slider.
const LIVE_KEY = [["green", "earned"], ["red", "lost much"], ["grey", "earned nothing or lost little"]];
const SIGNS = {reached: "★", "longest stay": "★", bump: "✕", loss: "✕"};
const ROOM_FOR_A_WORD = 0.3;  // of the slider, on a phone
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

// A sign and a word for each moment that has room: first what was reached, then losses. The strip below shows all.
function markMoments() {
  const place = step => step / last, taken = [];
  const isReached = word => SIGNS[word] === "★";
  const order = [...story.moments].sort(([, a], [, b]) => isReached(b) - isReached(a));
  const free = order.filter(([step]) => {
    const hasRoom = taken.every(other => Math.abs(other - place(step)) > ROOM_FOR_A_WORD);
    if (hasRoom) taken.push(place(step));
    return hasRoom;
  });
  marks.replaceChildren(...free.map(([step, word]) => {
    const number = step + 1 + before();
    const mark = element("span", {title: `step ${number}: ${word}`, onclick: () => go(number)}, `${SIGNS[word]} ${word}`);
    mark.className = isReached(word) ? "reached" : "lost";
    mark.style.left = `${100 * place(step)}%`;
    if (place(step) > 0.6) mark.classList.add("toLeft");
    return mark;
  }));
}

// What happened at a scene of the film, from 0; empty if nothing did
function momentAt(i) {
  const words = story.moments.filter(([step]) => step === i).map(([, word]) => word);
  return words.join(" · ");
}
