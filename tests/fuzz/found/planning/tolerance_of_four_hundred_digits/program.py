made = model
usable_model(made)
made.best_average_reward()
rl.value_iteration(made, tolerance=10**400)
made.outcomes(np.array([[0.5]]), 1)
