rl.read_recording(pipe('pipe.npy'), legacy=True, task=task)
