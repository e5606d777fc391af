// The curve: what it was paid, and how often it bumped, as it learns.

// Means in windows of equal length, never more than LENGTH of them: when they are full, two become one.
class Curve {
  constructor() {
    Object.assign(this, { rewards: [], counts: [], window: 20, reward: 0, count: 0, n: 0, called: "" });
  }

  add(r, counts) {
    this.reward += r;
    this.count += counts ? 1 : 0;
    if (++this.n < this.window) return;
    this.rewards.push(this.reward / this.n);
    this.counts.push((PERIOD * this.count) / this.n);
    this.reward = this.count = this.n = 0;
    if (this.rewards.length < Curve.LENGTH) return;
    const halved = (means) => means.filter((_, i) => i % 2).map((mean, i) => (mean + means[2 * i]) / 2);
    [this.rewards, this.counts] = [halved(this.rewards), halved(this.counts)];
    this.window *= 2;
  }

  get steps() {
    return this.rewards.length * this.window;
  }

  // Points [step, mean]; each is the mean of the windows in the PERIOD before it, or of five of them. At first a count
  // is what there has been so far: the curve says the number that stands beside it.
  points(kind) {
    const means = this[kind], wide = Math.max(5, Math.round(PERIOD / this.window));
    let sum = 0;
    return means.map((mean, i) => {
      sum += mean - (i >= wide ? means[i - wide] : 0);
      return [(i + 1) * this.window, sum / (kind === "counts" ? wide : Math.min(i + 1, wide))];
    });
  }
}
Curve.LENGTH = 240;

// The curve that grows, and another, dashed; both from step 0 to the step that is the later.
// words: of the axes, [what the curve shows, what is said of a number of steps]
function drawCurves(canvas, kind, now, other, [called, timeOf], colours) {
  const { context, width, height } = sharp(canvas), curves = other ? [other, now] : [now];
  const steps = Math.max(2 * PERIOD, ...curves.map((curve) => curve.steps));
  const lines = curves.map((curve) => curve.points(kind)), all = lines.flat().map(([, mean]) => mean);
  const low = Math.min(0, ...all), high = Math.max(kind === "counts" ? 5 : 0.5, ...all), span = high - low;
  const left = 34, bottom = height - 22, right = width - 8, top = 26;
  const x = (step) => left + ((right - left) * step) / steps, y = (r) => bottom - ((bottom - top) * (r - low)) / span;
  context.font = "13px system-ui, sans-serif";
  context.fillStyle = colours.faint;
  context.textAlign = "right";
  context.textBaseline = "middle";
  const text = (value) => value.toFixed(kind === "counts" ? 0 : 1).replace("-", "−");
  for (const value of new Set([low, 0, high])) context.fillText(text(value), left - 6, y(value));
  context.textBaseline = "alphabetic";
  context.fillText(timeOf(steps), right, height - 5);
  context.textAlign = "left";
  context.fillText("0", left, height - 5);
  context.fillText(called, 0, 13);
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(left, top);
  context.lineTo(left, bottom);
  context.moveTo(left, y(0));
  context.lineTo(right, y(0));
  context.stroke();
  curves.forEach((curve, k) => {
    context.strokeStyle = curve === now ? colours.robot : colours.ghost;
    context.setLineDash(curve === now ? [] : [5, 4]);
    context.lineWidth = 2.5;
    context.lineJoin = "round";
    context.beginPath();
    lines[k].forEach(([step, mean], i) => (i ? context.lineTo(x(step), y(mean)) : context.moveTo(x(step), y(mean))));
    context.stroke();
  });
  context.setLineDash([]);
}
