rl.Agent.load('/dev/zero')
rl.SampleModel.load('/dev/zero')
rl.load_task('/dev/zero')
