// What the kernels do as JavaScript: a job in a line of stdin, what came of it in a line of stdout.
"use strict";
const programs = {};

const table = (rows, kind) => rows.map((row) => kind.from(row));
const given = (numbers) => { let next = 0; return { random: () => numbers[next++] }; };

function memory(m) {
  const whole = ["register", "queue_states", "queue_count", "shape"];
  for (const name of whole) m[name] = Int32Array.from(m[name]);
  for (const name of ["queue_rewards", "probabilities", "bias"]) m[name] = Float64Array.from(m[name]);
  return { ...m, q: table(m.q, Float64Array), e: table(m.e, Float64Array), visits: table(m.visits, Int32Array) };
}

function tables(t) {
  for (const name of ["starts", "offsets", "cumulative", "s_next", "shape"]) t[name] = Int32Array.from(t[name]);
  for (const name of ["r", "rewards"]) t[name] = Float64Array.from(t[name]);
  return t;
}

function steps(kernels, job, m) {
  const told = [];
  for (const [s, a, r, s_next, terminated, u] of job.tape) {
    told.push(kernels.learn_step(m, s, a, r, s_next, terminated, u));
    if (terminated) kernels.begin_episode(m);
  }
  return { told };
}

function run(kernels, job, m) {
  const column = () => new Array(job.steps).fill(0);
  const log = { s: column(), a: column(), r: column(), s_next: column(), terminated: column(), truncated: column() };
  const at = [0, -1, 0, 0, 0], begun = process.hrtime.bigint();
  kernels.run(tables(job.tables), m, null, given(job.u), given(job.v), at, log);
  return { rewards: log.r, at, microseconds: Number(process.hrtime.bigint() - begun) / 1000 / job.steps };
}

require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const job = JSON.parse(line);
  if (job.program) programs[job.method] = (0, eval)(job.program);
  if (job.kind === "call") {
    console.log(JSON.stringify(programs[job.method][job.name](...job.arguments)));
    return;
  }
  const m = memory(job.memory);
  const told = { steps, run }[job.kind](programs[job.method], job, m);
  for (const name of ["q", "e", "visits"]) told[name] = m[name].map((row) => Array.from(row));
  console.log(JSON.stringify({ ...told, probabilities: Array.from(m.probabilities), temperature: m.now.temperature }));
});
