env = rl.make_env('wander_simple', 0); env.reset(); scene = env.robot.scene()  # given
made = rl.plot_scene([scene, scene], ax=3.1266365068372438e-176, title='a\nb')
drawn(made)
