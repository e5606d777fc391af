"""A plugin of pytest: ``-p rlrobot_course.authoring.one_lesson --lesson 06`` keeps the tests of one lesson.

A test belongs to a lesson if it has the lesson's number, folder or notebook among its parameters, or stands in its
notebook or in a file named after its folder.
"""

from pathlib import Path
from typing import Any


def pytest_addoption(parser: Any) -> None:
    """The number of the lesson."""
    parser.addoption(
        "--lesson", required=True, help="only the tests of this lesson, as in 04"
    )


def pytest_collection_modifyitems(config: Any, items: list[Any]) -> None:
    """Leave out the tests of other lessons, or of none."""
    number = config.getoption("--lesson")
    kept = [item for item in items if belongs(item.path, parameters_of(item), number)]
    config.hook.pytest_deselected(items=[item for item in items if item not in kept])
    items[:] = kept


def parameters_of(item: Any) -> list[Any]:
    """What a test is given."""
    return list(item.callspec.params.values()) if hasattr(item, "callspec") else []


def belongs(file: Path, parameters: list[Any], number: str) -> bool:
    """Whether a test in this file, with these parameters, is one of a lesson."""
    if file.name.startswith((f"test_lesson_{number}_", f"{number}_")):
        return True
    words = [thing for thing in parameters if isinstance(thing, str)]
    return any(
        word in (number, f"lesson_{number}") or word.startswith(_notebooks(number))
        for word in words
    )


def _notebooks(number: str) -> tuple[str, ...]:
    """How the path of a lesson's notebook may begin."""
    return f"notebooks/{number}_", f"notebooks/more/{number}_"
