// The page: the time that passes, and what is told of it.

const find = (id) => document.getElementById(id);
const [picture, curveCanvas, spoken] = ["picture", "curve", "spoken"].map(find);
const MOST_MS = 12; // of learning in a frame, so that the picture stays smooth
const LEAP_MS = 30; // the same, on the way to a stage
const FRAMES = 60; // a second, for which the speeds are set
const TELL_MS = 200, FLOOR_MS = 600; // between two times that words and numbers, or the floor, are renewed
const capital = (text) => text[0].toUpperCase() + text.slice(1);
const say = (text) => { spoken.textContent = text; };

let colours = coloursOf(picture), yours, rival = null, before = null, racing = ""; // racing: the method of the rival
let playing = true, owed = 0, leap = null, view = null, drawnAt = 0, told = 0, painted = 0;
let since = { moment: 0, t: 0 }, rate = 0; // steps a second, counted anew twice a second
const runs = () => (rival ? [yours, rival] : [yours]);

// Begin a simulation with the present settings; in a race another, with another method.
function begin() {
  yours = new Run(settings, walls);
  if (racing === settings.method) racing = "";
  rival = racing ? new Run({ ...settings, method: racing }, walls) : null;
  for (const run of runs()) run.ground = document.createElement("canvas");
  [owed, leap, since] = [0, null, { moment: performance.now(), t: 0 }];
  chosen = NOTHING;
  shape();
  live(1, MOST_MS);
  changed();
}

// What the page looks like for this task, before anything has been learned.
function shape() {
  const { bounds, drawn, story, rule, score, ages, stepTime, commands } = yours.world;
  const [wide, high] = bounds
    ? [bounds[2] - bounds[0], bounds[3] - bounds[1]]
    : [0, 1].map((axis) => 1 + Math.max(...drawn.map(({ cell }) => cell[axis])));
  find("robots").style.setProperty("--shape", wide / high);
  find("robots").classList.toggle("wide", wide > 2 * high);
  for (const id of ["marks", "handling"]) find(id).hidden = !bounds;
  find("theirs").hidden = !rival;
  find("theirs").querySelector("figcaption").textContent = rival ? capital(called(racing)) : "";
  find("yours").querySelector("figcaption").hidden = !rival;
  find("story").textContent = story;
  find("rule").textContent = rule;
  showRivals();
  find("called").textContent = commands ? "wheels, as the paper writes them [rad/s]" : "drawn as";
  const named = score.called, life = stepTime ? " of its life" : "";
  find("counted").textContent = `${capital(named)} in ${periodInWords()}${life}`;
  ages.forEach(([age, text], i) => Object.assign(find("stages").children[i], { value: age, textContent: text }));
  find("kind").options[0].textContent = named;
}

// Begin again, and live at once to the age at which it shows what was learned.
function liveAnew() {
  begin();
  live(yours.world.ages[1][0] - yours.simulation.t, Infinity);
  changed();
}

// Begin again after a change: what was learned until now stays as the curve before, with what has changed since.
function change(name, was) {
  if (yours.curve.steps) before = Object.assign(yours.curve, { called: was === undefined ? "" : `, with ${name} ${was}` });
  if (name === "task") before = null;
  liveAnew();
  keepLink();
  say("It has learned anew, with the same luck.");
}

// Live so many steps, or as many as this time allows [ms].
function live(n, most) {
  const begun = performance.now(), all = runs();
  let done = 0;
  while (done < n && (done % 20 || performance.now() - begun < most)) {
    for (const run of all) {
      if (n - done <= 1) run.from = run.here;
      run.step();
    }
    done += 1;
  }
  for (const run of all) run.forget();
}

// Go to a stage of its life, at once or nearly so; to a stage that has passed, from the beginning again.
function goTo(t) {
  if (yours.simulation.t > t) begin();
  leap = t;
  play(true);
}

function frame(moment) {
  const passed = Math.min(0.1, (moment - drawnAt) / 1000);
  drawnAt = moment;
  if (leap !== null) {
    live(leap - yours.simulation.t, LEAP_MS);
    if (yours.simulation.t >= leap) [leap, owed] = [null, 0];
  } else if (playing) {
    owed += settings.speed * FRAMES * passed;
    const whole = Math.floor(owed);
    if (whole >= 1) live(whole, MOST_MS);
    owed -= whole;
  }
  draw(settings.speed < 1 && playing && leap === null ? owed : 1);
  requestAnimationFrame(frame);
}

// Something on the page has changed: it is told with the next frame.
function changed() {
  told = painted = -Infinity;
}

// Draw all; part: of the last step that is over, where time is slow.
function draw(part) {
  const isTime = performance.now() - told >= TELL_MS, isOld = performance.now() - painted >= FLOOR_MS;
  if (isOld) painted = performance.now();
  const look = { isChosen: chosen === ROBOT, isSlow: settings.speed < 1 && leap === null };
  for (const run of runs()) {
    const figure = find(run === yours ? "yours" : "theirs"), canvas = figure.querySelector("canvas");
    if (run.floor) {
      if (isOld) drawFloor(canvas, run, markedWall(run.world), colours);
      const seen = drawRobot(canvas, run, between(run, part), look, colours);
      if (run === yours) view = seen;
    } else {
      const seen = drawCells(canvas, run.world, run.here, (place) => bestArrow(run, place), colours);
      if (run === yours) view = seen;
    }
  }
  if (!isTime) return;
  told = performance.now();
  tell();
}

const markedWall = ({ walls: all }) => (chosen >= 0 ? all[all.length - inside().length + chosen] : null);

// Where to draw a robot: on its way from the step before.
function between({ here, from }, part) {
  if (!from || part >= 1 || Math.hypot(here[0] - from[0], here[1] - from[1]) > 0.5) return here;
  const turned = ((((here[2] - from[2]) % (2 * Math.PI)) + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  return [...[0, 1].map((i) => from[i] + part * (here[i] - from[i])), from[2] + part * turned];
}

function bestArrow({ simulation, world }, place) {
  const q = simulation.m.q[world.seen[place]];
  return q.every((value) => value === 0) ? "" : world.arrows[bestOf(q)];
}

// A number of steps as a time of its life, where a step has a length.
function timeOf(steps) {
  const { stepTime } = yours.world;
  if (!stepTime) return `${steps.toLocaleString("en")} steps`;
  const minutes = Math.floor((steps * stepTime) / 60), hours = Math.floor(minutes / 60);
  return [hours && `${hours.toLocaleString("en")} h`, (minutes % 60 || !hours) && `${minutes % 60} min`].filter(Boolean).join(" ");
}

const periodInWords = () => (yours.world.stepTime ? "ten minutes" : `${PERIOD} steps`);

// All that is said in words and numbers.
function tell() {
  const { simulation, world } = yours, passed = (performance.now() - since.moment) / 1000;
  if (passed > 0.5) {
    rate = (simulation.t - since.t) / passed;
    since = { moment: performance.now(), t: simulation.t };
  }
  const pace = playing && rate > 100 ? ` · ${Math.round(rate).toLocaleString("en")} steps a second` : "";
  const lived = world.stepTime ? `It has lived ${timeOf(simulation.t)}, in steps of a second. ` : "";
  find("age").textContent = `${lived}Step ${simulation.t.toLocaleString("en")}${pace}`;
  tellScore();
  tellCurve();
  const { s, a, r, sNext, delta, before: was, after } = simulation.last;
  find("update").textContent = `In state ${s} it did “${world.actions[a]}” and got r = ${String(r).replace("-", "−")}, in state ${sNext}. ` +
    `δ = ${number(delta)}, so Q(s, a) went from ${apart(was, after).join(" to ")}.`;
  showRow(pointed);
  find("turn").disabled = chosen === NOTHING;
  find("remove").disabled = chosen < 0;
  find("restore").disabled = walls === null;
}

// The score at first and now; and the stage of its life.
function tellScore() {
  const { score, simulation } = yours, isYoung = simulation.t < PERIOD, period = periodInWords();
  find("first").textContent = score.first;
  find("at-first").textContent = isYoung ? `so far, in ${timeOf(simulation.t)}` : `in its first ${period}`;
  find("last").textContent = isYoung ? "?" : score.last;
  find("at-last").textContent = isYoung ? "after some practice" : `in the last ${period}`;
  find("rival").hidden = !rival;
  if (rival) {
    find("rival").textContent =
      `The other robot, ${called(racing)}: ${rival.score.first} at first, ${isYoung ? "?" : rival.score.last} now.`;
  }
  const stages = [...find("stages").children], reached = stages.filter(({ value }) => Number(value) <= simulation.t).at(-1);
  for (const stage of stages) stage.toggleAttribute("aria-current", stage === reached);
}

function tellCurve() {
  const { curve, score: { first, last }, world } = yours, kind = find("kind").value, other = rival ? rival.curve : before;
  const n = Math.min(yours.simulation.t, PERIOD), period = periodInWords();
  const shown = kind === "counts" ? `${world.score.called} in the ${period} before` : `mean reward of the ${period} before`;
  const mean = `Mean reward of the last ${n} steps: ${number(yours.score.now.rewards)}.`;
  const dashed = rival ? ` Dashed: ${called(racing)}.` : before ? ` Dashed: the run before${before.called}.` : "";
  find("mean").textContent = mean + dashed;
  drawCurves(curveCanvas, kind, curve, other, [shown, timeOf], colours);
  curveCanvas.setAttribute("aria-label", `Curve of ${shown}: ${first} at first, ${last} now. ${mean}`);
  picture.setAttribute("aria-label", `${world.called}, seen from above: ${mean}`);
  find("theirs").querySelector("canvas").setAttribute("aria-label", rival ? `The other robot: ${called(racing)}` : "");
}

// A state in words: the bin of each input.
function inWords(s) {
  return yours.world.words.map(([name, bins], i) => {
    const stride = yours.world.shape.slice(i + 1).reduce((n, each) => n * each, 1);
    return `${name} ${bins[Math.floor(s / stride) % bins.length]}`;
  }).join(", ");
}

// The row of Q of a state: that under the pointer, or else the robot's own.
function showRow(state) {
  const { simulation, world } = yours, s = state === null ? simulation.last.sNext : state, q = simulation.m.q[s], best = bestOf(q);
  const visits = simulation.m.visits[s].reduce((sum, n) => sum + n, 0);
  find("where").textContent = state === null ? "What it knows where it stands" : "What it knows where you point";
  find("state").textContent = `State ${s}: ${inWords(s)}. Met ${visits.toLocaleString("en")} times.`;
  const most = simulation.m.q.reduce((high, row) => row.reduce((top, value) => Math.max(top, Math.abs(value)), high), NOTHING_YET);
  find("actions").tBodies[0].replaceChildren(...world.actions.map((action, a) => {
    const row = document.createElement("tr"), bar = document.createElement("div"), command = (world.commands ?? world.arrows)[a];
    for (const text of [a === best ? `${action} (best)` : action, command, number(q[a])]) row.insertCell().textContent = text;
    bar.className = q[a] < 0 ? "bar below" : "bar";
    bar.style.width = Math.abs(q[a]) < NOTHING_YET ? 0 : `${(100 * Math.abs(q[a])) / most}%`;
    row.insertCell().append(bar);
    row.className = a === best ? "best" : "";
    return row;
  }));
}

function play(yes) {
  playing = yes;
  find("play").textContent = yes ? "Pause" : "Play";
  changed();
}
