// The map of a film: the same step from above, drawn by room.js, as long as the robot is one that drives.
let film;  // the command that made the replay, and its numbers
function layOut({names, moves, map}) {
  const numbers = new Float32Array(Uint8Array.from(moves).buffer), steps = numbers.length / names.length / 12;
  // number of a thing's transform, in the order of its rows, at a step
  const number = (name, i, step) => numbers[(12 * names.indexOf(name) + i) * steps + step];
  film = {map, number, beams: names.filter(name => name.startsWith("beams/"))};
  flat.hidden = !map.outline;
}

function placeAt(step) {
  const m = i => film.number("robot/body", i, step);
  return [m(3), m(7), Math.atan2(m(4), m(0))];
}

// A beam is a cylinder along its own y: from its middle half of that axis leads to each end.
function beamAt(name, step) {
  const m = i => film.number(name, i, step);
  return [m(3) - m(1) / 2, m(7) - m(5) / 2, m(3) + m(1) / 2, m(7) + m(5) / 2];
}

function drawMap() {
  const step = Math.min(Math.floor(at + 1e-6), last), first = rewards.length - 1 - last;
  const trail = [...Array(step + 1).keys()].map(k => {
    const [x, y] = placeAt(k), wasPut = k === 0 || film.map.put.includes(k);
    return [x, y, wasPut ? null : rewards[first + k] ?? 0];
  });
  const scene = {...film.map, place: placeAt(step), beams: film.beams.map(name => beamAt(name, step))};
  drawRoom(plan, scene, {trail, loss: film.map.loss});
}

flat.onclick = () => {
  flat.setAttribute("aria-pressed", !pressed(flat));
  plan.hidden = !pressed(flat);
  shown = undefined;
};
