// The cells from above.

// Cells seen from above, one a pair of column and row; learned: tells of a place the action that is best there now.
function drawCells(canvas, world, place, learned, colours) {
  const { context, width, height } = sharpCanvas(canvas), cells = world.drawn.map(({ cell }) => cell);
  const columns = 1 + Math.max(...cells.map(([x]) => x)), rows = 1 + Math.max(...cells.map(([, y]) => y));
  const wide = width / columns, high = height / rows, small = Math.min(wide, high);
  const at = (x, y) => [wide * x, height - high * y], from = (left, top) => [left / wide, (height - top) / high];
  const is = (some, [x, y]) => some.some(([a, b]) => a === x && b === y), middle = ([x, y]) => at(x + 0.5, y + 0.5);
  const box = ([x, y], gap) => {
    const [left, top] = at(x, y + 1);
    context.fillRect(left + gap, top + gap, wide - 2 * gap, high - 2 * gap);
  };
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = `${Math.max(11, 0.36 * small)}px system-ui, sans-serif`;
  cells.forEach((cell, i) => {
    const isCliff = is(world.cliff, cell);
    context.fillStyle = isCliff ? colours.line : colours.floor;
    box(cell, isCliff ? -0.5 : 1); // no seams within the cliff
    context.fillStyle = is([world.goal], cell) ? colours.green : colours.faint;
    if (!isCliff) context.fillText(is([world.goal], cell) ? "goal" : learned(i), ...middle(cell));
  });
  const ends = [world.cliff[0], world.cliff.at(-1)].map(middle);
  context.fillStyle = colours.ink;
  context.fillText("cliff", (ends[0][0] + ends[1][0]) / 2, ends[0][1]);
  context.fillStyle = colours.blue;
  context.beginPath();
  context.arc(...middle(place.cell), 0.3 * small, 0, 7);
  context.fill();
  return { at, from };
}
