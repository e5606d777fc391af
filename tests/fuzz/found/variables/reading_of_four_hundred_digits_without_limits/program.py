variable = rl.InputVariable('theta', range(2), 'deg')
variable.decode(0)
variable.bin(10**400)
made = replace(task, inputs=[variable, *task.inputs[2:]])

made.states.encode({'X': 0, 'theta': 90, 'd': 0}, nonsense=1)
rl.make_env(made, 0).reset()
