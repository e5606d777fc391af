// A learner in its world, from their beginning: a simulation of these settings, with the luck that is set.
// walls: inside the room, as walls.js has them, in place of those of the task
function newSimulation({ task, method, luck, alpha, gamma, lam, temperature, epsilon }, walls = null) {
  const world = about.worlds[task], i = about.methods.findIndex(({ name }) => name === method);
  const own = { select: kernels[`select_${i}`], learn_step: kernels[`learn_step_${i}`] };
  const all = { ...kernels, ...own, reward: kernels[`reward_${task}`], goal: kernels[`goal_${task}`] };
  const random = about.lucks[luck]; // agent and world draw numbers of their own
  const made = new { BaseWorld, ModelWorld }[world.kind](world, all, pcg64(random.world));
  if (walls && made.walls) made.build(allWalls(made, walls));
  const parameters = { ...about.defaults, alpha, gamma, lam, temperature, epsilon, r_max: world.rMax };
  const memory = newMemory(world.shape, world.nActions, parameters, all);
  return new Simulation(all, memory, made, pcg64(random.agent));
}
