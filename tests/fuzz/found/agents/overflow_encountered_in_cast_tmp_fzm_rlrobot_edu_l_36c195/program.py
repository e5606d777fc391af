agent = rl.Agent('wander_simple', 'SARSA+EGLE', seed=np.random.SeedSequence(3), epsilon=1, r_max=np.float32(0.5), lam=0.9)
usable_agent(agent, rl.make_env('wander_simple' if len(agent.shape) == 2 else model, 0))
