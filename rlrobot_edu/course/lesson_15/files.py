"""Task files to play with: a folder for them, editing by a script, and what the library says of a faulty one."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from pathlib import Path

from rlrobot_edu.course.lesson_15.solutions import follow_reward
from rlrobot_edu.environments import make_env

FOLDER = "my_tasks"  # beside the notebook


def fresh_folder(path: str | Path = f"{FOLDER}/lesson_15") -> Path:
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
            raise ValueError(f"{old!r:.100} occurs {text.count(old)} times in {path.name}, not once")
        text = text.replace(old, new)
    changed = path.with_name(to) if to else path
    changed.write_text(text, encoding="utf-8")
    return changed


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


def give_reward(path: Path) -> Path:
    """Put the lesson's reward for following a wall into a file made from the template; returns its path."""
    text = path.read_text(encoding="utf-8")
    source = inspect.getsource(follow_reward).replace("follow_reward", "reward")
    begin, end = text.index("def reward("), text.index("\n\n\ntask = Task(")
    path.write_text(text[:begin] + source.rstrip() + text[end:], encoding="utf-8")
    return edit(path, {"rewards=[-2, -0.02, 10]": "rewards=[-0.6, -0.4, 10]"})
