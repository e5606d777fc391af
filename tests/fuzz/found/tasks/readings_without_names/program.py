made = replace(task, description=1e308)
made.states.encode(np.array([[0.5]]))
env = rl.make_env(made, 0)
usable_agent(rl.Agent(made), env, 40)
