"""``python -m rlrobot_edu tasks`` lists the tasks; ``python -m rlrobot_edu compile`` compiles the kernels ahead."""

from __future__ import annotations

import argparse

import rlrobot_edu as rl


def list_tasks() -> None:
    """One line a task: name, states × actions, robot and scene, and the first line of its description."""
    for name in rl.available_tasks():
        task = rl.load_task(name)
        size = f"{task.states.n} × {task.actions.n}"
        print(f"{name:<16} {size:>10}  {task.robot} in {task.scene}: {task.description.splitlines()[0]}")


def compile_kernels() -> None:
    """Compile what is not in the cache yet, so that the first lesson starts at once."""
    rl.learn(rl.Agent("worked_example"), rl.make_env("worked_example"), steps=1, progress=False)
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    rl.learn(rl.Agent(model), rl.make_env(model), steps=1, progress=False)
    print("The learning kernels are compiled.")


if __name__ == "__main__":
    commands = {"tasks": list_tasks, "compile": compile_kernels}
    parser = argparse.ArgumentParser(prog="python -m rlrobot_edu", description=__doc__)
    parser.add_argument("command", choices=commands)
    commands[parser.parse_args().command]()
