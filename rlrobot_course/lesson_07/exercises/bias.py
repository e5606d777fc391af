"""The bias of a state, QBIASSR's mean of means."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_07.exercises.siblings import siblings
from rlrobot_edu.widgets.kernels import bias_of


def bias(q, shape, s):
    total = np.zeros(q.shape[1])
    for i in range(len(shape)):
        total += q[siblings(shape, s, i)].mean(axis=0)
    return total / len(shape)


DRAWN = np.random.default_rng(7).normal(2.0, 6.0, size=(30, 5)).round(1)
DRAWN[[9, 15, 17]] = 0.0  # never visited
DRAWN[[3, 4, 8], [1, 0, 2]] = 0.0

SMALL = np.array([[1.0, -2.0], [4.0, 0.5], [7.0, 3.0], [0.0, 6.0], [5.0, 2.5], [-8.0, 9.0]])  # shown in full

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return bias(s), an array with one number for each action",
    right=bias,
    library=bias_of,
    returns="bias",
    tape=[{"q": SMALL, "shape": (2, 3), "s": 4}]
    + [
        {"q": DRAWN[: np.prod(shape), :n_actions], "shape": shape, "s": s}
        for shape, s, n_actions in (
            ((2, 2, 3, 2), 21, 3),
            ((2, 2, 3, 2), 4, 3),
            ((4, 6), 9, 4),
            ((3, 2, 4), 16, 2),
            ((24,), 5, 5),
            ((5, 3, 2), 11, 3),
        )
    ],
    lenders={"siblings": "your function of this lesson: run the cell with its exercise again"},
    mistakes={
        "without_s": Mistake(
            "s is missing from its sets. It is a member of each of them.",
            {"siblings(shape, s, i)": "[k for k in siblings(shape, s, i) if k != s]"},
        ),
        "mean_of_the_union": Mistake(
            "this is one mean over all the states at once. Take the mean of each input's set first, then the mean "
            "of these means: it differs, because not all sets have the same size.",
            {
                "total / len(shape)": (
                    "q[list({k for i in range(len(shape)) for k in siblings(shape, s, i)})].mean(axis=0)"
                )
            },
        ),
        "mean_of_all_members": Mistake(
            "this is one mean over the members of all sets together. Take the mean of each set first, then the "
            "mean of these means: large sets must not count more.",
            {"total / len(shape)": "q[[k for i in range(len(shape)) for k in siblings(shape, s, i)]].mean(axis=0)"},
        ),
        "sum_of_means": Mistake("this is the sum of the means. Divide by the number of inputs.", {" / len(shape)": ""}),
        "sums_of_sets": Mistake(
            "each set gives a mean: divide by the number of its members, which is shape[i].",
            {"mean(axis=0)": "sum(axis=0)"},
        ),
        "s_alone": Mistake(
            "this is Q(s) itself, so your sets hold s alone. Input i may take any of its bins.",
            {"siblings(shape, s, i)": "[s]"},
        ),
        "adds_q": Mistake("this is Q(s) + bias(s). Return the bias alone.", {"return ": "return q[s] + "}),
        "takes_q_off": Mistake(
            "from the bias Q(s) has been taken off. Return the bias alone.", {"return ": "return -q[s] + "}
        ),
        "one_number": Mistake(
            "this is one number for all actions together. The bias has one for each: take means along axis=0.",
            {"np.zeros(q.shape[1])": "0.0", "mean(axis=0)": "mean()"},
        ),
        "last_input_alone": Mistake(
            "this counts the last input only. Is something overwritten in your loop that should be added up?",
            {"+=": "=", " / len(shape)": ""},
        ),
        "first_fastest": Mistake(
            "the states are counted with the first input fastest here. In this course the last one is (lesson 01).",
            {"siblings(shape, s, i)": "siblings(shape[::-1], s, -1 - i)"},
        ),
        "turned_round": Mistake(
            "your sets share input i and differ in the others. They should share all others.",
            {
                "siblings(shape, s, i)": (
                    "[k for k in range(len(q)) if np.unravel_index(k, shape)[i] == siblings(shape, s, i).index(s)]"
                )
            },
        ),
        "changes_q": Mistake(
            "total = q[s] is not a copy but the row of the table itself, and += changes it. Begin with zeros.",
            {"np.zeros(q.shape[1])": "q[s]"},
        ),
        "four_inputs": Mistake(
            "the sum is divided by a fixed 4. There are len(shape) inputs, which need not be four.",
            {"len(shape)": "4", "range(len(shape))": "range(len(shape))"},
        ),
        "wrong_axis": Mistake(
            "the mean runs along the wrong axis: axis=0 goes down the column, one mean for each action.",
            {"mean(axis=0)": "mean(axis=1).sum()"},
        ),
        "largest": Mistake(
            "these are the largest values of the sets. Asked are their means.", {"mean(axis=0)": "max(axis=0)"}
        ),
        "not_the_first": Mistake(
            "the first input is left out: range(len(shape)) begins with 0.",
            {"range(len(shape))": "range(1, len(shape))"},
        ),
        "not_the_last": Mistake(
            "the last input is left out: range(len(shape)) ends with it.",
            {"range(len(shape))": "range(len(shape) - 1)"},
        ),
        "first_input_alone": Mistake(
            "only the first input has a say. Does return stand inside the loop, or a 0 where i belongs?",
            {"total += q[siblings(shape, s, i)].mean(axis=0)": "return q[siblings(shape, s, i)].mean(axis=0)"},
        ),
        "unvisited_left_out": Mistake(
            "states that were never visited, with a row of zeros, are left out here. They are members, too.",
            {
                "q[siblings(shape, s, i)].mean(axis=0)": (
                    "q[[k for k in siblings(shape, s, i) if q[k].any()] or [s]].mean(axis=0)"
                )
            },
        ),
        "zeros_left_out": Mistake(
            "zeros are left out here. They count, too: a mean is over all members of the set.",
            {
                "q[siblings(shape, s, i)].mean(axis=0)": "q[siblings(shape, s, i)].sum(axis=0) / "
                "np.maximum(1, (q[siblings(shape, s, i)] != 0).sum(axis=0))"
            },
        ),
        "divides_by_states": Mistake(
            "the sum of the means is divided by the number of inputs, len(shape), not by that of the states.",
            {"total / len(shape)": "total / len(q)"},
        ),
        "mean_of_the_others": Mistake(
            "this is the mean over the other states, all at once. Take a mean for each input first, s included.",
            {
                "total / len(shape)": (
                    "q[list({k for i in range(len(shape)) for k in siblings(shape, s, i)} - {s})].mean(axis=0)"
                )
            },
        ),
        "begins_with_q": Mistake(
            "you begin with q[s], but s is in the sets already. Begin with zeros.",
            {"np.zeros(q.shape[1])": "q[s].copy()"},
        ),
        "begins_with_q_as_a_mean": Mistake(
            "you begin with q[s] as if it were one more mean. There is one mean for each input, and s is in it.",
            {
                "np.zeros(q.shape[1])": "q[s].copy()",
                "len(shape)": "(len(shape) + 1)",
                "range(len(shape))": "range(len(shape))",
            },
        ),
        "list_of_means": Mistake(
            "these are the means of the sets, one below the other. The bias is their mean: one row.",
            {"total / len(shape)": "[q[siblings(shape, s, i)].mean(axis=0) for i in range(len(shape))]"},
        ),
        "mean_of_a_mean": Mistake(
            "a mean of a mean and the next mean makes the last input count half. Add all up, then divide once.",
            {
                "total += q[siblings(shape, s, i)].mean(axis=0)": "total = (total + q[siblings(shape, s, i)].mean("
                "axis=0)) / (2 if i else 1)",
                " / len(shape)": "",
            },
        ),
        "best_action": Mistake(
            "this is the action that the bias likes most. Return the bias: one number for each action.",
            {"total / len(shape)": "total.argmax()"},
        ),
        "begins_anew": Mistake(
            "total begins anew for each input, or is overwritten: only the last one is left. Set it to zeros "
            "before the loop, and add to it.",
            {"+=": "="},
        ),
        "divides_by_actions": Mistake(
            "the mean of the means is taken over the inputs: divide by len(shape), not by the number of actions.",
            {"total / len(shape)": "total / len(total)"},
        ),
        "return_in_the_loop": Mistake(
            "only the first input has a say, and its mean is divided. Does return stand inside a loop?",
            {
                "total += q[siblings(shape, s, i)].mean(axis=0)": (
                    "return q[siblings(shape, s, i)].mean(axis=0) / len(shape)"
                )
            },
        ),
        "medians": Mistake(
            "plain means are meant, not medians.",
            {"q[siblings(shape, s, i)].mean(axis=0)": "np.median(q[siblings(shape, s, i)], axis=0)"},
        ),
        "softmax": Mistake(
            "softmax comes later: return the means as they are.",
            {"total / len(shape)": "np.exp(total / len(shape)) / np.exp(total / len(shape)).sum()"},
        ),
        "s_twice": Mistake(
            "the members of a set are in its list already: q[s] is counted twice here.",
            {"siblings(shape, s, i)": "siblings(shape, s, i) + [s]"},
        ),
    },
    hints=(
        "For each input the mean of the rows of its set; then the mean of these means.",
        "siblings(shape, s, i) is a list of states, and q[that list].mean(axis=0) is the set's opinion of each action.",
        "total = np.zeros(q.shape[1]); for i in range(len(shape)): total += q[siblings(shape, s, i)].mean(axis=0); "
        "return total / len(shape)",
    ),
    gained="That is all of QBIASSR that is new: the idea of the paper, in a few lines of yours. In section 7 a robot "
    "listens to it.",
    witnesses=WITNESSES,
)
