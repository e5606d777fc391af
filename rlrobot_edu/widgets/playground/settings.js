// What can be set: task, method, sliders, luck and speed; and the link that holds it all.

// Steps in a sixtieth of a second, and what they are called.
const SPEEDS = [[0.1, "slow: 6 steps a second"], [0.5, "watch: 30 a second"], [1, "60 a second"], [10, "600 a second"],
  [100, "6,000 a second"], [1000, "60,000 a second"], [10000, "as fast as it can"]];
const VALUES = {
  alpha: { label: "α, learning rate", values: [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1], of: () => true },
  gamma: { label: "γ, discount", values: [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99], of: () => true },
  lam: { label: "λ, length of traces", values: [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 1], of: (m) => /^(SL|TOSL)/.test(m) },
  temperature: { label: "T, temperature", values: [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50], of: (m) => /SR$/.test(m) },
  epsilon: { label: "ε, share of chance", values: [0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1], of: (m) => /EG$/.test(m) },
};
const RIVALS = [["Q+RANDOM", "chance"], ["Q+EG", "Q-learning"], ["TOSL+SR", "the paper’s method without its bias"],
  ["TOSL+QBIASSR", "the paper’s method"]];
const called = (method) => RIVALS.find(([name]) => name === method)[1];

const settings = { ...beginning, luck: 0, speed: 0.5, ...about.parameters };
let walls = null; // inside the room, where they are others than those of the task

// All settings, as the end of an address.
function link() {
  const parts = Object.entries(settings).map(([name, value]) => `${name}=${encodeURIComponent(value)}`);
  if (walls) parts.push(`walls=${walls.map(String).join(";") || "none"}`);
  return `#${parts.join("&")}`;
}

function keepLink() {
  find("link").href = link();
  try {
    history.replaceState(null, "", link());
  } catch { /* a page within a page may not */ }
}

async function copyLink() {
  let copied = true;
  try {
    await navigator.clipboard.writeText(location.href);
  } catch { // it is not allowed here: as it was done of old
    const text = document.body.appendChild(Object.assign(document.createElement("textarea"), { value: location.href }));
    text.select();
    copied = document.execCommand("copy");
    text.remove();
  }
  find("copy").textContent = copied ? "Copied" : "Copy it from the address bar";
  say(copied ? "The link is copied. It holds all settings and walls." : "The link could not be copied.");
  setTimeout(() => { find("copy").textContent = "Copy link"; }, 2500);
}

function readLink() {
  const given = new URLSearchParams(location.hash.slice(1));
  for (const [name, value] of given) {
    const x = Number(value);
    if (name in VALUES && VALUES[name].values.includes(x)) settings[name] = x;
    else if (name === "luck" && about.lucks[x]) settings.luck = x;
    else if (name === "speed" && SPEEDS.some(([speed]) => speed === x)) settings.speed = x;
    else if (name === "method" && about.methods.some((method) => method.name === value)) settings.method = value;
    else if (name === "task" && Object.hasOwn(about.worlds, value)) settings.task = value;
  }
  walls = wallsFrom(given.get("walls"), newSimulation({ ...settings }).world);
}

// The choices of a setting, in the list of its name.
function options(name, entries) {
  const select = find(name);
  select.replaceChildren(...entries.map(([value, text]) => new Option(text, value, false, value === settings[name])));
  select.onchange = () => {
    const was = settings[name];
    settings[name] = typeof was === "number" ? Number(select.value) : select.value;
    if (name === "task") walls = null;
    if (name === "speed") keepLink();
    else change(name, was);
    sliders();
  };
}

// The sliders that the method listens to.
function sliders() {
  find("sliders").replaceChildren(...Object.entries(VALUES).filter(([, { of }]) => of(settings.method)).map(
    ([name, { label, values }]) => {
      const line = document.createElement("label"), value = document.createElement("span");
      const input = Object.assign(document.createElement("input"), {
        type: "range", min: 0, max: values.length - 1, value: values.indexOf(settings[name]), name,
      });
      const show = () => {
        value.textContent = values[input.value];
        input.setAttribute("aria-valuetext", values[input.value]);
      };
      input.oninput = show;
      input.onchange = () => {
        const was = settings[name];
        settings[name] = values[input.value];
        change(label.split(",")[0], was);
      };
      show();
      line.append(label, value, input);
      return line;
    },
  ));
}

// Who can be raced against: all but the method that the robot has itself.
function showRivals() {
  const rivals = RIVALS.filter(([name]) => name !== settings.method);
  const option = ([name, text]) => new Option(text, name, false, name === racing);
  find("race").replaceChildren(...[["", "nobody"], ...rivals].map(option));
}

function showSettings() {
  options("task", Object.entries(about.worlds).map(([name, { called }]) => [name, called]));
  options("method", about.methods.map(({ name, called }) => [name, called]));
  options("speed", SPEEDS);
  options("luck", about.lucks.map((_, i) => [i, `seed ${i}`]));
  sliders();
  const isAtHome = location.protocol !== "about:"; // within a notebook there is no address
  find("copy").hidden = !isAtHome;
  find("link").hidden = !isAtHome || !isFramed;
  find("copy").onclick = copyLink;
}
