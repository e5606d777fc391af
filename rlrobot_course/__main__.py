"""The commands of the course, and the library's: ``rlrobot-edu``, or ``python -m rlrobot_course``."""

import subprocess
import sys
from collections.abc import Callable, Sequence
from typing import Any

from rlrobot_edu.__main__ import Commands, library_commands, run_command
from rlrobot_grading.marking.options import add_options

ABOUT = "Learn tabular reinforcement learning on simulated robots: a course of notebooks, and the library below it."
FIRST = """begin with:
  %(prog)s doctor                   is everything here?
  %(prog)s lab                      open the course
  %(prog)s check-task wander_1k     what a task's robot senses, does and is paid for

%(prog)s COMMAND --help says more about a command, with an example."""
METHODS = (
    "TOSL+QBIASSR",
    "TOSL+SR",
    "SARSA+SR",
    "Q+SR",
    "Q+EG",
)  # that the lessons run
SECRET = "of a robot that nobody has seen: file:PATH, env:NAME or, for all to see, itself; see docs/unknown_robot.md"


def open_lab(more: list[str]) -> None:
    """Open the course in JupyterLab, as copies in my_course/ that are yours; further arguments go to JupyterLab."""
    from rlrobot_course.learner.my_course import open_lab

    compiling = [
        sys.executable,
        "-m",
        "rlrobot_course",
        "compile",
    ]  # while JupyterLab starts
    compiler = subprocess.Popen(
        compiling, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    try:
        sys.exit(open_lab(more))
    finally:
        compiler.terminate()  # nobody waits for it once JupyterLab has ended, or did not begin


def freshen(lesson: list[str]) -> None:
    """Set your copy of one lesson back, or of an assignment; the old one is kept in my_course/old/."""
    from rlrobot_course.learner.my_course import set_back

    print(set_back(" ".join(lesson)))


def show_progress(folder: str) -> None:
    """Say how far you are: which functions in my_functions.py are right, and what is next."""
    from rlrobot_course.learner.progress import show

    show(folder)


def serve_robot(secret: str, **arguments: Any) -> None:
    """Let a simulated robot speak ROS, as a real one would, until Ctrl-C; to rehearse with rl.RobotLink."""
    from rlrobot_course.unknown_robot.commands import serve

    serve(secret=secret, **arguments)


def tell_score(log: str, secret: str) -> None:
    """Say what the drive of a secret robot was worth, from the log that serve-robot --secret has written."""
    from rlrobot_course.unknown_robot.commands import tell_score

    tell_score(log, secret)


def grade_notebooks(**arguments: object) -> None:
    """Grade notebooks that were handed in; exit code 0 if all have all points. See docs/grading.md."""
    from rlrobot_grading.marking.grade import run

    run(arguments)


def write_lessons(words: list[str]) -> None:
    """For those who write lessons: check one, or begin a new one that passes its checks."""
    from rlrobot_course.authoring.commands import run

    sys.exit(run(words))


def compile_kernels() -> None:
    """Compile the usual methods, where they are not in the cache yet, so that the lessons start at once."""
    import rlrobot_edu as rl

    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    for method in METHODS:
        for world in ("worked_example", model):
            rl.learn(
                rl.Agent(world, method), rl.make_env(world), steps=1, progress=False
            )
    print("The learning kernels are compiled.")


def parse(given: Sequence[str] | None) -> tuple[Callable[..., None], dict[str, Any]]:
    """The function of the command that is given, and its arguments. Ends the program where there is no such command."""
    commands = Commands(ABOUT, FIRST)
    add = commands.add
    add("lab", open_lab, "--no-browser")
    add("fresh", freshen, "02").add_argument(
        "lesson", nargs="+", help="its number, as 02; or as in homework 1"
    )
    add("progress", show_progress, "my_course").add_argument(
        "folder", nargs="?", help="my_course/ if not given"
    )
    library_commands(commands, serve_robot).add_argument(
        "--secret", default="", help=SECRET
    )
    command = add("score", tell_score, "drive.npz --secret file:secret.txt")
    command.add_argument("log", help="what serve-robot --secret has written")
    command.add_argument("--secret", required=True, help=SECRET)
    add_options(add("grade", grade_notebooks, "handed_in/*.ipynb --csv points.csv"))
    add("course", write_lessons, "check 04").add_argument(
        "words",
        nargs="+",
        help='check 04, new 18 "Title", or explain 02 update answer.py',
    )
    add("compile", compile_kernels)

    known, more = commands.parser.parse_known_args(given)
    run = vars(known).pop("run")
    if run is open_lab:
        return run, {
            "more": more
        }  # argparse would keep no option that it does not know for JupyterLab
    if more:
        commands.parser.error(f"unrecognized arguments: {' '.join(more)}")
    return run, vars(known)


def main(given: Sequence[str] | None = None) -> None:
    """Run one command: the one of the command line, unless another one is `given`."""
    run_command(parse, given)


if __name__ == "__main__":
    main()
