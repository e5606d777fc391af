"""The states beside a state."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def near_states(s, shape, is_circle):
    near, bins = set(), np.unravel_index(s, shape)
    for i in range(len(shape)):
        for step in (-1, 1):
            other = list(bins)
            other[i] += step
            if is_circle[i]:
                other[i] %= shape[i]
            if 0 <= other[i] < shape[i]:
                near.add(int(np.ravel_multi_index(other, shape)))
    return sorted(near - {s})


def other_state(rng: np.random.Generator, case: Case) -> Case:
    """A case of `near_states` with more bins where there are more than two, and any state."""
    shape = tuple(n + int(rng.integers(3)) * (n > 2) for n in case["shape"])
    return {**case, "shape": shape, "s": int(rng.integers(math.prod(shape)))}


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the sorted list of the states that lie one bin beside s, in one input",
    right=near_states,
    returns="near",
    tape=[
        {"s": 1, "shape": (3,), "is_circle": (False,)},
        {"s": 0, "shape": (4,), "is_circle": (True,)},
        {"s": 0, "shape": (2, 3), "is_circle": (False, False)},
        {"s": 5, "shape": (2, 3), "is_circle": (False, True)},
        {"s": 17, "shape": (3, 4, 2), "is_circle": (False, False, False)},
        {"s": 6, "shape": (2, 5), "is_circle": (True, True)},
        {"s": 23, "shape": (3, 4, 2), "is_circle": (True, True, False)},
        {"s": 37, "shape": (5, 2, 5), "is_circle": (False, True, True)},
    ],
    mistakes={
        "no_circle": Mistake("a circle has no ends: beside its last bin lies its first.", CHANGED["no_circle"]),
        "all_circles": Mistake(
            "only an input that is a circle goes round. On a line nothing lies beyond the last bin.",
            {"if is_circle[i]:": "if True:"},
        ),
        "with_itself": Mistake("the state itself is not beside itself.", {"sorted(near - {s})": "sorted(near | {s})"}),
        "only_above": Mistake("beside a bin lie two, the one below and the one above it.", {"(-1, 1)": "(1,)"}),
        "any_bin": Mistake(
            "these are all that share every input but one. Here that one may differ by a single bin only.",
            {"for step in (-1, 1)": "for step in range(-max(shape), max(shape))"},
        ),
        "last_input_alone": Mistake(
            "only the last input changes. Each of them may, one at a time.",
            {"for i in range(len(shape))": "for i in [len(shape) - 1]"},
        ),
        "not_the_last_input": Mistake(
            "the last input's neighbours are missing.", {"range(len(shape))": "range(len(shape) - 1)"}
        ),
        "twice_in_a_small_circle": Mistake(
            "each state once: in a circle of two bins the one below is the one above. A set keeps each once.",
            {
                "near, bins = set(), ": "near, bins = [], ",
                "near.add(": "near.append(",
                "sorted(near - {s})": "sorted(near)",
            },
        ),
        "several_inputs": Mistake(
            "several inputs change at once: begin with the bins of s for each neighbour.", CHANGED["several_inputs"]
        ),
    },
    another=other_state,
    hints=(
        "Go from the number to the bins, change one of them by one, up and down, and go back to the number. For each "
        "input.",
        "np.unravel_index(s, shape) gives the bins, np.ravel_multi_index(bins, shape) the number. On a circle: "
        "bin % shape[i]. On a line: leave out what lies outside.",
        "Gather the numbers in a set, near.add(int(…)); at the end sorted(near - {s}).",
    ),
    gained="A coding of the world says who is near whom. A heading of 350° lies beside one of 10° only if you say so.",
    witnesses=WITNESSES,
)
