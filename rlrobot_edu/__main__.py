"""The commands of the toolkit: ``python -m rlrobot_edu``, or ``rlrobot-edu`` where it is installed."""

import io
import os
import sys
from argparse import ArgumentParser, RawDescriptionHelpFormatter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import rlrobot_edu as rl

ABOUT = "Learn tabular reinforcement learning on simulated robots: a course of notebooks, and the library below it."
FIRST = """begin with:
  %(prog)s doctor                   is everything here?
  %(prog)s lab                      open the course
  %(prog)s check-task wander_1k     what a task's robot senses, does and is paid for

%(prog)s COMMAND --help says more about a command, with an example."""


def open_lab(more: list[str]) -> None:
    """Open the course in JupyterLab, as copies in my_course/ that are yours; further arguments go to JupyterLab."""
    from rlrobot_course.my_course import open_lab

    sys.exit(open_lab(more))


def freshen(lesson: list[str]) -> None:
    """Set your copy of one lesson back, or of an assignment; the old one is kept in my_course/old/."""
    from rlrobot_course.my_course import set_back

    print(set_back(" ".join(lesson)))


def show_progress(folder: str) -> None:
    """Say how far you are: which functions in my_functions.py are right, what is next; progress.html says it, too."""
    from rlrobot_course.progress import show

    show(folder)


def list_tasks() -> None:
    """List the robots' tasks: name, states × actions, robot and scene, and what it is about."""
    for name in rl.available_tasks():
        try:
            task = rl.load_task(name)
            size, about = f"{task.states.n} × {task.actions.n}", task.description.partition("\n")[0]
            print(f"{name:<16} {size:>10}  {task.robot} in {task.scene}: {about}")
        except (ValueError, OSError) as error:  # the others are to be seen all the same
            print(f"{name:<16} cannot be loaded: {error}")


def make_task(name: str, robot: str) -> None:
    """Write NAME.py, a task file of your own to begin with, into this folder."""
    path = rl.new_task(name, robot=robot)
    # a bare python may be one without the toolkit
    print(f"Written: {path}. It works as it stands. To check it: {sys.executable} -m rlrobot_edu check-task {path}")


def look_at_task(task: str, steps: int) -> None:
    """Let a task's robot act at random, and an agent learn: what is odd about the task?"""
    print(rl.check_task(task, steps=steps))


def serve_robot(**arguments: Any) -> None:
    """Let a simulated robot speak ROS, as a real one would, until Ctrl-C; to rehearse with rl.RobotLink."""
    from rlrobot_course.unknown_robot.commands import serve

    serve(**arguments)


def tell_score(log: str, secret: str) -> None:
    """Say what the drive of a secret robot was worth, from the log that serve-robot --secret has written."""
    from rlrobot_course.unknown_robot.commands import tell_score

    tell_score(log, secret)


def doctor() -> None:
    """Say what is installed, what is missing, and what that disables; fails if the toolkit cannot work."""
    from rlrobot_edu.tools.doctor import examine

    print(diagnosis := examine())
    sys.exit(diagnosis.is_broken)


def grade_notebooks(**arguments: object) -> None:
    """Grade notebooks that were handed in; exit code 0 if all have all points. See docs/grading.md."""
    from rlrobot_course.homework.grade import run

    run(arguments)


def write_lessons(words: list[str]) -> None:
    """For those who write lessons: check one, or begin a new one that passes its checks."""
    from rlrobot_course.authoring.commands import run

    sys.exit(run(words))


def compile_kernels() -> None:
    """Compile the usual methods, where they are not in the cache yet, so that the lessons start at once."""
    from rlrobot_course.compile_ahead import compile_ahead

    compile_ahead()


def reproduce(quick: bool, engine: str) -> None:
    """Run the paper's experiments and write docs/reproduction/."""
    from paper.run import reproduce

    reproduce(quick, engine=engine)


SECRET = "of a robot that nobody has seen: file:PATH, env:NAME or, for all to see, itself; see docs/unknown_robot.md"


def make_parser() -> ArgumentParser:
    """What can be typed, and what --help says about it."""
    from rlrobot_course.homework.options import add_options

    name = "rlrobot-edu" if Path(sys.argv[0]).name.startswith("rlrobot-edu") else "python -m rlrobot_edu"
    parser = ArgumentParser(name, description=ABOUT, epilog=FIRST, formatter_class=RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True, title="commands", metavar="COMMAND")

    def add(name: str, run: Callable[..., None], eg: str = "") -> ArgumentParser:
        command = commands.add_parser(name, help=run.__doc__, description=run.__doc__, epilog=f"Example: %(prog)s {eg}")
        command.set_defaults(run=run)
        return command

    add("lab", open_lab, "--no-browser")
    add("fresh", freshen, "02").add_argument("lesson", nargs="+", help="its number, as 02; or as in homework 1")
    add("progress", show_progress, "my_course").add_argument("folder", nargs="?", help="my_course/ if not given")
    add("doctor", doctor)
    add("tasks", list_tasks)
    command = add("new-task", make_task, "reach --robot arm")
    command.add_argument("name", help="of the task, as in follow_wall")
    command.add_argument("--robot", default="mobile_base", help="as arm or giraff; mobile_base if not given")
    command = add("check-task", look_at_task, "follow_wall.py --steps 500")
    command.add_argument("task", help="name of a task, or path of a task file")
    command.add_argument("--steps", type=int, default=2000, help="length of each trial, 2000 if not given")
    command = add("serve-robot", serve_robot, "giraff_wander_1k --port 9091")
    command.add_argument("task", nargs="?", default="giraff_wander_simple", help="giraff_wander_simple if not given")
    command.add_argument("--link", default="rosbridge", help="rosbridge (if not given), dds or rospy")
    command.add_argument("--port", type=int, default=9090, help="of rosbridge, 9090 if not given")
    command.add_argument("--simulated-time", action="store_true", help="time passes only as commands come")
    command.add_argument("--secret", default="", help=SECRET)
    command = add("score", tell_score, "drive.npz --secret file:secret.txt")
    command.add_argument("log", help="what serve-robot --secret has written")
    command.add_argument("--secret", required=True, help=SECRET)
    add_options(add("grade", grade_notebooks, "handed_in/*.ipynb --csv points.csv"))
    add("course", write_lessons, "check 04").add_argument("words", nargs="+", help='check 04, or new 18 "Title"')
    add("compile", compile_kernels)
    command = add("reproduce", reproduce, "--quick")
    command.add_argument("--quick", action="store_true", help="few repetitions, into docs/reproduction/quick/")
    command.add_argument("--engine", default="", help="of the robots, as kinematic; into a folder of its own")
    return parser


def parse(given: Sequence[str] | None) -> tuple[Callable[..., None], dict[str, Any]]:
    """The function of the command that is given, and its arguments. Ends the program where there is no such command."""
    parser = make_parser()
    known, more = parser.parse_known_args(given)
    run = vars(known).pop("run")
    if run is open_lab:
        return run, {"more": more}  # argparse would keep no option that it does not know for JupyterLab
    if more:
        parser.error(f"unrecognized arguments: {' '.join(more)}")
    return run, vars(known)


def main(given: Sequence[str] | None = None) -> None:
    """Run one command: the one of the command line, unless another one is `given`."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # a terminal that knows no "×" shows a question mark
    try:
        try:
            run, arguments = parse(given)
            run(**arguments)
        finally:
            print(end="", flush=True)  # here, where it may fail
    except BrokenPipeError:  # `… | head -1` has seen enough: end without a word
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except (ValueError, OSError, ImportError) as error:  # one sentence that says what to do
        sys.exit(str(error))


if __name__ == "__main__":
    main()
