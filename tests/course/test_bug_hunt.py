"""Bug hunts: what is served can be found by what is shown, and the answer stands nowhere before one's own is right."""

import json
import re
from itertools import permutations
from pathlib import Path

import pytest
from test_checks import exercises

from rlrobot_course.bug_hunt import BugHunt, bugs, tells_apart
from rlrobot_course.lesson_02 import check, solutions
from rlrobot_course.my_functions import keep

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
SERVED = re.compile(r"BugHunt\(check\.(\w+), seed=(\d+)\)")


def served() -> list[tuple[str, str, int]]:
    """Lesson, exercise and seed of each hunt in the notebooks."""
    found = []
    for path in sorted(NOTEBOOKS.glob("*.ipynb")):
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            hunts = SERVED.findall("".join(cell["source"]))
            found += [(f"lesson_{path.name.partition('_')[0]}", name, int(seed)) for name, seed in hunts]
    return found


def opened(exercise, seed: int) -> BugHunt:
    """A hunt of one whose own function is right."""
    hunt = BugHunt(exercise, seed)
    hunt.is_open = True
    return hunt


@pytest.fixture
def green(tmp_path):
    """The folder of a learner whose `update` is right."""
    keep(solutions.update, "02", "update", check.update.judge, tmp_path)
    return tmp_path


def test_there_is_one_in_each_lesson_from_02_on_that_has_one_right_function():
    assert [lesson.removeprefix("lesson_") for lesson, *_ in served()] == [
        *("02", "03", "04", "05", "06", "07", "08", "09", "10", "11", "12", "13", "14", "16a", "17"),
    ]


@pytest.mark.parametrize(("lesson", "name", "seed"), served())
def test_each_bug_can_be_told_from_every_other_one_and_its_own_line_is_the_answer(lesson, name, seed):
    exercise = exercises(lesson)[name]
    known = bugs(exercise)
    assert len(known) > 10
    assert all(tells_apart(exercise, one.function, other.function) for one, other in permutations(known, 2))
    hunt = opened(exercise, seed)
    assert hunt.diagnose(hunt._bug.line, hunt._bug.text)
    others = [bug for bug in known if bug != hunt._bug]
    assert not any(hunt.diagnose(bug.line, bug.text) for bug in others[:8])
    assert hunt._bug.text not in repr(hunt).splitlines()


def test_it_begins_when_ones_own_function_is_right(tmp_path, green):
    closed = BugHunt(check.update, seed=1, folder=tmp_path / "nobody")
    assert repr(closed) == "This hunt begins when your update is right: its check must have been green."
    assert closed.diagnose(1, "pass").text == "This hunt begins when your update is green and kept."
    assert closed.diagnose(1, "x").status == "waiting"
    hunt = BugHunt(check.update, seed=1, folder=green)
    assert "healthy" in repr(hunt) and hunt.diagnose(..., ...).status == "waiting"


def test_a_wrong_diagnosis_is_told_what_differs():
    hunt = opened(check.update, 1)
    line, text, _ = hunt._bug
    assert "A line from 1 to" in hunt.diagnose(99, text).text and "A line from 1" in hunt.diagnose(line, 3).text
    assert "Python cannot read" in hunt.diagnose(line, "q[s, a] = (").text
    assert hunt.diagnose(line, "q[s, a] += 1").text.startswith("The line is right, but with yours")
