// How the rewards of the frames are shown: as the colours of a trail, and as the curve of their moving average.
const MEAN_OF = 50;  // steps
const isStep = ({reward}) => reward !== null;  // not a start, which no step led to
const signed = (number, digits) => (number < 0 ? "−" : "+") + Math.abs(+number.toPrecision(digits));

// The trail: a band on the floor, or in the air where nothing rolls; green for reward, red and wider for punishment
function lay() {
  const {colours} = world.room, most = Math.max(...frames.map(({reward}) => Math.abs(reward ?? 0))) || 1, width = world.span / 130;
  const [good, bad, none, path] = [colours.goal, colours.beam, "#4d5258", colours.path].map(colour);
  const corners = [], tints = [], side = new T.Vector3();
  for (let i = 1; i < frames.length; i++) {
    const [a, b] = [frames[i - 1], frames[i]].map(({leader: {position: p}}) => new T.Vector3(p.x, p.y, world.rolls ? 0.012 : p.z));
    const {reward} = frames[i], thick = width * (reward < 0 ? 1 + 0.8 * Math.sqrt(-reward / most) : 1);
    const along = b.clone().sub(a).setZ(0);
    const tint = reward === null ? path : none.clone().lerp(reward < 0 ? bad : good, Math.sqrt(Math.abs(reward) / most));
    if (along.length() > 1e-6) along.setLength(thick / 2);
    side.set(-along.y, along.x, 0);
    if (frames[i].jumps) b.copy(a);
    else { a.sub(along); b.add(along); }  // each piece overlaps the next, so that bends have no gaps
    const [one, two, three, four] = [a.clone().add(side), a.clone().sub(side), b.clone().sub(side), b.clone().add(side)];
    for (const p of [one, two, three, one, three, four]) {
      corners.push(p.x, p.y, p.z);
      tints.push(tint.r, tint.g, tint.b);
    }
  }
  trail.geometry.dispose();
  trail.geometry = new T.BufferGeometry();
  trail.geometry.setAttribute("position", new T.Float32BufferAttribute(corners, 3));
  trail.geometry.setAttribute("color", new T.Float32BufferAttribute(tints, 3));
}

// The curve up to a step
function plot(step) {
  const pen = chart.getContext("2d"), [w, h, left, above] = [chart.width, chart.height, 58, 34], steps = frames.filter(isStep);
  const means = steps.map(({mean}) => mean), low = Math.min(0, ...means), high = Math.max(0, ...means), y = v => above + (high - v) / (high - low || 1) * (h - above - 16);
  pen.clearRect(0, 0, w, h);
  pen.font = "20px sans-serif";
  pen.fillStyle = "#fff";
  pen.fillText(`mean reward, last ${MEAN_OF} steps`, 12, 22);
  for (const v of new Set([low, 0, high])) {
    pen.fillStyle = "#c3c9d1";
    if (v === 0 || Math.abs(y(v) - y(0)) > 24) pen.fillText(signed(v, 2).replace(/^\+0$/, "0"), 8, y(v) + 7);
    pen.fillStyle = v ? "#4a515a" : "#8a929c";
    pen.fillRect(left, y(v), w - left - 10, 1);
  }
  pen.beginPath();
  means.slice(0, steps.indexOf(step) + 1).forEach((v, i) => pen.lineTo(left + i / Math.max(1, means.length - 1) * (w - left - 14), y(v)));
  pen.strokeStyle = "#f0e442";
  pen.lineWidth = 4;
  pen.stroke();
}
