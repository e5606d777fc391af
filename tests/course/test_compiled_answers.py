"""Answers under numba's decorators: what is compiled meanwhile is not the learner's time, and loops still end."""

import contextlib
import time

import numba
import pytest
from numba.core import event

from rlrobot_course.lesson_03 import check
from rlrobot_grading.answers import limits


def fresh(**decorated):
    """Functions that nobody has compiled before."""
    names = {"njit": numba.njit}
    exec(
        "def target(q, r, s_next, terminated, gamma):\n    return r + (not terminated) * gamma * best(q[s_next])\n"
        "def best(row):\n    return max(row)\n"
        "def endless(q, r, s_next, terminated, gamma):\n    while True:\n        r += 1\n",
        names,
    )
    for name, decorator in decorated.items():
        names[name] = decorator(names[name])
    return names


@pytest.mark.parametrize(
    "decorated", [{"best": numba.njit}, {"best": numba.njit, "target": numba.njit}]
)
def test_a_compiled_answer_or_helper_is_judged(decorated):
    names = fresh(**decorated)
    verdict = check.target.judge(names["target"])
    assert verdict, verdict
    assert names["best"].signatures, "it was compiled meanwhile"


def test_the_time_in_which_numba_compiles_is_not_the_learners(monkeypatch):
    monkeypatch.setattr(limits, "SECONDS", 0.5)

    def answer(compiles):
        for _ in range(2):
            with (
                event.trigger_event("numba:compile")
                if compiles
                else contextlib.nullcontext()
            ):
                with event.trigger_event(
                    "numba:compile"
                ):  # what it calls is compiled, too
                    pass
                end = time.process_time() + 1
                while time.process_time() < end:
                    pass
        return 1

    assert limits.attempt(answer, True)[:2] == (1, None)
    assert limits.attempt(answer, False)[1].kind == "TooLong"


def test_a_compiled_loop_without_an_end_is_ended_in_its_line(monkeypatch):
    monkeypatch.setattr(limits, "SECONDS", 0.3)
    _, failure, _ = limits.attempt(
        fresh(endless=numba.njit)["endless"], [], 0, 0, False, 0
    )
    assert failure and failure.kind == "TooLong"


def test_after_compiling_a_loop_without_an_end_is_still_ended(monkeypatch):
    monkeypatch.setattr(limits, "SECONDS", 0.3)
    best = fresh(best=numba.njit)["best"]

    def answer(row):
        best(row)
        while True:
            pass

    _, failure, _ = limits.attempt(answer, [1.0, 2.0])
    assert failure and failure.kind == "TooLong"
