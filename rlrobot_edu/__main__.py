"""``python -m rlrobot_edu``: ``tasks`` lists them, ``compile`` compiles the kernels, ``reproduce`` runs the paper."""

import argparse
import io
import signal
import sys

import rlrobot_edu as rl


def list_tasks() -> None:
    """One line a task: name, states × actions, robot and scene, and the first line of its description."""
    for name in rl.available_tasks():
        try:
            task = rl.load_task(name)
        except (ValueError, OSError) as error:  # the others are to be seen all the same
            print(f"{name:<16} cannot be loaded: {error}")
            continue
        size = f"{task.states.n} × {task.actions.n}"
        print(f"{name:<16} {size:>10}  {task.robot} in {task.scene}: {task.description.partition(chr(10))[0]}")


def compile_kernels() -> None:
    """Compile what is not in the cache yet, so that the first lesson starts at once."""
    rl.learn(rl.Agent("worked_example"), rl.make_env("worked_example"), steps=1, progress=False)
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    rl.learn(rl.Agent(model), rl.make_env(model), steps=1, progress=False)
    print("The learning kernels are compiled.")


def reproduce(quick: bool) -> None:
    """Run the paper's experiments and write docs/reproduction/."""
    from rlrobot_edu.reproduction.run import reproduce

    reproduce(quick)


if __name__ == "__main__":
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # a terminal that knows no "×" shows a question mark
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `… | head -1` has seen enough: end without a word
    parser = argparse.ArgumentParser(prog="python -m rlrobot_edu", description=__doc__)
    commands = parser.add_subparsers(required=True)
    commands.add_parser("tasks", help=list_tasks.__doc__).set_defaults(run=list_tasks)
    commands.add_parser("compile", help=compile_kernels.__doc__).set_defaults(run=compile_kernels)
    command = commands.add_parser("reproduce", help=reproduce.__doc__)
    command.add_argument("--quick", action="store_true", help="few repetitions, into docs/reproduction/quick/")
    command.set_defaults(run=reproduce)
    arguments = vars(parser.parse_args())
    arguments.pop("run")(**arguments)
