env = rl.make_env('wander_simple', 0); env.reset(); scene = env.robot.scene()  # given
made = BiasExplorer(task, nan, state=0)
drawn(made)
