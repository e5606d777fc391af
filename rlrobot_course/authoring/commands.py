"""What ``rlrobot-edu course …`` does: check a lesson, begin a new one, list all in docs/lessons.md, or all mistakes."""

import subprocess
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

from rlrobot_course.authoring.lists import (
    checkout,
    notebook_of,
    write_table,
)
from rlrobot_edu.checks import did_you_mean


def run(words: Sequence[str]) -> int:
    """Run the command in these words; returns the exit code. Raises ValueError if the command is unknown."""
    if list(words) == ["mistakes"]:  # the one that needs no checkout
        from rlrobot_course.authoring.catalogue import lines

        for line in lines():
            print(line)
        return 0
    root = checkout()  # first: elsewhere the rest may not even be installed
    match words:
        case ["check", number]:
            return check(root, number)
        case ["new", number, title]:
            from rlrobot_course.authoring.new_lesson import new_lesson

            print(new_lesson(root, number, title))
            return 0
        case ["table"]:
            write_table(root)
            return 0
    nearest = did_you_mean(words[0], ("check", "new", "table", "mistakes"))
    raise ValueError(
        f"there is no 'course {' '.join(words)}'{nearest} Write course check 04, course new 23 \"Title of the lesson\","
        " course table or course mistakes"
    )


def check(root: Path, number: str) -> int:
    """Run the tests of one lesson, whose names are sentences; returns pytest's exit code, 0 if all pass."""
    notebook = notebook_of(root, number)
    return subprocess.run(command_of(number, notebook), cwd=root).returncode


def command_of(number: str, notebook: Path) -> list[str]:
    """The command that tests one lesson: what stands in tests/course, and every cell of its notebook beside its output.

    Raises ValueError if what the tests need is not installed.
    """
    tools = ("pytest", "nbval", "hypothesis")
    missing = [name for name in tools if not find_spec(name)]
    if missing:
        raise ValueError(f"this needs {', '.join(missing)}: make tools installs it")
    return [
        sys.executable, "-m", "pytest", "-q", "--tb=line", "-rfE", "-p", "no:cacheprovider",
        "-k", f"lesson_{number} or {number}_ or [{number}] or [{number}-",
        "--nbval", "--nbval-current-env", "--nbval-sanitize-with", "tests/pictures.cfg",
        "tests/course", str(notebook.relative_to(checkout())),
    ]  # fmt: skip
