made = model
usable_model(made)
made.diagnose(3, nonsense=1)
rl.value_iteration(made, tolerance=np.float32(0.5))
rl.value_iteration(made, gamma=0.9, tolerance=1e-300)
rl.value_iteration(made, gamma=0.9)
