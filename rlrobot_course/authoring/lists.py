"""The lessons are the notebooks in `notebooks/`; other files repeat that list, and a test checks that they agree."""

import os
from pathlib import Path

import rlrobot_course


def checkout() -> Path:
    """The folder of the project. Raises ValueError where the package is installed without it."""
    root = Path(rlrobot_course.__file__).parents[1]
    if not (root / "tests/course").is_dir():
        raise ValueError(f"lessons are written in a clone of the project, with notebooks/ and tests/, not in {root}")
    return root


def surroundings(root: Path) -> dict[str, str]:
    """The environment of a process that we start: it imports this checkout before any other one."""
    paths = [str(root), *filter(None, [os.environ.get("PYTHONPATH")])]
    return os.environ | {"PYTHONPATH": os.pathsep.join(paths)}


def lessons(root: Path) -> dict[str, Path]:
    """The notebook of each lesson, by its number as in 04, in the order of the course; those in `more/` come last."""
    paths = [*sorted(root.glob("notebooks/*.ipynb")), *sorted(root.glob("notebooks/more/*.ipynb"))]
    return {path.name.partition("_")[0]: path for path in paths}


def notebook_of(root: Path, number: str) -> Path:
    """The notebook of one lesson. Raises ValueError if there is none; the message lists the lessons."""
    known = lessons(root)
    if number not in known:
        raise ValueError(f"there is no lesson {number!r} in notebooks/; the lessons are {', '.join(known)}")
    return known[number]
