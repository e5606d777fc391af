"""Task files to play with: a folder for them, editing by a script, and what the library says of a faulty one."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rlrobot_edu import make_env
from rlrobot_edu.tools.new_task import new_task

FOLDER = "my_tasks"  # beside the notebook


def fresh_folder(path: str | Path = f"{FOLDER}/lesson_16") -> Path:
    """An empty folder for this lesson's files; those of an earlier run go to ``before`` in it, so they are not lost."""
    folder = Path(path)
    folder.mkdir(parents=True, exist_ok=True)
    for old in sorted(folder.glob("*.py")):
        (folder / "before").mkdir(exist_ok=True)
        old.replace(folder / "before" / old.name)
    return folder


def edit(path: Path, changes: Mapping[str, str], to: str = "") -> Path:
    """Change a text file as you would in an editor; returns the changed file.

    changes: old text -> new text; to: name of the file that takes the result; empty for the same file
    Raises ValueError if an old text does not occur exactly once.
    """
    text = path.read_text(encoding="utf-8")
    for old, new in changes.items():
        if text.count(old) != 1:
            raise ValueError(
                f"{old!r:.100} occurs {text.count(old)} times in {path.name}, not once"
            )
        text = text.replace(old, new)
    changed = path.with_name(to) if to else path
    changed.write_text(text, encoding="utf-8")
    return changed


def marked(env: Any) -> Any:
    """The same environment, whose pictures mark where to park: a circle of 0.25 m."""
    robot = env.unwrapped.robot
    robot.arena = robot.arena._replace(goal=(0.5, -0.5, 0.25))
    return env


def refusal(path: Path) -> str:
    """The sentence with which the library refuses a task file, its path shortened to its name; empty for a sound one.

    The file is read, its environment is made, and each action is done once.
    """
    try:
        with make_env(path, seed=0) as env:
            env.reset()
            for a in range(int(getattr(env.action_space, "n", 0))):
                env.step(a)
    except (ValueError, OSError) as error:
        return str(error).replace(str(path), path.name)
    return ""


def faulty_files(folder: Path) -> dict[str, Path]:
    """The files A, B and C, made from the template, each with one fault that no gate refuses."""
    template = new_task("wander", folder)
    command = "def command(wheels):\n    return {**wheels, 'left_wheel': 0.0}\n\n\ntask = Task(\n    command=command,"
    return {
        "A": edit(template, {"0.07 else": "7 else"}, to="a.py"),
        "B": edit(
            template,
            {'"laser_front_left", cuts=[0.20]': '"laser_front_left", cuts=[4.5]'},
            to="b.py",
        ),
        "C": edit(template, {"task = Task(": command}, to="c.py"),
    }
