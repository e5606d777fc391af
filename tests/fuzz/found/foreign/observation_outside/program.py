env = Foreign(observation=np.array([10**8, 0]))  # given
agent = rl.Agent(env, 'Q+SR', seed=0)
usable_agent(agent, env, 20)
