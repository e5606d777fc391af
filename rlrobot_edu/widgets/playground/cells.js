// The cells from above.

// Cells seen from above, one a pair of column and row; learned: tells of a place the action that is best there now.
function drawCells(canvas, world, place, learned, colours) {
  const { context, width, height } = sharp(canvas), cells = world.drawn.map(({ cell }) => cell);
  const columns = 1 + Math.max(...cells.map(([x]) => x)), rows = 1 + Math.max(...cells.map(([, y]) => y));
  const view = new View([-0.05, -0.05, columns + 0.05, rows + 0.05], width, height);
  const is = (some, [x, y]) => Boolean(some) && some.some(([a, b]) => a === x && b === y);
  const box = ([x, y], shrink) => {
    const [left, top] = view.at(x + shrink, y + 1 - shrink), side = view.scale * (1 - 2 * shrink);
    context.fillRect(left, top, side, side);
  };
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = `${Math.max(11, 0.26 * view.scale)}px system-ui, sans-serif`;
  const names = cells.map(String);
  new Set(names).forEach((text) => {
    const cell = text.split(",").map(Number), middle = view.at(cell[0] + 0.5, cell[1] + 0.5);
    context.fillStyle = is(world.cliff, cell) ? colours.line : colours.floor;
    box(cell, 0.02);
    context.fillStyle = colours.faint;
    if (is(world.cliff, cell)) context.fillText("cliff", ...middle);
    else if (world.goal && is([world.goal], cell)) context.fillText("goal", ...middle);
    else if (learned) context.fillText(learned(names.indexOf(text)), ...middle);
  });
  if (place.box) {
    context.fillStyle = colours.box;
    box(place.box, 0.2);
  }
  const [x, y] = view.at(place.cell[0] + 0.5, place.cell[1] + 0.5), size = 0.3 * view.scale;
  context.fillStyle = colours.robot;
  context.beginPath();
  context.arc(x, y, size, 0, 7);
  context.fill();
  if (place.heading !== null) {
    const turn = (-place.heading * Math.PI) / 180;
    context.strokeStyle = colours.back;
    context.lineWidth = size / 4;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + size * 0.9 * Math.cos(turn), y + size * 0.9 * Math.sin(turn));
    context.stroke();
  }
  return view;
}
