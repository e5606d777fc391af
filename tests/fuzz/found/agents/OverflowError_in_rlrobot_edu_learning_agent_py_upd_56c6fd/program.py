agent = rl.Agent(task, 'SL+RANDOM', alpha=1, epsilon=0.1, accumulating=True, loop_evasion=True, lam=0.9)
agent.update(23, 1, 6.397105437994828e+16, 1, 2**63, True)
agent.learn_step(np.int64(3), 2, 1.5422059740070927e+85, 23, False)
agent.change(accumulating=True, loop_evasion=False)
agent.update('_mine', 2, '<b>', 23, 2, '\ud800')
agent.update({'x': 1}, 0, 6, 23, 9, False)
agent.policy, agent.bias, agent.shape
usable_agent(agent, rl.make_env('wander_simple' if len(agent.shape) == 2 else model, 0))
