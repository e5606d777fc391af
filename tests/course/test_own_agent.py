"""Agents with a learner's function: the library's agent where that is right, and its mistakes where it is not."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.learner.my_functions import check_of
from rlrobot_course.learner.own_agent import OwnChoice, OwnUpdate

CELLS = rl.load_task("worked_example")
SHAPE = (2, 2, 3, 2)
SAME = {"alpha": 0.3, "seed": 4, "loop_evasion": False}
right_update = check_of("08").true_online_update.right
bias = check_of("05").bias.right
softmax, normalise, draw = (
    vars(check_of(lesson))[name].right
    for lesson, name in (("04", "softmax"), ("04", "normalise"), ("04", "draw"))
)


def choice(q, s):
    b = bias(q, SHAPE, s)
    return b, softmax(normalise(q[s] + b, 10, 0.9), 1.0)


@pytest.mark.parametrize(
    "mine, theirs",
    [
        (OwnUpdate(right_update, CELLS, **SAME), rl.Agent(CELLS, "TOSL+SR", traces="full", **SAME)),
        (OwnChoice(choice, draw, CELLS, **SAME), rl.Agent(CELLS, "Q+QBIASSR", **SAME)),
    ],
    ids=["true online", "QBIASSR"],
)  # fmt: skip
def test_right_functions_make_the_librarys_agent(mine, theirs):
    walks = [rl.steps(each, rl.make_env(CELLS, seed=4), 300) for each in (mine, theirs)]
    for own, right in zip(*walks, strict=True):
        assert (own.s, own.a, own.a_next) == (right.s, right.a, right.a_next)
        np.testing.assert_allclose(own.probabilities, right.probabilities, atol=1e-9)
        np.testing.assert_allclose(mine.q, theirs.q, atol=1e-9)
        np.testing.assert_allclose(mine.e, theirs.e, atol=1e-9)


def test_it_is_the_learners_function_that_learns():
    def forgets_the_second_line(q, e, q_old, s, a, *rest):
        before = q[s, a]
        noted = right_update(q, e, q_old, s, a, *rest)
        q[s, a] += rest[-3] * (before - q_old)
        return noted

    mine = OwnUpdate(forgets_the_second_line, CELLS, **SAME)
    right = OwnUpdate(right_update, CELLS, **SAME)
    for agent in (mine, right):
        list(rl.steps(agent, rl.make_env(CELLS, seed=4), 100))
    assert np.abs(mine.q - right.q).max() > 0.1


def test_a_stepper_walks_through_what_it_learns():
    agent = OwnUpdate(right_update, CELLS, **SAME)
    stepper = rl.Stepper(agent, rl.make_env(CELLS, seed=4), at=40)
    assert "state" in repr(stepper) and stepper.still().alt
