agent = rl.Agent(model, seed=0)
env = rl.make_env(model, 0)
result = rl.compare(model, ['Q+SR', 'SARSA+EG'], repetitions=2, steps=20, progress=False, n_jobs=1, episodes=1, alpha=1, temperature=5e-324, epsilon=0.1, lam=0.9, planner='dyna')
