made = model
usable_model(made)
best_average_reward(made)
rl.value_iteration(made, tolerance=10**400)
made.outcomes(np.array([[0.5]]), 1)
