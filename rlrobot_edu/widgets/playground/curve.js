// The curve: what it was paid, and how often it bumped, as it learns.

// The score as it was: now and then one point, never more than LENGTH of them; when they are full, every second one goes.
class Curve {
  constructor(score) {
    Object.assign(this, { score, points: [], gap: 20, called: "" });
  }

  // The score of a period has been counted up to here.
  note() {
    const { t } = this.score;
    if (t !== PERIOD && (t < PERIOD || t % this.gap)) return;
    this.points.push(this.score.now);
    if (this.points.length < Curve.LENGTH) return;
    this.gap *= 2;
    this.points = this.points.filter((point) => point.t === PERIOD || point.t % this.gap === 0);
  }

  get steps() {
    return this.points.at(-1)?.t ?? 0;
  }

  // Points [step, value in the PERIOD before it]; the last one is the score of now.
  of(kind) {
    const all = this.score.t > this.steps && this.steps ? [...this.points, this.score.now] : this.points;
    return all.map((point) => [point.t, point[kind]]);
  }
}
Curve.LENGTH = 240;

// The curve that grows, and another, dashed; both from step 0 to the step that is the later.
// words: of the axes, [what the curve shows, what is said of a number of steps]
function drawCurves(canvas, kind, now, other, [called, timeOf], colours) {
  const { context, width, height } = sharpCanvas(canvas), curves = other ? [other, now] : [now];
  const steps = Math.max(2 * PERIOD, ...curves.map((curve) => curve.steps));
  const lines = curves.map((curve) => curve.of(kind)), all = lines.flat().map(([, mean]) => mean);
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
    context.strokeStyle = curve === now ? colours.blue : colours.grey;
    context.setLineDash(curve === now ? [] : [5, 4]);
    context.lineWidth = 2.5;
    context.lineJoin = "round";
    context.beginPath();
    lines[k].forEach(([step, mean], i) => (i ? context.lineTo(x(step), y(mean)) : context.moveTo(x(step), y(mean))));
    context.stroke();
  });
  context.setLineDash([]);
}
