rl.load_task('nowhere/x.npz')
rl.read_recording('a\nb')
recording.save('out/x')
recording.save('out.npz')
