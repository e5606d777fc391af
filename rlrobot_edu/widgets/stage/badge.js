// Words on a ground of their own beside the robot: what it would do, with its chance, and what its step paid.

// A badge is a text, with a small line above it. How large it is [px]: wide, high, and of the small line
const fontOf = ({ narrow }) => `650 ${narrow ? 16 : 20}px ${FONT}`;
const smallFont = () => `600 13px ${FONT}`;
function badgeSize(context, badge) {
  const { text, small = "", narrow } = badge, line = small ? 17 : 0;
  const widths = [[fontOf(badge), text], [smallFont(), small]].map(([font, words]) => {
    context.font = font;
    return context.measureText(words).width;
  });
  return [Math.max(...widths) + 16, (narrow ? 26 : 32) + line, line];
}

const insideOf = ([x, y], [w, h], [left, top, wide, high]) =>
  [Math.max(left + w / 2, Math.min(left + wide - w / 2, x)), Math.max(top + h / 2, Math.min(top + high - h / 2, y))];

// Where a badge of this size stands, and where its line ends: the nearest spot to the robot at which it hides nothing.
// The line leads to the arrow's tip, or to the robot's rim if it would cross the robot.
// others: all else that is drawn; radius: of a robot
function besideRobot([w, h], [x, y], tip, others, rect, radius) {
  const steps = Array.from({ length: 17 }, (_, i) => 20 * (i - 8));
  const spots = steps.flatMap((dx) => steps.map((dy) => insideOf([x + dx, y + dy], [w, h], rect)));
  const away = (a, b, half) => Math.max(0, Math.abs(a - b) - half);
  const freeOf = ([left, top]) => Math.min(...[[x, y], tip, ...others].map((one) => Math.hypot(away(one[0], left, w / 2), away(one[1], top, h / 2))));
  const isCrossed = ([left, top]) => [0.05, 0.1, 0.2, 0.4, 0.6].some((part) =>
    Math.hypot(mixed(tip[0], left, part) - x, mixed(tip[1], top, part) - y) < radius);
  const farOf = (spot) => Math.hypot(spot[0] - x, spot[1] - y);
  const spot = mostBy(spots, (one) => 10 * Math.min(freeOf(one) - radius, 6) - farOf(one) / 10 - (isCrossed(one) ? 20 : 0));
  const part = radius / Math.max(farOf(spot), radius), rim = [mixed(x, spot[0], part), mixed(y, spot[1], part)];
  return { spot, end: isCrossed(spot) ? rim : tip };
}

// A line from a badge to what it speaks of.
function drawTether(context, from, to, colours) {
  context.strokeStyle = colours.ink;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
}

// Words on a ground of their own, whole inside a rectangle [left, top, wide, high].
function drawBadge(context, badge, spot, tone, ink, rect) {
  const [w, h, line] = badgeSize(context, badge), [cx, cy] = insideOf(spot, [w, h], rect);
  context.fillStyle = tone;
  context.beginPath();
  context.roundRect(cx - w / 2, cy - h / 2, w, h, 8);
  context.fill();
  context.fillStyle = ink;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = smallFont();
  if (badge.small) context.fillText(badge.small, cx, cy - h / 2 + 13);
  context.font = fontOf(badge);
  context.fillText(badge.text, cx, cy + 1 + line / 2);
}
