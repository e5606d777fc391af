// What room.js paints on a canvas, as a list: each line of stdin is a program that uses `paint`, `given` and all of room.js.
"use strict";
const { readFileSync } = require("fs");
globalThis.window = { devicePixelRatio: 1 };
(0, eval)(`${readFileSync(process.argv[2], "utf8")}
globalThis.Room = Room; globalThis.RoomView = RoomView; globalThis.drawRoom = drawRoom;`);

// A canvas whose context notes each path when it is filled or stroked: [how, colour, its points].
function paint(width, height) {
  const told = [], done = (how) => function note() { told.push([how, this[`${how}Style`], this.path]); };
  const add = function add(...point) { this.path = [...this.path, point]; };
  const context = { path: [], beginPath() { this.path = []; }, moveTo: add, lineTo: add, arc: add, fill: done("fill"), stroke: done("stroke"),
    fillText(text, ...at) { told.push(["text", this.fillStyle, [[text, ...at]]]); }, measureText: () => ({ width: 0 }) };
  const nothing = new Proxy(context, { get: (target, name) => target[name] ?? (() => {}) });
  return { canvas: { clientWidth: width, clientHeight: height, getContext: () => nothing }, told };
}

const colours = new Proxy({}, { get: (_, name) => name }); // each is called by its name
require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const { program, given } = JSON.parse(line);
  console.log(JSON.stringify(new Function("paint", "colours", "given", program)(paint, colours, given)));
});
