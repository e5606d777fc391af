env = Foreign(shape=6, reward=10**400, terminated=False, drive=lambda *_: 0, state=10**9)  # given
env = gymnasium.wrappers.RecordEpisodeStatistics(env)  # given
agent = rl.Agent(env, 'ESARSA+GREEDY')
usable_agent(agent, env, 20)
walk(agent, env, 4)
walk(agent, env, 20)
