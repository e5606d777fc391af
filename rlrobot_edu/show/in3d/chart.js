// The curve of the moving average of the rewards, in the colours of the page.
function colour(name) {
  chart.style.color = `var(--${name})`;
  return getComputedStyle(chart).color;
}

function plot(i) {  // up to the reward of number i
  [chart.width, chart.height] = [2 * chart.clientWidth, 2 * chart.clientHeight];
  const pen = chart.getContext("2d"), [w, h, left, above] = [chart.width, chart.height, 66, 52];
  const low = Math.min(0, ...means), high = Math.max(0, ...means), y = v => above + (high - v) / (high - low || 1) * (h - above - 16);
  pen.font = "24px system-ui, sans-serif";
  pen.fillStyle = colour("ink");
  pen.fillText(`mean reward, last ${MEAN_OF} steps`, 12, 28);
  for (const v of new Set([low, 0, high])) {
    pen.fillStyle = colour("faint");
    if (v === 0 || Math.abs(y(v) - y(0)) > 24) pen.fillText(signed(v, 2).replace(/^\+0$/, "0"), 8, y(v) + 7);
    pen.fillStyle = colour(v ? "line" : "faint");
    pen.fillRect(left, y(v), w - left - 10, 1);
  }
  pen.beginPath();
  means.slice(0, i + 1).forEach((v, k) => pen.lineTo(left + k / Math.max(1, means.length - 1) * (w - left - 14), y(v)));
  pen.strokeStyle = colour("blue");
  pen.lineWidth = 4;
  pen.stroke();
}
