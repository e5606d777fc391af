"""The checks of the exercises: right answers pass, typical wrong ones get the hint that was made for them."""

from __future__ import annotations

import importlib
from pathlib import Path

import numpy as np
import pytest
from right_answers import RIGHT

import rlrobot_edu
from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.source import edited
from rlrobot_edu.course.lesson_02 import solutions as lesson_02

LESSONS = sorted(path.parent.name for path in Path(rlrobot_edu.__file__).parent.glob("course/lesson_*/check.py"))


def exercises(lesson: str) -> dict:
    """The exercises of a lesson by name."""
    module = importlib.import_module(f"rlrobot_edu.course.{lesson}.check")
    return {name: thing for name, thing in vars(module).items() if isinstance(thing, Exercise | Question)}


EVERY = [(lesson, name) for lesson in LESSONS for name in exercises(lesson)]
WRONG = [
    (lesson, name, i)
    for lesson in LESSONS
    for name, answers in importlib.import_module(f"wrong_answers.{lesson}").WRONG.items()
    for i in range(len(answers))
]


def waiting_answer(*_):
    """An exercise as the learner finds it."""
    ...


def half_done_answer(*_):
    return 1 + ...


def answer_that_raises(*_):
    raise KeyError("a mistake of the learner's")


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_the_solution_is_right(lesson, name):
    solution = getattr(importlib.import_module(f"rlrobot_edu.course.{lesson}.solutions"), name)
    verdict = exercises(lesson)[name](solution)
    assert verdict, verdict
    assert repr(verdict).startswith("✓ ")


@pytest.mark.parametrize(("lesson", "name"), [(lesson, name) for lesson in RIGHT for name in RIGHT[lesson]])
def test_another_right_answer_is_right_too(lesson, name):
    verdict = exercises(lesson)[name](RIGHT[lesson][name])
    assert verdict, verdict


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_an_unsolved_exercise_waits(lesson, name):
    exercise = exercises(lesson)[name]
    answers = [..., None] + ([waiting_answer, half_done_answer] if isinstance(exercise, Exercise) else [])
    for answer in answers:
        assert exercise(answer).status == "waiting"
        assert "waits for your answer" in repr(exercise(answer))


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_nothing_that_a_learner_writes_raises(lesson, name):
    for answer in (answer_that_raises, 3.5, "text", [1, 2], {"a": 1}, lambda: 0, object, print):
        verdict = exercises(lesson)[name](answer)
        assert not verdict
        assert repr(verdict).startswith(("✗ ", "… "))


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_every_check_is_tried_on_four_wrong_answers(lesson, name):
    wrong = importlib.import_module(f"wrong_answers.{lesson}").WRONG[name]
    assert len(wrong) >= 4
    hints = [exercises(lesson)[name](answer).hint for answer, _ in wrong]
    assert len(set(hints)) >= 4, "four different mistakes, four different hints"


@pytest.mark.parametrize(("lesson", "name", "i"), WRONG)
def test_a_typical_mistake_gets_its_hint(lesson, name, i):
    answer, word = importlib.import_module(f"wrong_answers.{lesson}").WRONG[name][i]
    verdict = exercises(lesson)[name](answer)
    assert verdict.status == "wrong", verdict
    assert word in verdict.hint, verdict


@pytest.mark.parametrize(("lesson", "name"), EVERY)
def test_the_known_mistakes_are_mistakes_and_differ(lesson, name):
    exercise = exercises(lesson)[name]
    values = [mistake.wrong for mistake in exercise.mistakes]
    answers = exercise.wrong_functions if isinstance(exercise, Exercise) else values
    for mistake, answer in zip(exercise.mistakes, answers, strict=True):
        with np.errstate(all="ignore"):  # some overflow
            verdict = exercise(answer)
        assert verdict.status == "wrong"
        assert verdict.hint == mistake.hint


def target_for_edits(q, r, s_next, terminated, gamma):
    """Not a place for an edit: terminated."""
    return r + gamma * (0 if terminated else target_for_edits.best(q[s_next]))


target_for_edits.best = max


def test_an_edit_changes_the_body_wherever_the_text_occurs_and_all_at_once():
    assert edited(lesson_02.update, {"gamma": "1", "alpha": "2"}).__code__.co_varnames[6:8] == ("alpha", "gamma")
    assert edited(target_for_edits, {"r +": "gamma +", "gamma *": "r *"})([[5.0]], 10.0, 0, False, 0.5) == 50.5
    assert edited(target_for_edits, {"(0 if": "(1 if"})([[5.0]], 10.0, 0, False, 0.5) == 12.5, "it calls the right one"


def test_an_edit_that_fits_no_longer_is_told_when_the_lesson_is_loaded():
    with pytest.raises(ValueError, match=r"'np\.max\(' does not occur in the body of target"):
        Exercise("…", lesson_02.target, tape=[], mistakes=[Mistake("no such text", {"np.max(": "np.argmax("})])


def test_a_verdict_names_the_first_wrong_step_with_both_values():
    check = exercises("lesson_02")["update"]
    wrong = importlib.import_module("wrong_answers.lesson_02").update_past_the_end
    text = repr(check(wrong))
    assert "Step 5 of 10" in text
    assert "s = 0, a = 1, r = 10, s_next = 3, terminated = True" in " ".join(text.split())
    row = next(line for line in text.splitlines() if "q[0, 1]" in line)
    before = 2.0 + 0.1 * (10 + 0.9 * 5.5 - 2.0)  # step 1
    assert float(row.split()[-2]) == pytest.approx(before + 0.1 * (10 - before), abs=1e-3)
    assert float(row.split()[-1]) > float(row.split()[-2])


def test_the_answer_may_rename_its_parameters_and_does_not_change_the_tape():
    check = exercises("lesson_02")["target"]

    def answer(table, reward, after, done, discount):
        table = table.copy()
        value = reward if done else reward + discount * table[after].max()
        table[:] = 0
        return value

    def spoils(table, reward, after, done, discount):
        value = reward if done else reward + discount * table[after].max()
        table[:] = 0
        return value

    assert check(answer)
    assert check(spoils) and check(answer)
