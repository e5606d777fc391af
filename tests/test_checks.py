"""The checks of the exercises: right answers pass, typical wrong ones get the hint that was made for them."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

from rlrobot_edu.course.grading.exercise import Exercise, Question

LESSONS = sorted(path.stem for path in Path(__file__).parent.glob("solutions/lesson_*.py"))


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
    solution = getattr(importlib.import_module(f"solutions.{lesson}"), name)
    verdict = exercises(lesson)[name](solution)
    assert verdict, verdict
    assert repr(verdict).startswith("✓ ")


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
    for mistake in exercise.mistakes:
        verdict = exercise(mistake.answer)
        assert verdict.status == "wrong"
        assert verdict.hint == mistake.hint


def test_a_verdict_names_the_first_wrong_step_with_both_values():
    check = exercises("lesson_02")["update"]
    wrong = importlib.import_module("wrong_answers.lesson_02").update_past_the_end
    text = repr(check(wrong))
    assert "Step 5 of 9" in text
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
