rl.value_iteration(model, tolerance=-1)
rl.value_iteration(model, tolerance=nan)
best_average_reward(replace(model, r=model.r * 1e9, rewards=model.rewards * 1e9))
