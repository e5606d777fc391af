// What a picture is made of. All are texts of SVG; colours are names of palette.py, such as "blue".

const ink = (colour) => `var(--${colour})`;

function mark(kind, attributes, inside = "") {
  const given = Object.entries(attributes).filter(([, value]) => value !== undefined && value !== false);
  return `<${kind} ${given.map(([name, value]) => `${name}="${escaped(value)}"`).join(" ")}>${inside}</${kind}>`;
}

// A bar from y to `to`, up or down.
function bar(x, width, y, to, colour, more = {}) {
  const height = Math.abs(to - y);
  return mark("rect", { x, width, y: Math.min(y, to), height, style: `fill:${ink(colour)}`, ...more });
}

function line(x1, y1, x2, y2, colour, more = {}) {
  return mark("line", { x1, y1, x2, y2, style: `stroke:${ink(colour)}`, ...more });
}

// A line through points [[x, y], …].
function way(points, colour, more = {}) {
  const d = points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
  return mark("path", { d, style: `stroke:${ink(colour)};fill:none`, ...more });
}

// Letters; anchor: "start", "middle" or "end" of them is at x.
function letters(x, y, text, anchor = "start", colour = "ink", more = {}) {
  return mark("text", { x, y, "text-anchor": anchor, style: `fill:${ink(colour)}`, ...more }, escaped(text));
}
