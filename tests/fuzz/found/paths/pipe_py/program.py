rl.load_task(pipe('pipe.py'))
