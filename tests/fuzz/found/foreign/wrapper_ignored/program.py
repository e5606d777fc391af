env = rl.make_env('wander_simple', 0)  # given
env = gymnasium.wrappers.TransformObservation(env, lambda o: o[:1], gymnasium.spaces.MultiDiscrete([2]))  # given
agent = rl.Agent(env, 'Q+SR', seed=0)
usable_agent(agent, env, 20)
rl.learn(agent, env, 50, progress=False)
