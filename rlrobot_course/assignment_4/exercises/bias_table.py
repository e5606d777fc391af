"""The bias of all states at once."""

from __future__ import annotations

import numpy as np

from rlrobot_course.assignment_4.given import table
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def bias_table(q, shape):
    table = q.reshape(*shape, q.shape[1])
    total = np.zeros(table.shape)
    for i in range(len(shape)):
        total += table.mean(axis=i, keepdims=True)
    return (total / len(shape)).reshape(q.shape)


WITNESSES = read_answers(__file__, {"bias_table": bias_table})[1]

exercise = Exercise(
    task="return the bias of all states at once, an array like q",
    right=bias_table,
    returns="bias",
    tape=[
        {"q": table(4, 2, 0), "shape": (2, 2)},
        {"q": table(3, 2, 1), "shape": (3,)},
        {"q": table(6, 3, 2), "shape": (2, 3)},
        {"q": table(6, 2, 3), "shape": (3, 2)},
        {"q": table(12, 2, 4), "shape": (2, 3, 2)},
        {"q": table(8, 1, 5), "shape": (2, 2, 2)},
    ],
    mistakes={
        "sum_over_inputs": Mistake(
            "this is the sum over the inputs. The bias is their mean: divide by their number.",
            {"total / len(shape)": "total"},
        ),
        "sum_over_states": Mistake(
            "this adds up all states that share the other inputs. It is their mean.", {"table.mean": "table.sum"}
        ),
        "mean_of_all": Mistake(
            "this is the mean of all states, whatever they share.",
            {"table.mean(axis=i, keepdims=True)": "q.mean(axis=0)"},
        ),
        "with_q": Mistake(
            "Q itself is added, too. The bias is apart from it: who chooses adds the two.",
            {".reshape(q.shape)": ".reshape(q.shape) + q"},
        ),
        "wrong_axes": Mistake(
            "the last axis is that of the actions. Each action has its own bias.",
            {"range(len(shape))": "range(1, len(shape) + 1)"},
        ),
        "first_input_alone": Mistake(
            "only the first input is looked at. Each of them has its own states that share the others.",
            {"range(len(shape))": "[0] * len(shape)"},
        ),
        "largest": Mistake("the largest value is taken. The bias is a mean.", {"table.mean": "table.max"}),
        "all_but_the_input": Mistake(
            "along axis i this leaves all inputs but i out. Only input i is averaged over.",
            {"table.mean(axis=i,": "table.mean(axis=tuple(k for k in range(len(shape)) if k != i),"},
        ),
    },
    hints=(
        "Give the table an axis for each input: then the states that share all inputs but one lie along that one's "
        "axis.",
        "table = q.reshape(*shape, q.shape[1]); table.mean(axis=i, keepdims=True) is the bias of input i, for all "
        "states.",
        "Add these up for all i (numpy stretches an axis of length 1), divide by len(shape), and reshape to q.shape.",
    ),
    gained="What was a loop over states is now one mean along each axis: a whole table in a blink.",
    witnesses=WITNESSES,
)
