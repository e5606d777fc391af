"""The plans of docs/teaching.md: each lesson after those that it needs, and the minutes are the lessons' own."""

import re
from pathlib import Path

import pytest

from rlrobot_course.authoring.lists import facts

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "teaching.md").read_text(encoding="utf-8")
PLANS = dict(
    re.findall(
        r"^### (\w+ weeks): .*?\n(.*?)(?=\n###|\nThe p)", PAGE, re.DOTALL | re.MULTILINE
    )
)
LESSONS = facts(ROOT)
ASSIGNMENT = 70
ROW = re.compile(r"^\| (\d+) \| (.*?) \| (\d?) \| (\d+) \|$", re.MULTILINE)


@pytest.mark.parametrize("name", PLANS)
def test_a_plan_is_in_an_order_that_can_be_taught(name):
    rows = re.findall(ROW, PLANS[name])
    assert [int(week) for week, *_ in rows] == list(range(1, len(rows) + 1))
    done: set[str] = set()
    for _, read, assignment, minutes in rows:
        numbers = read.split(", ")
        assert int(minutes) == sum(
            LESSONS[n].minutes for n in numbers
        ) + ASSIGNMENT * bool(assignment)
        for number in numbers:
            assert done.issuperset(LESSONS[number].needs), (
                f"{number} needs {LESSONS[number].needs}"
            )
            done.add(number)


def test_there_are_plans_and_the_longest_has_every_lesson_that_is_not_optional():
    assert list(PLANS) == ["Two weeks", "Six weeks", "Ten weeks", "Fourteen weeks"]
    rows = re.findall(ROW, PLANS["Fourteen weeks"])
    assert {number for number, lesson in LESSONS.items() if not lesson.is_optional} <= {
        number for _, lessons, *_ in rows for number in lessons.split(", ")
    }


def test_the_page_says_how_many_hours_the_lessons_of_the_road_take():
    minutes = sum(one.minutes for one in LESSONS.values() if not one.is_optional)
    assert f"The lessons from 00 to 18 take {minutes / 60:.0f} hours" in PAGE
