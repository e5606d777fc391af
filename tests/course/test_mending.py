"""Robots to mend: what is given has one wrong line and is red, and the films show what the lessons say of them."""

import json
import re
from functools import cache
from importlib import import_module
from math import hypot
from pathlib import Path

import numpy as np
import pytest
from test_checks import EVERY, exercises, learner

from rlrobot_course.drives.mending import broken, mended
from rlrobot_course.lesson_16 import drive as follower
from rlrobot_edu.show.describe import path_of
from rlrobot_grading.answers.source import edited, is_written_alike
from rlrobot_grading.exercises.verdict import AS_GIVEN

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
MENDED = {  # the part of the wrong line, and what belongs there
    ("lesson_03", "target"): ("q.max()", "max(q[s_next])"),
    ("lesson_08", "dutch"): ("kept = e", "kept = (1 - alpha) * e"),
    ("lesson_16", "follow_reward"): (
        'hypot(after["x"], after["y"])',
        'hypot(after["x"] - before["x"], after["y"] - before["y"])',
    ),
}
each = pytest.mark.parametrize(("lesson", "name"), MENDED)


def source_of(lesson: str, name: str) -> str:
    """The function of its exercise's cell."""
    path = next(NOTEBOOKS.glob(f"{lesson[-2:]}_*.ipynb"))
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    sources = ["".join(cell["source"]) for cell in cells]
    source = next(one for one in sources if one.endswith(f"check.{name}({name})"))
    return source.partition("check.")[0]


def answer_of(lesson: str, name: str, source: str):
    answer = learner(source.replace(f"def {name}(", "def answer("))
    answer.__globals__["hypot"] = hypot
    return answer


@cache
def films(lesson: str, name: str):
    """The film of the robot as it was given, and that of the mended one."""
    exercise = exercises(lesson)[name]
    return broken(exercise), mended(exercise, exercise.right)


def test_every_exercise_with_given_code_is_here():
    given = [
        (lesson, name)
        for lesson, name in EVERY
        if getattr(exercises(lesson)[name], "given", None)
    ]
    assert given == list(MENDED)


@each
def test_the_cell_has_the_function_by_which_the_robot_of_the_film_drives(lesson, name):
    answer = answer_of(lesson, name, source_of(lesson, name))
    assert is_written_alike(answer, exercises(lesson)[name].given.wrong)


@each
def test_what_is_given_is_red_and_its_hint_names_nothing_of_the_wrong_line(
    lesson, name, monkeypatch
):
    exercise = exercises(lesson)[name]
    source = source_of(lesson, name)
    commented = source.replace("\n", "  # a comment\n", 1)
    for text in (source, commented):
        verdict = exercise.judge(answer_of(lesson, name, text))
        assert (verdict.status, verdict.id) == ("wrong", AS_GIVEN)
        assert not verdict.rows and not verdict.called
    wrong, _ = MENDED[lesson, name]
    line = next(line for line in source.splitlines() if wrong in line)
    for word in re.findall(r"[^\W\d]\w*", line):
        assert not re.search(rf"\b{word}\b", f"{verdict.text} {verdict.hint}")
    for module in ("exercise", "mistake"):
        path = f"rlrobot_grading.exercises.{module}.is_notebook"
        monkeypatch.setattr(path, lambda: True)
    said = exercise(answer_of(lesson, name, source))
    assert f"write check.{name}.hint()" in said.text
    assert said.below is None


@each
def test_one_line_mends_it(lesson, name):
    exercise = exercises(lesson)[name]
    source = source_of(lesson, name)
    wrong, right = MENDED[lesson, name]
    assert source.count(wrong) == 1
    assert exercise.judge(answer_of(lesson, name, source.replace(wrong, right)))


@each
def test_what_is_given_earns_no_points(lesson, name):
    exercise = exercises(lesson)[name]
    assert exercise.share(exercise.given.wrong) == 0
    assert exercise.share(exercise.right) == 1


@each
def test_a_saved_notebook_shows_no_card_of_it(lesson, name, monkeypatch):
    exercise = exercises(lesson)[name]
    verdict = exercise.judge(exercise.given.wrong)
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "0")
    assert verdict._ipython_display_() is None
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "1")
    with pytest.raises(NotImplementedError):
        verdict._ipython_display_()


def test_the_robot_of_lesson_03_pushes_against_the_wall_and_mended_bumps_once():
    wrong, right = (film.rewards for film in films("lesson_03", "target"))
    first = wrong.index(-2)
    assert len(wrong) - first > 5 and set(wrong[first:]) == {-2}
    assert right.count(-2) == 1 and right[-1] == 10


def test_the_robot_of_lesson_08_gives_up_and_mended_drives():
    wrong, right = (film.rewards for film in films("lesson_08", "dutch"))
    assert set(wrong) == {-0.02}
    assert right.count(10) > len(right) / 2


def test_the_robot_of_lesson_16_stands_beside_the_wall_and_is_paid_for_it():
    exercise = exercises("lesson_16")["follow_reward"]
    wrong, right = films("lesson_16", "follow_reward")
    path = np.array(path_of(wrong.frames))
    assert np.allclose(path, path[0])
    assert set(wrong.rewards) == {-0.4} and 10 in right.rewards
    paid = []

    class Listening:
        """In place of a film: what the given reward pays for each step."""

        def follow(self, walk, robot, reward, before):
            for _ in walk:
                after = robot.readings
                paid.append(exercise.given.wrong(before, after))
                before = after

    follower.by_reward(exercise.given.wrong, Listening())
    assert set(paid[: len(wrong.frames)]) == {10}


def test_what_has_nothing_to_mend_has_no_such_film():
    check = import_module("rlrobot_course.lesson_03").check
    with pytest.raises(ValueError, match="nothing is to be mended in update"):
        broken(check.update)
    with pytest.raises(ValueError, match="no robot drives by bin_of"):
        mended(exercises("lesson_01")["bin_of"], len)


def test_functions_are_written_alike_whatever_their_comments_and_names():
    target = exercises("lesson_03")["target"].right
    assert is_written_alike(
        target, edited(target, {"return r\n": "return r  # ends\n"})
    )
    assert not is_written_alike(target, edited(target, {"gamma *": "0.9 *"}))
