// The walls inside a room, as the page and its link hold them: [x, y, half its length, degrees], in millimetres and
// whole degrees. So a link leads to the same numbers.
const THIN = 0.05; // half the thickness of a wall [m]
const MOST_WALLS = 60;

const millimetres = (x) => Math.round(1000 * x) / 1000;

// A wall as the kernels want it, and back.
function rowOf([x, y, half, degrees]) {
  const angle = (degrees * Math.PI) / 180;
  return [x, y, half, THIN, Math.cos(angle), Math.sin(angle)];
}
function heldOf([x, y, half, , cos, sin]) {
  return [...[x, y, half].map(millimetres), Math.round((Math.atan2(sin, cos) * 180) / Math.PI)];
}

// The walls around the room, which stay where they are.
const isAround = ({ bounds: [xMin, yMin, xMax, yMax] }, [x, y]) => x < xMin || x > xMax || y < yMin || y > yMax;
const wallsInside = (world) => Array.from(world.walls).filter((wall) => !isAround(world, wall)).map(heldOf);
const allWalls = (world, inside) => [
  ...Array.from(world.walls).filter((wall) => isAround(world, wall)), ...inside.map(rowOf),
];

// The wall, moved back into the room if a part of it is outside.
function intoRoom({ bounds: [xMin, yMin, xMax, yMax] }, [x, y, half, degrees]) {
  const [, , , , cos, sin] = rowOf([x, y, half, degrees]).map(Math.abs);
  const wide = half * cos + THIN * sin, high = half * sin + THIN * cos;
  const between = (at, low, high) => Math.max(low, Math.min(high, at));
  return [
    ...[between(x, xMin + wide, xMax - wide), between(y, yMin + high, yMax - high), half].map(millimetres),
    ((degrees % 180) + 180) % 180,
  ];
}

// From a point to the nearest part of a wall [m].
function distanceTo(wall, x, y) {
  const [cx, cy, half, thin, cos, sin] = rowOf(wall), dx = x - cx, dy = y - cy;
  return Math.hypot(Math.max(0, Math.abs(dx * cos + dy * sin) - half), Math.max(0, Math.abs(dy * cos - dx * sin) - thin));
}

// Whether a robot at this place touches none of the walls, and is in the room.
function isFree({ bounds: [xMin, yMin, xMax, yMax], radius }, [x, y], walls) {
  const inRoom = Math.min(x - xMin, xMax - x, y - yMin, yMax - y) > radius;
  return inRoom && walls.every((wall) => distanceTo(wall, x, y) > radius);
}

// Of a link: its walls, those that can stand there; null if it has none.
function wallsFrom(text, world) {
  if (!text || !world.bounds) return null;
  const walls = text.split(";").map((wall) => wall.split(",").map(Number)).filter((numbers) =>
    numbers.length === 4 && numbers.every(Number.isFinite) && numbers[2] >= 0.1 && numbers[2] <= 1.5);
  if (text !== "none" && !walls.length) return null;
  return walls.slice(0, MOST_WALLS).map((wall) => intoRoom(world, wall))
    .filter((wall) => distanceTo(wall, ...world.start) > world.radius);
}
