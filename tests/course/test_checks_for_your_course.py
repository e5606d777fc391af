"""The page *Checks for your own course* works from an empty folder, where no other package of ours can be imported."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs/howto/checks_for_your_course.md"
TEXT = PAGE.read_text(encoding="utf-8")
CHECKS, ANSWER, EXERCISES, GRADING = re.findall(r"```python\n(.*?)```", TEXT, re.S)
SAID = re.search(r"```text\n(.*?)```", TEXT, re.S)[1]
# also in the processes that are started: Python imports this before anything else
ALONE = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("rlrobot_edu", "rlrobot_course", "rlrobot_ros"):
            raise ImportError(f"{name} is not to be imported")
sys.meta_path.insert(0, Absent())
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "sitecustomize.py").write_text(ALONE, encoding="utf-8")
    (tmp_path / "my_checks.py").write_text(CHECKS, encoding="utf-8")
    return tmp_path


def run(folder, program):
    """What a program says in the folder."""
    (folder / "program.py").write_text(program, encoding="utf-8")
    env = os.environ | {"PYTHONPATH": f"{folder}{os.pathsep}{ROOT}"}
    command = [sys.executable, "-X", "utf8", "program.py"]
    done = subprocess.run(
        command, cwd=folder, env=env, capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_an_exercise_of_thirty_lines_says_what_the_page_says(folder):
    assert len([line for line in CHECKS.splitlines() if line]) <= 32
    loaded = "\nimport sys\nprint(sorted({m.partition('.')[0] for m in sys.modules} & {'numpy', 'numba', 'scipy'}))"
    assert run(folder, ANSWER + loaded) == SAID + "['numpy']\n"


def test_the_library_cannot_be_imported_there(folder):
    blocked = "try:\n    import rlrobot_edu\nexcept ImportError as e:\n    print(e)"
    assert run(folder, blocked) == "rlrobot_edu is not to be imported\n"


@pytest.mark.long
def test_notebooks_are_marked_there(folder):
    lesson = folder / "my_statistics/lesson_01"
    lesson.mkdir(parents=True)
    (lesson.parent / "__init__.py").touch()
    line = re.search(r"`(from my_statistics\.lesson_01\.exercises import check)`", TEXT)
    (lesson / "__init__.py").write_text(line[1], encoding="utf-8")
    (lesson / "exercises.py").write_text(EXERCISES, encoding="utf-8")
    (folder / "handed_in").mkdir()
    for name, answer in (
        ("anna", "sorted(numbers)[len(numbers) // 2]"),
        ("ben", "__import__('statistics').median(numbers)"),
    ):
        cells = [
            "from my_statistics.lesson_01 import check",
            f"def median(numbers):\n    return {answer}\n\ncheck.median(median)",
        ]
        notebook = {"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": []}
        for i, source in enumerate(cells):
            notebook["cells"].append(
                {"cell_type": "code", "id": f"c{i}", "metadata": {}, "source": source}
                | {"outputs": [], "execution_count": None}
            )
        (folder / f"handed_in/{name}.ipynb").write_text(json.dumps(notebook))
    said = run(folder, GRADING)
    assert "anna.ipynb: 0 of 1 points" in said and "take their mean" in said
    assert "ben.ipynb: 1 of 1 points" in said
    assert (folder / "points.csv").is_file()
