"""The library's commands: ``python -m rlrobot_edu``; ``rlrobot-edu`` has those of the course, too."""

import contextlib
import io
import os
import sys
from argparse import ArgumentParser
from argparse import RawDescriptionHelpFormatter as AsWritten
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import rlrobot_edu as rl

ABOUT = "Tabular reinforcement learning on simulated robots."
FIRST = "%(prog)s COMMAND --help says more about a command, with an example."


def list_tasks() -> None:
    """List the robots' tasks: name, states × actions, robot and scene, and what it is about."""
    for name in rl.available_tasks():
        try:
            task = rl.load_task(name)
            size, about = (
                f"{task.states.n} × {task.actions.n}",
                task.description.partition("\n")[0],
            )
            print(f"{name:<16} {size:>10}  {task.robot} in {task.scene}: {about}")
        except (ValueError, OSError) as error:  # the others are shown all the same
            print(f"{name:<16} cannot be loaded: {error}")


def make_task(name: str, robot: str) -> None:
    """Write NAME.py, a task file of your own to begin with, into this folder."""
    path = rl.new_task(name, robot=robot)
    # a bare python may be one without the toolkit
    print(
        f"Written: {path}, which works as it is. Check: {sys.executable} -m rlrobot_edu check-task {path}"
    )


def look_at_task(task: str, steps: int) -> None:
    """Let a task's robot act at random, and an agent learn: what is odd about the task?"""
    print(rl.check_task(task, steps=steps))


def serve_robot(task: Any, link: str, port: int, simulated_time: bool) -> None:
    """Let a simulated robot speak ROS, as a real one would, until Ctrl-C; to rehearse with rl.RobotLink."""
    where: dict[str, Any] = {"port": port} if link == "rosbridge" else {}
    served = rl.ServedRobot(task, link, simulated_time=simulated_time, **where)
    with served as robot, contextlib.suppress(KeyboardInterrupt):
        print(
            f"The robot is on: odom, laser_scan and cmd_vel over {robot.way}. Ctrl-C ends it.",
            flush=True,
        )
        robot.wait()


def doctor() -> None:
    """Say what is installed, what is missing, and what that disables; fails if the toolkit cannot work."""
    from rlrobot_edu.tools.doctor import examine

    print(diagnosis := examine())
    sys.exit(diagnosis.is_broken)


class Commands:
    """What can be typed after a program's name, and what --help says about it; `parser` reads it."""

    def __init__(self, about: str = ABOUT, first: str = FIRST) -> None:
        called = Path(sys.argv[0])
        name = (
            "rlrobot-edu"
            if called.name.startswith("rlrobot-edu")
            else f"python -m {called.parent.name}"
        )
        self.parser = ArgumentParser(
            name, description=about, epilog=first, formatter_class=AsWritten
        )
        self._commands = self.parser.add_subparsers(
            required=True, title="commands", metavar="COMMAND"
        )

    def add(
        self, name: str, run: Callable[..., None], example: str = ""
    ) -> ArgumentParser:
        """A command `name` that calls `run` with its arguments."""
        about, epilog = run.__doc__, f"Example: %(prog)s {example}"
        command = self._commands.add_parser(
            name, help=about, description=about, epilog=epilog
        )
        command.set_defaults(run=run)
        return command


def library_commands(
    commands: Commands, serve: Callable[..., None] = serve_robot
) -> ArgumentParser:
    """Add the library's commands; returns that of ``serve-robot``, which calls `serve`."""
    commands.add("doctor", doctor)
    commands.add("tasks", list_tasks)
    command = commands.add("new-task", make_task, "reach --robot arm")
    command.add_argument("name", help="of the task, as in follow_wall")
    command.add_argument(
        "--robot",
        default="mobile_base",
        help="as arm or giraff; mobile_base if not given",
    )
    command = commands.add("check-task", look_at_task, "follow_wall.py --steps 500")
    command.add_argument("task", help="name of a task, or path of a task file")
    command.add_argument(
        "--steps",
        type=int,
        default=2000,
        help="length of each trial, 2000 if not given",
    )
    command = commands.add("serve-robot", serve, "giraff_wander_1k --port 9091")
    command.add_argument(
        "task",
        nargs="?",
        default="giraff_wander_simple",
        help="%(default)s if not given",
    )
    command.add_argument(
        "--link", default="rosbridge", help="rosbridge (if not given) or dds"
    )
    command.add_argument(
        "--port", type=int, default=9090, help="of rosbridge, 9090 if not given"
    )
    command.add_argument(
        "--simulated-time",
        action="store_true",
        help="time passes only as commands come",
    )
    return command


def parse(given: Sequence[str] | None) -> tuple[Callable[..., None], dict[str, Any]]:
    """The function of the command that is given, and its arguments. Ends the program where there is no such command."""
    commands = Commands()
    library_commands(commands)
    arguments = vars(commands.parser.parse_args(given))
    return arguments.pop("run"), arguments


def run_command(parse: Callable[..., Any], given: Sequence[str] | None) -> None:
    """Run the command that `parse` finds, of the command line unless another one is `given`."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(
            errors="replace"
        )  # a terminal that knows no "×" shows a question mark
    try:
        try:
            run, arguments = parse(given)
            run(**arguments)
        finally:
            print(end="", flush=True)  # here, where it may fail
    except BrokenPipeError:  # `… | head -1` has seen enough: end without a word
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except (
        ValueError,
        OSError,
        ImportError,
    ) as error:  # one sentence that says what to do
        sys.exit(str(error).removeprefix(f"[Errno {getattr(error, 'errno', '')}] "))


def main(given: Sequence[str] | None = None) -> None:
    """Run one command: the one of the command line, unless another one is `given`."""
    run_command(parse, given)


if __name__ == "__main__":
    main()
