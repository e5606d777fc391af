env = Foreign(terminated=True, info=None, drive=None, r_max=np.float32(0.5), task='x')  # given
agent = rl.Agent(env)
usable_agent(agent, env, 20)
