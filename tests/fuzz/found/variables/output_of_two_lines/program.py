variable = rl.OutputVariable('a\nb', [0.5], 'deg')
made = replace(task, outputs=[variable])

made.states.decode()
made.states.encode({'X': 0, 'theta': 90, 'd': 0})
rl.make_env(made, 0).reset()
