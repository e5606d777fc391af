env = Foreign(shape=10**12)  # given
agent = rl.Agent(env, 'Q+SR', seed=0)
usable_agent(agent, env, 20)
