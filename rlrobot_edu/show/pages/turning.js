// Shows one view at a time of those that Python drew: buttons, slider, keys, play, and a link to each: #31.
const [view, live, where, slider, play, speed, packed] =
  ["view", "live", "where", "slider", "play", "speed", "packed"].map(id => document.getElementById(id));
const first = +slider.min, last = +slider.max;
const keys = {ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last"};
const moves = {first: () => first, back: () => at - 1, step: () => at + 1, last: () => last};
let views, at, player, rest;

async function unpack() {
  const bytes = Uint8Array.from(atob(packed.textContent), sign => sign.charCodeAt());
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const [style, columns] = JSON.parse(await new Response(stream).text());
  document.head.insertAdjacentHTML("beforeend", style);
  for (const column of columns) column.forEach((piece, i) => { column[i] = piece ?? column[i - 1]; });
  return columns[0].map((_, i) => columns.map(column => column[i]).join(""));
}

function show(number) {
  at = Math.min(Math.max(number, first), last);
  view.innerHTML = views[at - first];
  slider.value = at;
  where.textContent = `step ${at} of ${last}`;
  clearTimeout(rest);
  rest = setTimeout(() => {  // where it stands still: nobody can listen faster, and browsers count how often a link is set
    live.textContent = view.querySelector(".said span").textContent;
    history.replaceState(null, "", "#" + at);
  }, 500);
}

function stop() {
  player = clearInterval(player);
  play.textContent = "▶▶ Play";
}

function start() {
  if (at === last) show(first);
  play.textContent = "‖ Pause";
  player = setInterval(() => { show(at + 1); if (at === last) stop(); }, 1000 / speed.value);
}

function press(name) {
  const played = player;
  stop();
  if (name in moves) show(moves[name]());
  else if (!played) start();
}

function follow() {
  const [, number] = /^#(\d+)$/.exec(location.hash) ?? [];
  show(+(number ?? at ?? slider.defaultValue));
}

function listen() {
  for (const button of document.querySelectorAll("#bar button")) button.onclick = () => press(button.name);
  slider.oninput = () => { stop(); show(+slider.value); };
  speed.onchange = () => { if (player) { stop(); start(); } };
  onhashchange = () => { stop(); follow(); };
  document.onkeydown = event => {
    const name = keys[event.key], ownKeys = event.key === " " ? "button, select" : "select";
    if (!name || event.ctrlKey || event.altKey || event.metaKey || event.target.closest(ownKeys)) return;
    event.preventDefault();
    press(name);
  };
}

unpack().then(all => { views = all; listen(); follow(); }, () => {
  view.textContent = "This page cannot be unpacked: the browser is older than 2023, or the file is damaged.";
});
