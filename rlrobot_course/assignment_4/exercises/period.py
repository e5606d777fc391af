"""The period of the circle that a robot drives in."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def period(states):
    for p in range(1, len(states) // 2 + 1):
        if states[-p:] == states[-2 * p : -p]:
            return p
    return 0


def renamed(rng: np.random.Generator, case: Case) -> Case:
    """A case of `period` in which the states have other numbers; which are equal stays so."""
    factor, shift = int(rng.integers(2, 9)), int(rng.integers(1, 50))
    return {"states": [factor * s + shift for s in case["states"]]}


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return after how many steps the states repeat, 0 if they do not",
    right=period,
    returns="period",
    tape=[
        {"states": [4, 7, 4, 7]},
        {"states": [3, 1, 2, 5]},
        {"states": [5, 9, 6, 6]},
        {"states": [1, 2, 3, 1, 2, 3]},
        {"states": [1, 2, 1, 2, 1, 2, 1, 2]},
        {"states": [4, 4, 8, 3, 5]},
        {"states": [2, 7, 1, 1, 7, 2]},
        {"states": [1, 5, 2, 5]},
        {"states": [8]},
        {"states": []},
        {"states": [0, 6, 2, 3, 1, 2, 3, 1]},
        {"states": [1, 2, 2, 1]},
        {"states": [1, 2, 3, 4, 1, 2, 3, 4]},
        {"states": [6, 2, 8, 4, 5, 7, 2, 8, 4, 5, 7]},
        {"states": [9, 1, 2, 1, 3, 5, 4, 1, 2, 1, 3, 5, 4]},
        {"states": [3, 1, 4, 1, 5, 9, 2, 3, 1, 4, 1, 5, 9, 2]},
    ],
    mistakes={
        "longest": Mistake(
            "this is the longest one. The robot goes round once in the shortest: begin with 1.",
            {"range(1, len(states) // 2 + 1)": "range(len(states) // 2, 0, -1)"},
        ),
        "oldest": Mistake(
            "the newest states count, those at the end of the list. This compares the oldest.",
            {"states[-p:] == states[-2 * p : -p]": "states[:p] == states[p : 2 * p]"},
        ),
        "one_state_again": Mistake(
            "a state that comes again is not yet a circle: all of the last p states must be as the p before.",
            {"states[-p:] == states[-2 * p : -p]": "states[-1] == states[-1 - p]"},
        ),
        "not_half_the_list": Mistake(
            "a circle may also be of half the list's length: let p run up to len(states) // 2.", {"// 2 + 1": "// 2"}
        ),
        "short_ones_alone": Mistake(
            "only the shortest circles are tried: let p run up to len(states) // 2.",
            {"len(states) // 2 + 1": "min(3, len(states) // 2) + 1"},
        ),
        "not_1": Mistake(
            "a single state, again and again, is a circle of period 1. Begin with 1.", {"range(1,": "range(2,"}
        ),
        "length_if_none": Mistake("where nothing repeats, return 0.", {"return 0": "return len(states)"}),
        "none_if_none": Mistake(
            "where nothing repeats, return 0: yours returns nothing there.", {"return 0": "return None"}
        ),
        "any_order": Mistake(
            "a circle has an order. The same states in another one are no circle.",
            {"states[-p:] == states[-2 * p : -p]": "sorted(states[-p:]) == sorted(states[-2 * p : -p])"},
        ),
        "true_or_false": Mistake(
            "this is true or false. Return the period, how many states the circle has.", {"return p": "return True"}
        ),
    },
    another=renamed,
    hints=(
        "If the robot goes in a circle of p states, the last p of the list are the same as the p before them.",
        "states[-p:] are the last p, states[-2 * p : -p] the p before. Try p = 1, 2, … up to half of the list.",
        "for p in range(1, len(states) // 2 + 1): if …: return p. Below the loop: return 0.",
    ),
    gained="The paper's redundancy asks how often a robot comes by the same states. Yours asks whether it goes round.",
    witnesses=WITNESSES,
)
