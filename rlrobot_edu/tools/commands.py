"""The commands: ``rlrobot-edu COMMAND``, or ``python -m rlrobot_edu COMMAND``.

The other packages add theirs: a function that takes `Commands`, named in pyproject.toml's entry points `GROUP`.
"""

import io
import os
import re
import sys
from argparse import ArgumentParser
from argparse import RawDescriptionHelpFormatter as AsWritten
from collections.abc import Callable, Sequence
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import rlrobot_edu as rl
from rlrobot_edu.checks import did_you_mean
from rlrobot_edu.task.task_file import available_tasks
from rlrobot_edu.version import __version__

GROUP = "rlrobot_edu.commands"
ABOUT = "Learn tabular reinforcement learning on simulated robots: a library, and a course of notebooks on top of it."
FIRST = """begin with:
  %(prog)s doctor                   is everything here?
  %(prog)s lab                      open the course
  %(prog)s check-task wander_1k     what a task's robot senses, does and is paid for

%(prog)s COMMAND --help says more about a command, with an example."""


def list_tasks() -> None:
    """List the robots' tasks: name, states × actions, robot and scene, and what it is about."""
    for name in available_tasks():
        try:
            task = rl.load_task(name)
            size = f"{task.states.n} × {task.actions.n}"
            about = task.description.partition("\n")[0]
            print(f"{name:<16} {size:>10}  {task.robot} in {task.scene}: {about}")
        except (ValueError, OSError) as error:  # the others are shown all the same
            print(f"{name:<16} cannot be loaded: {error}")


def make_task(name: str, robot: str) -> None:
    """Write NAME.py, a task file of your own to begin with, into this folder."""
    from rlrobot_edu.tools.new_task import new_task

    path = new_task(name, robot=robot)
    # a bare python may be one without the toolkit
    print(
        f"Written: {path}, which works as it is. Check: {sys.executable} -m rlrobot_edu check-task {path}"
    )


def look_at_task(task: str, steps: int) -> None:
    """Let a task's robot act at random, and an agent learn: what is odd about the task?"""
    from rlrobot_edu.tools.check_task import check_task

    print(check_task(task, steps=steps))


def doctor() -> None:
    """Say what is installed, what is missing, and what that disables; fails if the toolkit cannot work."""
    from rlrobot_edu.tools.doctor import examine

    diagnosis = examine()
    print(diagnosis)
    sys.exit(diagnosis.is_broken)


class Commands:
    """The commands after a program's name, and their help; `parser` reads the command line."""

    def __init__(self) -> None:
        name = "rlrobot-edu"
        if not Path(sys.argv[0]).name.startswith(name):
            name = "python -m rlrobot_edu"
        self.parser = ArgumentParser(
            name, description=ABOUT, epilog=FIRST, formatter_class=AsWritten
        )
        self.parser.add_argument(
            "--version", action="version", version=f"rlrobot-edu {__version__}"
        )
        self._commands = self.parser.add_subparsers(title="commands", metavar="COMMAND")

    def add(
        self, name: str, run: Callable[..., None], example: str = ""
    ) -> ArgumentParser:
        """A command `name` that calls `run` with its arguments; the first line of its docstring is its help."""
        about = run.__doc__
        epilog = f"Example: %(prog)s {example}"
        command = self._commands.add_parser(
            name, help=about, description=about, epilog=epilog
        )
        command.set_defaults(run=run, passes_on="")
        return command

    def check(self, given: Sequence[str]) -> None:
        """End the program if there is no command, with the help; or if it is none of these, with the nearest."""
        if not given:
            self.parser.print_help()
            self.parser.exit()
        word = given[0]
        names = list(self._commands.choices)
        if word not in names and not word.startswith("-"):
            nearest = did_you_mean(word, names)
            self.parser.error(
                f"there is no command {word!r:.200}{nearest} There are {', '.join(names)}"
            )

    def refuse(self, given: Sequence[str], unknown: Sequence[str]) -> None:
        """End the program for the words that the given command does not know, with the nearest of its options."""
        command = next(word for word in given if word in self._commands.choices)
        options = re.findall(r"--[\w-]+", self._commands.choices[command].format_help())
        nearest = did_you_mean(unknown[0], options)
        self.parser.error(
            f"{command} does not know {' '.join(unknown)}{nearest} rlrobot-edu {command} --help says what it knows"
        )


def add_commands(commands: Commands) -> None:
    """Add the library's own commands."""
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


def parse(given: Sequence[str] | None) -> tuple[Callable[..., None], dict[str, Any]]:
    """The function of the given command, and its arguments. Ends the program if there is none.

    A command whose parser sets `passes_on` gets all arguments that it does not know under that name.
    """
    commands = Commands()
    add_commands(commands)
    for package in sorted(entry_points(group=GROUP), key=lambda entry: entry.name):
        package.load()(commands)
    words = sys.argv[1:] if given is None else given
    commands.check(words)
    known, unknown = commands.parser.parse_known_args(words)
    arguments = vars(known)
    if "run" not in arguments:
        commands.parser.error(
            f"{' '.join(unknown)}: a command comes first; --help lists them"
        )
    run = arguments.pop("run")
    passes_on = arguments.pop("passes_on")
    if passes_on:
        arguments[passes_on] = unknown
    elif unknown:
        commands.refuse(words, unknown)
    return run, arguments


def main(given: Sequence[str] | None = None) -> None:
    """Run one command: the one of the command line, unless another one is `given`."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # a terminal that knows no "×" shows a question mark
        sys.stdout.reconfigure(errors="replace")
    try:
        try:
            run, arguments = parse(given)
            run(**arguments)
        finally:
            print(end="", flush=True)  # here, where it may fail
    except BrokenPipeError:  # `… | head -1` has seen enough: end without a word
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except (ValueError, OSError, ImportError) as error:  # a sentence: what to do
        sys.exit(str(error).removeprefix(f"[Errno {getattr(error, 'errno', '')}] "))
