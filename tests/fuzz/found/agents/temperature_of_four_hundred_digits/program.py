agent = rl.Agent(model, 'SL+EG', temperature=10**400, loop_evasion=False, traces='full')
usable_agent(agent, rl.make_env('wander_simple' if len(agent.shape) == 2 else model, 0))
