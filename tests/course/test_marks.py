"""What the learner's own check calls right, `grade` calls right; what it refuses, `grade` refuses."""

import importlib
import time

import numpy as np
import pytest
from test_checks import RIGHT, exercises, wrong_answers
from test_checks_survive import ONE_OF_EACH_KIND

from rlrobot_course.finished import finished
from rlrobot_course.grading import limits
from rlrobot_course.homework import inside
from rlrobot_course.homework.marking import Marking
from rlrobot_course.homework.marks import Limits
from rlrobot_course.homework.submission import Submission
from rlrobot_course.lesson_02 import check as check_02


class Here:
    """The kernel's side of grading, in this process."""

    def ask(self, text, seconds):
        return eval(text, vars(inside))


def marked(lesson, name, answer):
    """The verdict of `grade` on one answer."""
    marking = Marking(None, Submission("a notebook", lesson.removeprefix("lesson_"), [""]), 0, Limits())
    inside.answers[name] = answer
    return marking._judge(Here(), 0, name, inside._described(answer))


def dotted(q, r, s_next, terminated, gamma):
    following = np.zeros(1)
    following[...] = 0 if terminated else np.max(q[s_next])
    return float(r + gamma * following[...][0])


def still_to_do(q, r, s_next, terminated, gamma):
    return ...


@pytest.mark.parametrize("lesson, name", ONE_OF_EACH_KIND)
def test_what_the_check_calls_right_is_marked_right_and_the_rest_is_not(lesson, name):
    check, (wrong, _) = exercises(lesson)[name], wrong_answers(lesson)[name][0]
    solution = getattr(importlib.import_module(f"rlrobot_course.{lesson}.exercises"), name)
    for answer in (solution, RIGHT.get(lesson, {}).get(name, solution), wrong):
        assert check(answer).status == marked(lesson, name, answer).status


@pytest.mark.parametrize("answer", [dotted, still_to_do, ...])
def test_dots_in_an_index_are_no_blank_and_a_blank_is_one(answer):
    at_home, graded = check_02.target.judge(answer), marked("lesson_02", "target", answer)
    assert at_home.status == graded.status == ("right" if answer is dotted else "waiting")


def test_a_last_cell_does_not_wait_for_an_answer_with_dots_in_an_index(capsys):
    assert finished(dotted) and not finished(still_to_do)
    assert capsys.readouterr().out == "This cell waits for your answers above: still_to_do.\n"


@pytest.mark.skipif(not hasattr(limits.signal, "setitimer"), reason="this system has no alarms")
def test_an_answer_that_sleeps_is_woken_and_told_that_it_waits(monkeypatch):
    monkeypatch.setattr(limits, "PATIENCE", 0.2)

    def sleeps(q, r, s_next, terminated, gamma):
        time.sleep(600)

    for verdict in (check_02.target.judge(sleeps), marked("lesson_02", "target", sleeps)):
        assert verdict.status == "wrong" and "has waited for" in verdict.text and "it waits" in verdict.hint


def test_a_check_as_a_whole_has_a_limit_too(monkeypatch):
    monkeypatch.setattr("rlrobot_course.grading.exercise.PATIENCE", 0.1)

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
