"""The learner's task file and the learner's rows, kept beside the lessons in `my_robot/`."""

from pathlib import Path
from typing import Any

from rlrobot_course.learner.learners_files import beside_the_lessons
from rlrobot_edu import Agent, Recording, make_env, read_recording, record
from rlrobot_edu.files import write_whole
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.widgets.driving.pad import Pad

FOLDER = "my_robot"
ENOUGH = 100  # steps on the pad that make a recording
STAND_IN = 600  # steps of the stand-in
RANDOM = "Q+RANDOM"  # how the stand-in drives
BY_HAND = "by hand"  # as the pad says of itself


def my_robot(folder: str | Path = FOLDER) -> Path:
    """The learner's task file. It is written where it is missing, and never overwritten."""
    path = beside_the_lessons(folder) / "my_robot.py"
    if not path.exists():
        given = Path(__file__).with_name("my_robot.txt")
        write_whole(path, given.read_bytes())
    return path


def my_rows(
    robot: str | Path | Task, given: Any = None, folder: str | Path = FOLDER
) -> Recording:
    """The learner's rows of a task, or a stand-in's; says in a line whose they are.

    robot: the task, see `my_robot`
    given: a pad on which the learner has driven; or a CSV file, a data frame or rows, as `Recording.from_rows` takes
        them; or a recording. These are kept in the folder. Without any, those kept before are taken, and without
        those a stand-in's.

    Raises ValueError in a sentence for rows that cannot be of this task; then what was kept stays as it is.
    """
    task = load_task(robot)
    place = beside_the_lessons(folder) / "rows"
    if isinstance(given, Pad) and len(given) < ENOUGH:
        if len(given):
            print(f"You drove {len(given)} steps; {ENOUGH} are needed.", end=" ")
        given = None
    if given is not None:
        rows = _recording(given, task)
        rows.save(place)
        print(f"These rows are yours: {len(rows)} steps, kept in {folder}/rows.")
        return rows
    kept = _kept(place, task)
    if kept is not None:
        print(f"These rows are yours: {len(kept)} steps, from {folder}/rows.")
        return kept
    print(f"These {STAND_IN} rows are not yours: a stand-in drove at random.")
    return record(Agent(task, RANDOM, seed=0), make_env(task, seed=0), steps=STAND_IN)


def whose(rows: Recording) -> str:
    """Who recorded them, as a part of a sentence."""
    if rows.source.method == BY_HAND:
        return f"{len(rows)} steps that you drove"
    if rows.source.method == RANDOM:
        return f"{len(rows)} steps of a stand-in that drove at random"
    return f"{len(rows)} rows that you gave"


def pressed_again(rows: Recording, task: str | Task) -> Pad:
    """A pad on which the same buttons were pressed once more, in the simulator, where nothing is left to chance.

    So rows driven by hand stay of use if the learner changes what the task senses or pays.
    """
    with make_env(task, seed=0) as env:
        pad = Pad(env)
        for a, truncated in zip(rows.a.tolist(), rows.truncated.tolist(), strict=True):
            pad.press(a)
            if truncated:
                pad.start_again()
    return pad


def _recording(given: Any, task: Task) -> Recording:
    if isinstance(given, Pad):
        return given.recording
    if isinstance(given, str | Path):
        return read_recording(given, task=task)
    if isinstance(given, Recording):
        its, wanted = given.source, Source.of_task(task)
        if (its.states, its.actions) != (wanted.states, wanted.actions):
            raise ValueError(
                f"this recording is of {its.task_name}, not of your task {task.name}: it has other states or actions"
            )
        return Recording(given.transitions, its, task)
    return Recording.from_rows(given, task)


def _kept(place: Path, task: Task) -> Recording | None:
    """The rows kept before, as rows of this task; None if there are none of it, and a sentence if there are others."""
    if not place.exists():
        return None
    try:
        rows = Recording.load(place)
        if rows.source.method != BY_HAND:
            return Recording.load(place, task=task)
    except (ValueError, FileNotFoundError) as error:
        print(f"Your rows are left aside: {error}.")
        return None
    if rows.source.actions != Source.of_task(task).actions:
        print("Your rows are left aside: your task has other actions now. Drive again.")
        return None
    return pressed_again(rows, task).recording
