"""Judging in this process: what the learner's own check calls right, `grade` calls right; points, parts and hints."""

import contextlib
import importlib
import inspect
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from test_checks import EVERY, RIGHT, exercises, some_long, wrong_answers

from rlrobot_course.assignment_4 import exercises as assignment_4
from rlrobot_course.homework import COURSE
from rlrobot_course.learner.finished import finished
from rlrobot_course.lesson_03 import check as check_02
from rlrobot_grading.answers import limits
from rlrobot_grading.exercises.mistake import hinted
from rlrobot_grading.marking import kernel_side
from rlrobot_grading.marking.marks import NO_RULES, Limits, Marked, Rules, Score
from rlrobot_grading.marking.misunderstood import misunderstood
from rlrobot_grading.marking.one_notebook import Marking
from rlrobot_grading.marking.scoring import Scoring
from rlrobot_grading.marking.submission import Submission


class Here:
    """The kernel's side of grading, in this process."""

    def ask(self, text, seconds):
        return eval(text, vars(kernel_side))


def marked(lesson, name, answer):
    """The verdict of `grade` on one answer."""
    marking = Marking(
        COURSE,
        None,
        Submission("a notebook", lesson.removeprefix("lesson_"), [""]),
        0,
        Limits(),
    )
    kernel_side.answers[name] = answer
    return marking._judge(Here(), 0, name, kernel_side._described(answer))


def dotted(q, r, s_next, terminated, gamma):
    following = np.zeros(1)
    following[...] = 0 if terminated else np.max(q[s_next])
    return float(r + gamma * following[...][0])


def still_to_do(q, r, s_next, terminated, gamma):
    return ...


@pytest.mark.parametrize("lesson, name", some_long(EVERY))
def test_what_the_check_calls_right_is_marked_right_and_the_rest_is_not(lesson, name):
    check, (wrong, _) = exercises(lesson)[name], wrong_answers(lesson)[name][0]
    solution = getattr(
        importlib.import_module(f"rlrobot_course.{lesson}.exercises"), name
    )
    for answer in (solution, RIGHT.get(lesson, {}).get(name, solution), wrong):
        assert check(answer).status == marked(lesson, name, answer).status


@pytest.mark.parametrize("answer", [dotted, still_to_do, ...])
def test_dots_in_an_index_are_no_blank_and_a_blank_is_one(answer):
    at_home, graded = (
        check_02.target.judge(answer),
        marked("lesson_03", "target", answer),
    )
    assert (
        at_home.status == graded.status == ("right" if answer is dotted else "waiting")
    )


def test_a_last_cell_does_not_wait_for_an_answer_with_dots_in_an_index(capsys):
    assert finished(dotted) and not finished(still_to_do)
    assert (
        capsys.readouterr().out
        == "This cell waits for your answers above: still_to_do.\n"
    )


@pytest.mark.skipif(
    not hasattr(limits.signal, "setitimer"), reason="this system has no alarms"
)
def test_an_answer_that_sleeps_is_woken_and_told_that_it_waits(monkeypatch):
    monkeypatch.setattr(limits, "PATIENCE", 0.2)

    def sleeps(q, r, s_next, terminated, gamma):
        time.sleep(600)

    for verdict in (
        check_02.target.judge(sleeps),
        marked("lesson_03", "target", sleeps),
    ):
        assert (
            verdict.status == "wrong"
            and "has waited for" in verdict.text
            and "it waits" in verdict.hint
        )


@pytest.mark.skipif(
    not hasattr(limits.signal, "setitimer"), reason="this system has no alarms"
)
def test_an_alarm_that_is_swallowed_comes_again(monkeypatch):
    monkeypatch.setattr(limits, "PATIENCE", 0.2)
    monkeypatch.setattr(limits, "SNOOZE", 0.1)

    def sleeps_again(q, r, s_next, terminated, gamma):
        for _ in range(3):
            with contextlib.suppress(BaseException):
                time.sleep(600)
        return r

    assert check_02.target.judge(sleeps_again).status == "wrong"


def test_a_check_as_a_whole_has_a_limit_too(monkeypatch):
    monkeypatch.setattr("rlrobot_grading.exercises.exercise.PATIENCE", 0.1)

    def slow(q, r, s_next, terminated, gamma):
        time.sleep(0.06)
        return check_02.target.right(q, r, s_next, terminated, gamma)

    verdict = check_02.target.judge(slow)
    assert verdict.status == "wrong" and "has taken" in verdict.text


def test_a_period_is_looked_for_in_all_lengths():
    period = exercises("assignment_4")["period"]
    for most in range(1, 7):

        def short(states, most=most):
            lengths = range(1, min(most, len(states) // 2) + 1)
            return next((p for p in lengths if states[-p:] == states[-2 * p : -p]), 0)

        assert not period.judge(short)


LONGEST = """def period(states):
    n = len(states)
    return next((p for p in range(n // 2, 0, -1) if states[n - p:] == states[n - 2 * p:n - p]), 0)
"""
NO_CAP = """def next_temperature(temperature, states, rewards, default):
    p = period(states)
    return temperature + len(states) / (4 * p) if p and sum(rewards[-p:]) < 0 else default
"""
NEXT = inspect.getsource(assignment_4.next_temperature)


def scored(rules: Rules = NO_RULES, **answers: str) -> dict[str, Score]:
    """The scores of some answers to assignment 4, each in a cell, judged in this process."""
    cells = list(answers.values())
    places = {
        name: [list(answers).index(name)] if name in answers else []
        for name in vars(assignment_4.check)
    }
    marking = Marking(
        COURSE,
        Path(),
        Submission("it", "assignment_4", cells, places),
        0,
        Limits(),
        rules,
    )
    names: dict = {
        "check": SimpleNamespace(
            **{name: kernel_side.Intake(name) for name in vars(assignment_4.check)}
        )
    }
    for place, (name, source) in enumerate(answers.items()):
        exec(source, names)
        kernel_side.answers[name] = names[name]
        marking._outcomes.judged[name][place] = marking._judge(
            Here(), place, name, kernel_side._described(names[name])
        )
    scoring = Scoring(marking._submission, rules, marking._outcomes, "")
    return {name: scoring.score(name) for name in answers}


def test_what_calls_a_wrong_function_is_judged_with_the_right_one_and_says_so():
    scores = scored(period=LONGEST, next_temperature=NEXT)
    assert [score.score for score in scores.values()] == [0, 1]
    assert scores["next_temperature"].substituted == "period"
    assert "Judged with the right period" in scores["next_temperature"].output
    assert (
        kernel_side.answers["next_temperature"].__globals__["period"]
        is kernel_side.answers["period"]
    ), "it is taken back"


def test_with_the_right_function_in_its_place_a_wrong_answer_stays_wrong_and_a_right_one_needs_none():
    assert (
        scored(period=LONGEST, next_temperature=NO_CAP)["next_temperature"].score == 0
    )
    assert not scored(
        period=inspect.getsource(assignment_4.period), next_temperature=NEXT
    )["next_temperature"].substituted


def test_points_parts_and_hints_count_as_the_rules_say():
    rules = Rules(points={"period": 4}, partial=True, hint_off=0.25)
    part = scored(rules, period=LONGEST)["period"]
    assert (
        2 < part.score < 4
        and part.max_score == 4
        and part.mistake == "longest"
        and "% of the cases" in part.output
    )
    right = inspect.getsource(assignment_4.period) + "\ncheck.period.hint()\n"
    asked = (
        NEXT
        + "\ncheck.next_temperature.hint(2)\ncheck.next_temperature.hint(2)\n# check.next_temperature.hint(3)\n"
    )
    scores = scored(rules, period=right, next_temperature=asked)
    assert scores["next_temperature"].score == 0.75 and scores["period"].score == 3
    assert scores["period"].reason == "hints asked for"
    found = misunderstood(COURSE, [Marked("it", "assignment_4", list(scores.values()))])
    assert not found, "a hint is no misunderstanding"
    assert (
        scored(Rules(partial=True), period="def period(states):\n    ...\n")[
            "period"
        ].score
        == 0
    )


def test_what_is_wrong_in_a_caller_itself_is_told_and_not_what_comes_of_a_wrong_function_that_it_calls():
    alone = scored(next_temperature=NO_CAP.replace("period(states)", "0"))[
        "next_temperature"
    ]
    crashes = "def period(states):\n    raise IndexError('of period')\n"
    score = scored(period=crashes, next_temperature=NO_CAP)["next_temperature"]
    assert (
        score.score == 0
        and "of period" not in score.output
        and score.substituted == "period"
    )
    assert "Judged with the right period" in score.output and alone.substituted == ""


def test_in_homework_hints_can_be_fewer(monkeypatch):
    assert hinted(["a", "b", "c"], 3).text == "c"
    for most, told in (("1", "1 of 3"), ("0", "0 of 3")):
        monkeypatch.setenv("RLROBOT_EDU_HINTS", most)
        assert told in hinted(["a", "b", "c"], 2).text
    monkeypatch.setenv("RLROBOT_EDU_HINTS", "many")
    assert hinted(["a", "b", "c"], 3).text == "c"
