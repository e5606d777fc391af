"""The lists of lessons are one list; a lesson is checked and begun by a command."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from rlrobot_course.authoring import lists
from rlrobot_course.authoring.new_lesson import new_lesson, slug

ROOT = Path(__file__).parents[2]
LESSONS = list(lists.lessons(ROOT))
NOTEBOOKS = [path.stem for path in lists.lessons(ROOT).values()]
PAGE = (ROOT / "docs/lessons.md").read_text(encoding="utf-8")
FOLDERS = sorted(
    path.name.removeprefix("lesson_")
    for path in (ROOT / "rlrobot_course").glob("lesson_*")
)
SOME = (
    "docs/lite/lessons.toml",
    "tests/conftest.py",
    "tests/browser/test_browser.py",
    "docs/site/stepper_pages.py",
)
COPIED = (
    "rlrobot_edu",
    "rlrobot_ros",
    "rlrobot_grading",
    "rlrobot_course",
    "tests",
    "notebooks",
    "docs",
    "tasks",
    "studies",
)
COPIED_FILES = ("README.md", "CONTRIBUTING.md", "pyproject.toml")


def test_every_lesson_has_a_folder_and_every_folder_a_lesson():
    assert FOLDERS == LESSONS


def test_the_table_of_the_course_is_what_the_notebooks_say_of_themselves():
    assert lists.TABLE + lists.table(ROOT) + "\n" in PAGE, (
        "rlrobot-edu course table writes it anew"
    )


@pytest.mark.parametrize("number", LESSONS)
def test_the_first_cell_of_a_lesson_says_its_minutes_and_links_to_what_it_needs(number):
    lesson = lists.facts(ROOT)[number]
    first = "".join(
        json.loads(lesson.path.read_text(encoding="utf-8"))["cells"][0]["source"]
    )
    assert f"In about {lesson.minutes} minutes" in first
    assert set(re.findall(r"\((?:\.\./)?(\d\d)_\w+\.ipynb\)", first)) == set(
        lesson.needs
    )
    assert all(need < number for need in lesson.needs)


@pytest.mark.parametrize("number", LESSONS)
def test_the_minutes_of_a_lesson_are_those_of_the_rule(number):
    lesson = lists.facts(ROOT)[number]
    notebook = json.loads(lesson.path.read_text(encoding="utf-8"))
    assert lesson.minutes == lists.estimated(notebook), (
        "put this number into the notebook's metadata and its first cell"
    )


def test_no_lesson_and_no_assignment_imports_another_one():
    allowed = {
        ("lesson_10", name)
        for name in ("lesson_04", "lesson_08", "lesson_05", "lesson_09")
    }  # it joins them
    found = {
        (folder.name, name)
        for folder in (ROOT / "rlrobot_course").glob("*_*/")
        for path in folder.rglob("*.py")
        for name in re.findall(
            r"rlrobot_course\.((?:lesson|assignment)_\w+)",
            path.read_text(encoding="utf-8"),
        )
        if folder.name.startswith(("lesson_", "assignment_")) and folder.name != name
    }
    assert not found - allowed, "what lessons share is rlrobot_course's own file"


@pytest.mark.parametrize("file", SOME)
def test_what_names_some_lessons_names_none_that_is_not_there(file):
    named = set(
        re.findall(
            r"\b\d\d[a-z]?_[a-z]\w*\b", (ROOT / file).read_text(encoding="utf-8")
        )
    )
    assert named, f"{file} names no lesson: take it out of SOME"
    assert not named - set(NOTEBOOKS), (
        f"{file} names {sorted(named - set(NOTEBOOKS))}: no such notebook in notebooks/"
    )


def test_the_title_of_a_lesson_becomes_a_part_of_a_files_name():
    assert slug("SARSA(λ), écrit") == "sarsa_ecrit"


@pytest.mark.parametrize(("number", "title", "told"), [
    ("4", "x", "two digits"), ("06", "x", "already"), ("99", "?", "some words"), ("99", "a | b", "some words"),
    ("04b", "x", "two digits"),
    ("../23", "x", "two digits"),
])  # fmt: skip
def test_a_lesson_that_cannot_be_is_refused_before_anything_is_written(
    number, title, told
):
    with pytest.raises(ValueError, match=told):
        new_lesson(ROOT, number, title)
    assert list(lists.lessons(ROOT)) == LESSONS


def run(root: Path, *words: str) -> subprocess.CompletedProcess:
    """The command `course …` in a checkout."""
    command = [sys.executable, "-m", "rlrobot_edu", "course", *words]
    around = os.environ | {"PYTHONPATH": str(root), "PYTHONIOENCODING": "utf-8"}
    return subprocess.run(
        command,
        cwd=root,
        env=around,
        capture_output=True,
        encoding="utf-8",
        timeout=600,
    )


@pytest.mark.parametrize(("words", "told"), [
    (["check", "4"], "there is no lesson '4'"), (["chek", "06"], "Write course check 04"),
    (["new", "06", "x"], "there is a lesson 06 already"),
])  # fmt: skip
def test_a_wrong_word_after_course_is_told_in_a_sentence(words, told):
    done = run(ROOT, *words)
    assert (
        done.returncode == 1 and told in done.stderr and "Traceback" not in done.stderr
    )


@pytest.mark.long
def test_a_new_lesson_passes_its_checks_and_a_broken_solution_does_not(tmp_path):
    for name in COPIED:
        shutil.copytree(
            ROOT / name,
            tmp_path / name,
            ignore=shutil.ignore_patterns("__pycache__", "_build"),
        )
    for name in COPIED_FILES:
        shutil.copy(ROOT / name, tmp_path)
    (tmp_path / "datasets").symlink_to(ROOT / "datasets")

    written = run(tmp_path, "new", "23", "What is next?")
    assert written.returncode == 0, written.stderr
    assert "Left to you: in the notebook's metadata" in written.stdout
    done = run(tmp_path, "check", "23")
    assert done.returncode == 0, done.stdout + done.stderr

    exercise = tmp_path / "rlrobot_course/lesson_23/exercises.py"
    right = exercise.read_text(encoding="utf-8")
    exercise.write_text(
        right.replace("(n + 1)\n", "(n + 1) * 1.1\n", 1), encoding="utf-8"
    )
    done = run(tmp_path, "check", "23")
    assert done.returncode == 1
    assert "test_the_solution_is_right[lesson_23-running_mean]" in done.stdout
