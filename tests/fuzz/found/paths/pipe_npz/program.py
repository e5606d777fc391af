rl.Agent.load(pipe('pipe.npz'))
