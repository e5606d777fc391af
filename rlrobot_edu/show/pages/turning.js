// Shows one view at a time of those that Python drew: buttons, slider, keys, play, and a link to each: #31, or #7-2 where view 7 is shown of the second of several tables.
const [view, live, where, slider, play, speed, table, packed] =
  ["view", "live", "where", "slider", "play", "speed", "table", "packed"].map(id => document.getElementById(id));
const first = +slider.min, last = +slider.max;
const keys = {ArrowLeft: "back", ArrowRight: "step", " ": "play", Home: "first", End: "last"};
const moves = {first: () => first, back: () => at - 1, step: () => at + 1, last: () => last};
let views, at, player, rest;

async function unpack() {
  const bytes = Uint8Array.from(atob(packed.textContent), sign => sign.charCodeAt());
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const [style, below, columns] = JSON.parse(await new Response(stream).text());
  document.head.insertAdjacentHTML("beforeend", style);
  document.getElementById("below").innerHTML = below;
  for (const column of columns) column.forEach((piece, i) => { column[i] = piece ?? column[i - 1]; });
  return columns[0].map((_, i) => columns.map(column => column[i]).join(""));
}

function show(number) {
  const hasFocus = view.contains(document.activeElement);
  at = Math.min(Math.max(number, first), last);
  view.innerHTML = views[table.selectedIndex * (last - first + 1) + at - first];
  if (hasFocus) view.querySelector(`button[value="${at}"]`)?.focus();  // the old button is gone
  reach();
  slider.value = at;
  where.textContent = `${slider.ariaLabel} ${at} of ${last}`;
  clearTimeout(rest);
  rest = setTimeout(() => {  // where it stands still: nobody can listen faster, and browsers count how often a link is set
    live.textContent = view.querySelector(".said span").textContent;
    history.replaceState(null, "", "#" + at + (table.length > 1 ? "-" + (table.selectedIndex + 1) : ""));
  }, 500);
}

function reach() {  // what is wider than the page can be scrolled by keys, too
  for (const box of view.querySelectorAll("[role=region]")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
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
  const [, number, nth] = /^#(\d+)(?:-(\d+))?$/.exec(location.hash) ?? [];
  if (nth) table.selectedIndex = Math.min(Math.max(nth, 1), table.length) - 1;
  show(+(number ?? at ?? slider.defaultValue));
}

function listen() {
  for (const button of document.querySelectorAll("#bar button")) button.onclick = () => press(button.name);
  view.onclick = ({target}) => { const button = target.closest("button[value]"); if (button) { stop(); show(+button.value); } };
  slider.oninput = () => { stop(); show(+slider.value); };
  table.onchange = () => show(at);
  speed.onchange = () => { if (player) { stop(); start(); } };
  onhashchange = () => { stop(); follow(); };
  onresize = reach;
  document.onkeydown = event => {
    const name = keys[event.key], ownKeys = event.key === " " ? "button, summary, select" : "select, [tabindex]";
    if (!name || event.ctrlKey || event.altKey || event.metaKey || event.target.closest(ownKeys)) return;
    event.preventDefault();
    press(name);
  };
}

unpack().then(all => { views = all; listen(); follow(); }, () => {
  view.textContent = "This page cannot be unpacked: the browser is older than 2023, or the file is damaged.";
});
