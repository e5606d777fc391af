// The states of a task as buttons; where they are places of a robot, as a room.

// Whether the states are places and headings of a robot, which can be drawn.
const isRoom = ({ inputs }) => /^X,Y,(θ|theta),d$/.test(inputs.map(({ name }) => name).join());

// The robot in a state, from above: its heading, and a bar where something is right ahead.
function robotSvg({ bins }, inputs) {
  const [heading, ahead] = bins.slice(-2).map((bin, i) => parseInt(inputs.at(i - 2).values[bin].replace("−", "-"), 10));
  const bar = ahead ? '<path class="rl-ahead" d="M33-24V24"/>' : "";
  return `<svg class="rl-robot" viewBox="-40 -40 80 80" aria-hidden="true"><g transform="rotate(${-heading})">${bar}` +
    '<circle r="23"/><path class="rl-nose" d="M18 0 3-12V12Z"/></g></svg>';
}

// Every state as a button. Those that differ in their last two inputs alone are a block: a column for each value of the
// last but one, a row for each of the last. Blocks stand as on a map: inputs 0, 2, … go across, 1, 3, … up.
function statesHtml({ shape, inputs, states }) {
  const outer = shape.slice(0, -2), columns = shape.at(-2) ?? 1, rows = shape.at(-1), blocks = [];
  const place = (bins, first) => outer.reduce((n, size, i) => (i % 2 === first ? n * size + bins[i] : n), 0);
  const [top, last] = [inputs.at(-2), inputs.at(-1)];
  for (let first = 0; first < states.length; first += columns * rows) {
    const { bins } = states[first], row = (j) => Array.from({ length: columns }, (_, i) => button(first + i * rows + j));
    const button = (s) => `<td><button value="${s}" title="state ${s}: ${escaped(states[s].words)}"></button></td>`;
    const heads = top ? top.values.map((value, i) => `<th>${escaped(i ? value : `${top.name} ${value}`)}</th>`).join("") : "";
    const body = last.values.map((value, j) => `<tr><th>${escaped(`${last.name} ${value}`)}</th>${row(j).join("")}</tr>`);
    const common = outer.map((_, i) => `${inputs[i].name} = ${inputs[i].values[bins[i]]}`).join(", ");
    blocks.push({ across: place(bins, 0), up: place(bins, 1), html: `<b>${escaped(common)}</b><table>` +
      `<tr><td></td>${heads}</tr>${body.join("")}</table>` });
  }
  const highest = Math.max(...blocks.map(({ up }) => up));
  return blocks.map(({ across, up, html }) => `<div style="grid-area:${highest - up + 1}/${across + 1}">${html}</div>`).join("");
}

// What stands on the button of state k; input: in which it differs, null in the state itself, undefined if it has no say.
// The state itself, which is in every set, has a word in place of all marks.
function showState(button, about, k, input) {
  button.innerHTML = (isRoom(about) ? robotSvg(about.states[k], about.inputs) : "") + k +
    (input === undefined ? "" : `<span>${input === null ? "here" : marksHtml(about, input)}</span>`);
  button.setAttribute("aria-pressed", input === null);
  button.className = input === undefined ? "rl-silent" : "";
  button.style.setProperty("--own", about.inputs[input]?.colour ?? "");
}
