variable = rl.OutputVariable('a\nb', [0, 1], 'a\nb', words=['a', 'b'])
made = replace(task, outputs=[variable])

made.states.decode(0)
made.states.decode(np.int64(3))
rl.make_env(made, 0).reset()
