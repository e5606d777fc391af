agent = rl.Agent(task, 'Q+SR', temperature=1, accumulating=False, loop_evasion=False)
agent.change(loop_evasion=False, r_max=5)
agent.policy, agent.bias, agent.shape
agent.change()
agent.update(23, 1, -5.5843762148373e+16, 1, 0.5, -1)
agent.begin_episode(True)
agent.update(23, 1, np.array([1, 2]), np.int64(3), 1, False)
usable_agent(agent, rl.make_env('wander_simple' if len(agent.shape) == 2 else model, 0))
