env = Foreign(shape=(2, 3), n=1, reward=inf, info=None, state=None, episode_steps=0)  # given
env = gymnasium.wrappers.TransformReward(env, lambda r: int(r))  # given
agent = rl.Agent(env, 'TOSL+QBIASSR', seed=np.random.SeedSequence(3))
usable_agent(agent, env, 20)
rl.record(agent, env, 1).save('out')
walk(agent, env, 20, resume=False)
