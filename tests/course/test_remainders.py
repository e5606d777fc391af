"""Of a wrong answer of which no idea is known, the card says where it is wrong, and that is true in every case."""

import numpy as np
import pytest
from test_checks import exercises, learner

from rlrobot_grading.hints.remainders import what_is_left

LEFT = {
    "one part of a pair": (
        "lesson_11",
        "motion",
        "def answer(left, right, radius, separation):\n"
        "    return radius * (left + right) / 2, right - left ** 2",
        "the first number is right in every case; the second is not.",
    ),
    "two parts of three": (
        "lesson_13",
        "gripper",
        "def answer(arm, biceps, forearm, upper=0.23, lower=0.25, shoulder=0.12):\n"
        "    up = shoulder + upper * np.cos(biceps) - lower * np.sin(biceps + forearm)\n"
        "    return arm - biceps, forearm ** 3, up",
        "the third number is right in every case; the first and the second are not.",
    ),
    "a part of each entry": (
        "lesson_14",
        "estimate",
        "def answer(rows, s, a):\n"
        "    seen = [(row[3], row[2]) for row in rows if (row[0], row[1]) == (s, a)]\n"
        "    keys = [x for x, _ in seen]\n"
        "    return {x: (keys.count(x) / len(keys), dict(seen)[x] ** 3) for x in keys}",
        "the first number is right in every case; the second is not.",
    ),
    "an entry that stays": (
        "lesson_20",
        "learn_from",
        "def answer(q, rows, alpha, gamma):\n"
        "    for s, a, r, s_next, terminated in rows:\n"
        "        best = 0 if terminated else max(q[s_next])\n"
        "        if r < 0: continue\n"
        "        q[s, a] += alpha * (r + gamma * best - q[s, a])",
        "less of q changes than should",
    ),
    "changes that are too large": (
        "lesson_03",
        "update",
        "def answer(q, s, a, r, s_next, terminated, alpha, gamma):\n"
        "    best = 0 if terminated else max(q[s_next])\n"
        "    for _ in range(s + 2):\n"
        "        q[s, a] += alpha * (r + gamma * best - q[s, a])",
        "the right entries of q change, but some of them too far",
    ),
    "from a limit on": (
        "assignment_3",
        "return_over_n",
        "def answer(rewards, values, t, n, gamma):\n"
        "    g = sum(gamma ** k * r for k, r in enumerate(rewards[t : t + n]))\n"
        "    return (g + gamma ** n * values[t + n] if t + n < len(rewards) else g) - t",
        "it is wrong in all cases in which t is 1 or more, and right in all others",
    ),
    "no zeros": (
        "assignment_1",
        "greedy",
        "def answer(q):\n"
        "    best = q == q.max(axis=1, keepdims=True)\n"
        "    return 0.8 * best / best.sum(axis=1, keepdims=True) + 0.2 / q.shape[1]",
        "where 0 is asked, something else stands in yours: entry [0, 0] here",
    ),
    "too large alone": (
        "assignment_3",
        "return_over_n",
        "def answer(rewards, values, t, n, gamma):\n"
        "    g = sum(gamma ** k * r for k, r in enumerate(rewards[t : t + n]))\n"
        "    return (g + gamma ** n * values[t + n] if t + n < len(rewards) else g) + 1 / n",
        "whatever is wrong here is too large, and never too small",
    ),
}


def left_of(lesson, name, source):
    check = exercises(lesson)[name]
    answer = learner(source)
    with np.errstate(all="ignore"):
        return what_is_left(check.evidence(answer, check.outcomes(answer)))


@pytest.mark.parametrize("which", LEFT)
def test_what_is_left_is_told(which):
    lesson, name, source, told = LEFT[which]
    assert left_of(lesson, name, source).startswith(told)


def test_nothing_is_said_where_nothing_holds_in_every_case():
    source = (
        "def answer(rewards, values, t, n, gamma):\n"
        "    g = sum(gamma ** k * r for k, r in enumerate(rewards[t : t + n]))\n"
        "    g = g + gamma ** n * values[t + n] if t + n < len(rewards) else g\n"
        "    return g + (-1) ** n * (1 + t)"
    )
    assert not left_of("assignment_3", "return_over_n", source)
    fails = "def answer(left, right, radius, separation):\n    return radius / 0"
    assert not left_of("lesson_11", "motion", fails)


def test_a_rate_for_a_share_and_a_row_for_a_table_are_told():
    yes = learner("def answer(observed, shuffled):\n    return shuffled.max() > 1e9")
    hint = exercises("lesson_15")["p_value"](yes).hint
    assert hint == "this is False, which says yes or no. What is asked is a number."
    best = learner("def answer(q):\n    return q.argmax(axis=1)")
    hint = exercises("assignment_1")["greedy"](best).hint
    assert hint == "these are 2 numbers. What is asked is a row of several for each."
    lists = learner(
        "def answer(s, shape, is_circle):\n    return [[s, s], [0, 1], [1, 0]]"
    )
    assert "lists in this list" in exercises("assignment_4")["near_states"](lists).hint


def test_the_number_that_is_too_many_is_named():
    more = "def answer(s, shape, is_circle):\n    return list(range(900, 930))"
    hint = exercises("assignment_4")["near_states"](learner(more)).hint
    assert hint.endswith("900, for one, should not be there.")
