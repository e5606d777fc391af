"""The plans of docs/teaching.md: each lesson after those that it needs, and the minutes are the lessons' own."""

import json
import re
from pathlib import Path

import pytest

from rlrobot_course.authoring.lists import lessons

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "teaching.md").read_text(encoding="utf-8")
PLANS = dict(re.findall(r"^### (\w+ weeks): .*?\n(.*?)(?=\n###|\nThe plan)", PAGE, re.DOTALL | re.MULTILINE))
COURSE = (ROOT / "README.md").read_text(encoding="utf-8")
MINUTES = {n: int(told) for n, told in re.findall(r"^\| \[(\d\d[ab]?) .*?\| (\d+) \|$", COURSE, re.MULTILINE)}
OPTIONAL = set(re.findall(r"^\| \[(\d\d[ab]?) [^|]*, optional \|", COURSE, re.MULTILINE))
HELPFUL = {"07a", "05a"}  # lesson 09 says of them that they help; it can be read without
ASSIGNMENT = 70
ROW = re.compile(r"^\| (\d+) \| (.*?) \| (\d?) \| (\d+) \|$", re.MULTILINE)


def needs(number: str) -> set[str]:
    """The lessons before it that the beginning of a lesson names."""
    path = lessons(ROOT)[number]
    first = "".join(json.loads(path.read_text(encoding="utf-8"))["cells"][0]["source"])
    return set(re.findall(r"\((\d\d[ab]?)_\w+\.ipynb\)", first)) - HELPFUL


@pytest.mark.parametrize("name", PLANS)
def test_a_plan_is_in_an_order_that_can_be_taught(name):
    rows = re.findall(ROW, PLANS[name])
    assert [int(week) for week, *_ in rows] == list(range(1, len(rows) + 1))
    done: set[str] = set()
    for _, read, assignment, minutes in rows:
        numbers = read.split(", ")
        assert int(minutes) == sum(MINUTES[n] for n in numbers) + ASSIGNMENT * bool(assignment)
        for number in numbers:
            assert needs(number) <= done, f"{number} needs {needs(number) - done}"
            done.add(number)


def test_there_are_plans_and_the_longest_has_every_lesson_that_is_not_optional():
    assert list(PLANS) == ["Six weeks", "Ten weeks", "Fourteen weeks"]
    rows = re.findall(ROW, PLANS["Fourteen weeks"])
    assert MINUTES.keys() - OPTIONAL <= {number for _, lessons, *_ in rows for number in lessons.split(", ")}
