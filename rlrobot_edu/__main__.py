"""``python -m rlrobot_edu``: ``lab`` opens the course, ``fresh`` sets a lesson back, ``tasks`` lists the robots' tasks,
``new-task`` writes a task file of your own, ``check-task`` looks at it, ``serve-robot`` lets a simulated robot speak
ROS, ``grade`` grades notebooks that were handed in, ``compile`` compiles the kernels, ``reproduce`` runs the paper.
"""

import argparse
import contextlib
import io
import signal
import sys

import rlrobot_edu as rl
from rlrobot_edu.course.homework.options import add_options


def open_lab(more: list[str]) -> None:
    """Open the course in JupyterLab, as copies in my_course/ that are yours; further arguments go to JupyterLab."""
    from rlrobot_edu.course.my_course import open_lab

    sys.exit(open_lab(more))


def freshen(lesson: str) -> None:
    """Set your copy of one lesson back, as 02; the old one is kept in my_course/old/."""
    from rlrobot_edu.course.my_course import set_back

    print(set_back(lesson))


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


def make_task(name: str) -> None:
    """Write NAME.py, a task file of your own to begin with, into this folder."""
    path = rl.new_task(name)
    print(f"Written: {path}. It works as it stands; change it, and look: python -m rlrobot_edu check-task {path}")


def look_at_task(task: str, steps: int) -> None:
    """Let a task's robot act at random, and an agent learn: what is odd? TASK is a name or your own file."""
    print(rl.check_task(task, steps=steps))


def serve_robot(task: str, link: str, port: int, simulated_time: bool) -> None:
    """Let a task's robot speak ROS, as a real one would, until Ctrl-C; to rehearse with rl.RobotLink."""
    where = {"port": port} if link == "rosbridge" else {}
    with rl.ServedRobot(task, link, simulated_time=simulated_time, **where) as robot:
        print(
            f"The robot of {task} is on: odom, laser_scan and cmd_vel over {robot.way}. End it with Ctrl-C.", flush=True
        )
        with contextlib.suppress(KeyboardInterrupt):
            robot.wait()


def grade_notebooks(**arguments: object) -> None:
    """Grade notebooks that were handed in; exit code 0 if all have all points. See docs/grading.md."""
    from rlrobot_edu.course.homework.grade import run

    run(arguments)


def compile_kernels() -> None:
    """Compile what is not in the cache yet, so that the first lesson starts at once."""
    model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
    for planner in (None, "dyna"):
        for world in ("worked_example", model):
            rl.learn(rl.Agent(world, planner=planner), rl.make_env(world), steps=1, progress=False)
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
    command = commands.add_parser("lab", help=open_lab.__doc__)
    command.add_argument("more", nargs=argparse.REMAINDER, help="arguments for JupyterLab")
    command.set_defaults(run=open_lab)
    command = commands.add_parser("fresh", help=freshen.__doc__)
    command.add_argument("lesson", help="its number, as in 02")
    command.set_defaults(run=freshen)
    commands.add_parser("tasks", help=list_tasks.__doc__).set_defaults(run=list_tasks)
    command = commands.add_parser("new-task", help=make_task.__doc__)
    command.add_argument("name", help="of the task, as in follow_wall")
    command.set_defaults(run=make_task)
    command = commands.add_parser("check-task", help=look_at_task.__doc__)
    command.add_argument("task", help="name of a task, or path of a task file")
    command.add_argument("--steps", type=int, default=2000, help="length of each trial, 2000 if not given")
    command.set_defaults(run=look_at_task)
    command = commands.add_parser("serve-robot", help=serve_robot.__doc__)
    command.add_argument("task", nargs="?", default="giraff_wander_simple", help="giraff_wander_simple if not given")
    command.add_argument("--link", default="rosbridge", help="rosbridge (if not given), dds or rospy")
    command.add_argument("--port", type=int, default=9090, help="of rosbridge, 9090 if not given")
    command.add_argument("--simulated-time", action="store_true", help="time passes only as commands come")
    command.set_defaults(run=serve_robot)
    command = commands.add_parser("grade", help=grade_notebooks.__doc__)
    add_options(command)
    command.set_defaults(run=grade_notebooks)
    commands.add_parser("compile", help=compile_kernels.__doc__).set_defaults(run=compile_kernels)
    command = commands.add_parser("reproduce", help=reproduce.__doc__)
    command.add_argument("--quick", action="store_true", help="few repetitions, into docs/reproduction/quick/")
    command.set_defaults(run=reproduce)
    arguments = vars(parser.parse_args())
    try:
        arguments.pop("run")(**arguments)
    except (ValueError, OSError, ImportError) as error:  # one sentence that says what to do
        sys.exit(str(error))
