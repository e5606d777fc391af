"""The kernels that the lessons run, compiled before a learner waits for them."""

import rlrobot_edu as rl

METHODS = ("TOSL+QBIASSR", "TOSL+SR", "SARSA+SR", "Q+SR", "Q+EG")


def compile_ahead() -> None:
    """Compile the usual methods, on a robot and on a sample model, where they are not in the cache yet."""
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    for method in METHODS:
        for world in ("worked_example", model):
            rl.learn(rl.Agent(world, method), rl.make_env(world), steps=1, progress=False)
    print("The learning kernels are compiled.")
