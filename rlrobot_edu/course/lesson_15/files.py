"""Task files to play with: a folder for them, and sound or odd ones made of the template."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from rlrobot_edu.task.task_file import load_task

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
    """Change a text file as an editor does; returns its path.

    changes: old text -> new text; to: name of the file that takes the result; empty for the same file
    Raises ValueError if a text to be changed does not occur in the file exactly once.
    """
    text = path.read_text(encoding="utf-8")
    for old, new in changes.items():
        if text.count(old) != 1:
            raise ValueError(f"{old!r:.100} occurs {text.count(old)} times in {path.name}, not once")
        text = text.replace(old, new)
    changed = path.with_name(to) if to else path
    changed.write_text(text, encoding="utf-8")
    return changed


def what_is_wrong(path: Path) -> str:
    """What the library says of a file that it refuses, with the file's name in place of its path; empty for a good one.

    A fault that shows only while the robot acts is found by `make_env`, or by the first step that meets it.
    """
    try:
        load_task(path)
    except (ValueError, OSError) as error:
        return str(error).replace(str(path), path.name)
    return ""
