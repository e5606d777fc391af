env = Foreign(drive=lambda *_: 0)  # given
agent = rl.Agent(env, 'Q+SR', seed=0)
usable_agent(agent, env, 20)
