variable = rl.OutputVariable('move', [1.170532558237239e+277], 'deg')
made = replace(task, outputs=[variable])

made.states.encode({'X': 0, 'theta': 90, 'd': 0})
made.states.decode(22)
made.states.encode(np.zeros(0))
made.states.encode(4.952811928613084e+16, {'X': 0, 'theta': 90, 'd': 0})
rl.make_env(made, 0).reset()
