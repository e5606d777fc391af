agent = rl.Agent(model, seed=0)
env = rl.make_env(model, 0)
result = rl.compare(model, {3: {'method': 'Q+SR'}}, steps=20, progress=False, n_jobs=1, repetitions=1, episodes=1, store='_mine', planner=None)
