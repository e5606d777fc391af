"""The commands of the course: ``lab``, ``fresh``, ``progress``, ``hand-out``, ``grade``, ``course``, ``compile``."""

import subprocess
import sys

from rlrobot_edu.tools.commands import Commands
from rlrobot_grading.marking.options import add_options

METHODS = (
    "TOSL+QBIASSR",
    "TOSL+SR",
    "SARSA+SR",
    "Q+SR",
    "Q+EG",
)  # that the lessons run


def open_lab(more: list[str]) -> None:
    """Open the course in JupyterLab, as copies in my_course/ that are yours; further arguments go to JupyterLab."""
    from rlrobot_course.learner.my_course import open_lab

    compiling = [
        sys.executable,
        "-m",
        "rlrobot_edu",
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


def grade_notebooks(**arguments: object) -> None:
    """Grade notebooks that were handed in; exit code 0 if all have all points. See docs/grading.md."""
    from rlrobot_course.homework import COURSE
    from rlrobot_grading.marking.grade import run

    run(COURSE, **arguments)  # type: ignore[arg-type]


def hand_out_notebooks(
    students: str, notebooks: list[str], to: str, hints: int | None
) -> None:
    """Write a notebook of their own for each student of a list, and its solutions. See docs/grading.md."""
    from rlrobot_course.homework.hand_out import hand_out

    try:
        n = hand_out(students, notebooks, to, hints)
    except (OSError, ValueError) as error:
        sys.exit(str(error))
    print(f"{to}: students/ holds what each of {n} gets, solutions/ is for you alone.")


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


def add_commands(commands: Commands) -> None:
    """Add the commands of the course."""
    add = commands.add
    lab = add("lab", open_lab, "--no-browser")
    lab.set_defaults(passes_on="more")  # JupyterLab knows more options
    add("fresh", freshen, "02").add_argument(
        "lesson", nargs="+", help="its number, as 02; or as in homework 1"
    )
    add("progress", show_progress, "my_course").add_argument(
        "folder", nargs="?", help="my_course/ if not given"
    )
    add_options(add("grade", grade_notebooks, "handed_in --container rlrobot-edu"))
    handing_out = add("hand-out", hand_out_notebooks, "students.csv --to handed_out")
    handing_out.add_argument("students", help="list of students, CSV with a column id")
    handing_out.add_argument(
        "notebooks", nargs="*", help="notebooks with exercises, all assignments if none"
    )
    handing_out.add_argument("--to", default="handed_out", help="a folder")
    handing_out.add_argument(
        "--hints", type=int, choices=range(4), help="that an exercise shows, all"
    )
    add("course", write_lessons, "check 04").add_argument(
        "words",
        nargs="+",
        help='check 04, new 23 "Title", table, or mistakes',
    )
    add("compile", compile_kernels)
