env = Foreign(observation=np.array([0.5, nan]))  # given
agent = rl.Agent(env, 'Q+SR', seed=0)
usable_agent(agent, env, 20)
