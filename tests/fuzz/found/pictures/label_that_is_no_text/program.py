env = rl.make_env('wander_simple', 0); env.reset(); scene = env.robot.scene()  # given
made = rl.plot_learning(history, labels=[range(3)])
drawn(made)
