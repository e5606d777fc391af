"""The exercise of lesson 07 on the bias itself."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.kernels import bias_of
from rlrobot_edu.course.lesson_07 import solutions

DRAWN = np.random.default_rng(7).normal(2.0, 6.0, size=(30, 5)).round(1)
DRAWN[[9, 15, 17]] = 0.0  # never visited
DRAWN[[3, 4, 8], [1, 0, 2]] = 0.0
SMALL = np.array([[1.0, -2.0], [4.0, 0.5], [7.0, 3.0], [0.0, 6.0], [5.0, 2.5], [-8.0, 9.0]])  # shown in full

bias = Exercise(
    task="return bias(s), an array with one number for each action",
    right=solutions.bias,
    library=bias_of,
    returns="bias",
    tape=[{"q": SMALL, "shape": (2, 3), "s": 4}]
    + [
        {"q": DRAWN[: np.prod(shape), :n_actions], "shape": shape, "s": s}
        for shape, s, n_actions in (
            ((2, 2, 3, 2), 21, 3), ((2, 2, 3, 2), 4, 3), ((4, 6), 9, 4), ((3, 2, 4), 16, 2), ((24,), 5, 5),
            ((5, 3, 2), 11, 3),
        )
    ],
    lenders={"siblings": "your function of this lesson: run the cell with its exercise again"},
    mistakes=[
        Mistake("s is missing from its sets. It is a member of each of them.",
                {"siblings(shape, s, i)": "[k for k in siblings(shape, s, i) if k != s]"}),
        Mistake("this is one mean over all the states at once. Take the mean of each input's set first, then the mean "
                "of these means: it differs, because not all sets have the same size.",
                {"total / len(shape)":
                 "q[list({k for i in range(len(shape)) for k in siblings(shape, s, i)})].mean(axis=0)"}),
        Mistake("this is one mean over the members of all sets together. Take the mean of each set first, then the "
                "mean of these means: large sets must not count more.",
                {"total / len(shape)":
                 "q[[k for i in range(len(shape)) for k in siblings(shape, s, i)]].mean(axis=0)"}),
        Mistake("this is the sum of the means. Divide by the number of inputs.", {" / len(shape)": ""}),
        Mistake("each set gives a mean: divide by the number of its members, which is shape[i].",
                {"mean(axis=0)": "sum(axis=0)"}),
        Mistake("this is Q(s) itself, so your sets hold s alone. Input i may take any of its bins.",
                {"siblings(shape, s, i)": "[s]"}),
        Mistake("this is Q(s) + bias(s). Return the bias alone.", {"return ": "return q[s] + "}),
        Mistake("from the bias Q(s) has been taken off. Return the bias alone.", {"return ": "return -q[s] + "}),
        Mistake("this is one number for all actions together. The bias has one for each: take means along axis=0.",
                {"np.zeros(q.shape[1])": "0.0", "mean(axis=0)": "mean()"}),
        Mistake("this counts the last input only. Is something overwritten in your loop that should be added up?",
                {"+=": "=", " / len(shape)": ""}),
        Mistake("the states are counted with the first input fastest here. In this course the last one is (lesson 01).",
                {"siblings(shape, s, i)": "siblings(shape[::-1], s, -1 - i)"}),
        Mistake("your sets share input i and differ in the others. They should share all others.",
                {"siblings(shape, s, i)":
                 "[k for k in range(len(q)) if np.unravel_index(k, shape)[i] == siblings(shape, s, i).index(s)]"}),
        Mistake("total = q[s] is not a copy but the row of the table itself, and += changes it. Begin with zeros.",
                {"np.zeros(q.shape[1])": "q[s]"}),
        Mistake("the sum is divided by a fixed 4. There are len(shape) inputs, which need not be four.",
                {"len(shape)": "4", "range(len(shape))": "range(len(shape))"}),
        Mistake("the mean runs along the wrong axis: axis=0 goes down the column, one mean for each action.",
                {"mean(axis=0)": "mean(axis=1).sum()"}),
        Mistake("these are the largest values of the sets. Asked are their means.", {"mean(axis=0)": "max(axis=0)"}),
        Mistake("the first input is left out: range(len(shape)) begins with 0.",
                {"range(len(shape))": "range(1, len(shape))"}),
        Mistake("the last input is left out: range(len(shape)) ends with it.",
                {"range(len(shape))": "range(len(shape) - 1)"}),
        Mistake("only the first input has a say. Does return stand inside the loop, or a 0 where i belongs?",
                {"total += q[siblings(shape, s, i)].mean(axis=0)": "return q[siblings(shape, s, i)].mean(axis=0)"}),
        Mistake("states that were never visited, with a row of zeros, are left out here. They are members, too.",
                {"q[siblings(shape, s, i)].mean(axis=0)":
                 "q[[k for k in siblings(shape, s, i) if q[k].any()] or [s]].mean(axis=0)"}),
        Mistake("zeros are left out here. They count, too: a mean is over all members of the set.",
                {"q[siblings(shape, s, i)].mean(axis=0)": "q[siblings(shape, s, i)].sum(axis=0) / "
                 "np.maximum(1, (q[siblings(shape, s, i)] != 0).sum(axis=0))"}),
        Mistake("the sum of the means is divided by the number of inputs, len(shape), not by that of the states.",
                {"total / len(shape)": "total / len(q)"}),
        Mistake("this is the mean over the other states, all at once. Take a mean for each input first, s included.",
                {"total / len(shape)":
                 "q[list({k for i in range(len(shape)) for k in siblings(shape, s, i)} - {s})].mean(axis=0)"}),
        Mistake("you begin with q[s], but s is in the sets already. Begin with zeros.",
                {"np.zeros(q.shape[1])": "q[s].copy()"}),
        Mistake("you begin with q[s] as if it were one more mean. There is one mean for each input, and s is in it.",
                {"np.zeros(q.shape[1])": "q[s].copy()", "len(shape)": "(len(shape) + 1)",
                 "range(len(shape))": "range(len(shape))"}),
        Mistake("these are the means of the sets, one below the other. The bias is their mean: one row.",
                {"total / len(shape)": "[q[siblings(shape, s, i)].mean(axis=0) for i in range(len(shape))]"}),
        Mistake("a mean of a mean and the next mean makes the last input count half. Add all up, then divide once.",
                {"total += q[siblings(shape, s, i)].mean(axis=0)": "total = (total + q[siblings(shape, s, i)].mean("
                 "axis=0)) / (2 if i else 1)", " / len(shape)": ""}),
        Mistake("this is the action that the bias likes most. Return the bias: one number for each action.",
                {"total / len(shape)": "total.argmax()"}),
        Mistake("total begins anew for each input, or is overwritten: only the last one is left. Set it to zeros "
                "before the loop, and add to it.", {"+=": "="}),
        Mistake("the mean of the means is taken over the inputs: divide by len(shape), not by the number of actions.",
                {"total / len(shape)": "total / len(total)"}),
        Mistake("return stands inside the loop: only the first input has a say, and its mean is divided.",
                {"total += q[siblings(shape, s, i)].mean(axis=0)":
                 "return q[siblings(shape, s, i)].mean(axis=0) / len(shape)"}),
        Mistake("plain means are meant, not medians.", {"q[siblings(shape, s, i)].mean(axis=0)":
                "np.median(q[siblings(shape, s, i)], axis=0)"}),
        Mistake("softmax comes later: return the means as they are.",
                {"total / len(shape)": "np.exp(total / len(shape)) / np.exp(total / len(shape)).sum()"}),
        Mistake("the members of a set are in its list already: q[s] is counted twice here.",
                {"siblings(shape, s, i)": "siblings(shape, s, i) + [s]"}),
    ],
    hints=(
        "For each input the mean of the rows of its set; then the mean of these means.",
        "siblings(shape, s, i) is a list of states, and q[that list].mean(axis=0) is the set's opinion of each action.",
        "total = np.zeros(q.shape[1]); for i in range(len(shape)): total += q[siblings(shape, s, i)].mean(axis=0); "
        "return total / len(shape)",
    ),
    gained="That is all of QBIASSR that is new: the idea of the paper, in a few lines of yours. In section 7 a robot "
    "listens to it.",
)  # fmt: skip
