made = model
usable_model(made)
made.sum_by_pair(10**400)
made.sum_by_pair(made.r)
made.outcomes(1, -1.7412875809750624e+257)
rl.best_average_reward(made)
