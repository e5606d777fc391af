"""Exercises of lesson 07: QBIASSR."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.kernels import bias_of
from rlrobot_edu.course.lesson_07 import solutions

siblings = Exercise(
    task="return the numbers of the states that share all inputs with s but input i, from small to large",
    right=solutions.siblings,
    returns="siblings",
    tape=[
        {"shape": shape, "s": s, "i": i}
        for shape, s, i in (
            ((2, 2, 3, 2), 21, 2), ((2, 2, 3, 2), 21, 0), ((2, 2, 3, 2), 4, 3), ((2, 2, 3, 2), 13, 1),
            ((4, 3), 7, 0), ((4, 3), 7, 1), ((5,), 2, 0), ((2, 5, 3), 17, 1),
        )
    ],
    mistakes=[
        Mistake("s itself belongs to the set, too: it shares all other inputs with itself.",
                {"return numbers": "return [k for k in numbers if k != s]"}),
        Mistake("this is s alone. Input i may take any of its bins; all others stay as they are in s.",
                {"return numbers": "return [s]"}),
        Mistake("you have turned it round: these states share input i and differ in the others. They should share all "
                "others.",
                {"return numbers":
                 "return [k for k in range(np.prod(shape)) if np.unravel_index(k, shape)[i] == numbers.index(s)]"}),
        Mistake("these are the sets of all inputs in one. Only input i may differ.",
                {"return numbers": "return sorted({k for j in range(len(shape)) for k in siblings(shape, s, j)})"}),
        Mistake("here the first input counts fastest. In this course the last one does (lesson 01).",
                {"index(s, shape)": "index(s, shape, order='F')",
                 "index(bins, shape)": "index(bins, shape, order='F')"}),
        Mistake("this counts upward from s. The set begins where input i is in bin 0, which may lie below s.",
                {"return numbers": "return [s + k - numbers[0] for k in numbers]"}),
        Mistake("these are neighbours in number. To change input i by one bin, the number changes by the product of "
                "the bins of all inputs after i.",
                {"return numbers": "return [s - s % shape[i] + k for k in range(shape[i])]"}),
        Mistake("these are the bins of the right states. Turn each back into a number, with your state_number.",
                {"int(np.ravel_multi_index(bins, shape))": "[int(b) for b in bins]"}),
        Mistake("the right states, but not in order: from small to large, please, as a list.",
                {"return numbers": "return [s, *(k for k in numbers if k != s)]"}),
        Mistake("the right states, but a set has no order. Return a sorted list.",
                {"return numbers": "return set(numbers)"}),
        Mistake("the last bin is missing: input i has shape[i] of them, 0 to shape[i] − 1, and range(n) ends there by "
                "itself.", {"range(shape[i])": "range(shape[i] - 1)"}),
        Mistake("bins are counted from 0. The state in which input i is in bin 0 is missing.",
                {"range(shape[i])": "range(1, shape[i])"}),
        Mistake("input 0 is the first one. Here the one before input i is changed.",
                {"shape[i]": "shape[i - 1]", "bins[i]": "bins[i - 1]"}),
        Mistake("input i may take any of its bins, not only the next to its own.",
                {"range(shape[i])": "range(max(0, bins[i] - 1), min(shape[i], bins[i] + 2))"}),
        Mistake("return stands inside the loop: it ends the function with the first state.",
                {"numbers.append(int(np.ravel_multi_index(bins, shape)))":
                 "return [int(np.ravel_multi_index(bins, shape))]"}),
        Mistake("these are all the states there are.", {"return numbers": "return list(range(np.prod(shape)))"}),
        Mistake("the distance of two members is the product of the bins of the inputs *after* i; here that of input i "
                "is in it, too.",
                {"return numbers": "return [numbers[0] + k * int(np.prod(shape[i:])) for k in range(shape[i])]"}),
        Mistake("one state is not to be added several times.", {"return numbers": "return numbers + [s]"}),
    ],
    lenders={"state_number": "your function of lesson 01; np.ravel_multi_index(bins, shape) does the same"},
    hints=(
        "Take the bins of s, let number i be anything it can be, and turn each result back into a number.",
        "for k in range(shape[i]): put k into place i of the bins, and append the number of these bins to a list.",
        "bins = list(np.unravel_index(s, shape)); in the loop bins[i] = k and numbers.append(int(np.ravel_multi_index("
        "bins, shape))); at the end return numbers.",
    ),
    gained="To a table 21 and 9 are just numbers. Now you can tell which states have something to say to each other.",
)  # fmt: skip

by_hand = Question(
    task="the bias for spin right in state 21, computed by hand",
    right=solutions.by_hand,
    because="The means are 7.5 (X), 3.5 (Y), 6 (theta) and −1.5 (d), and the mean of these four is 15.5 / 4 = 3.875.",
    mistakes=[
        Mistake("this is the sum of the four means. The bias is their mean: divide by the number of inputs.", 15.5),
        Mistake("you left the state itself out of its sets. It is a member of each of the four.", 2.625),
        Mistake("this is one mean over all six states. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 22 / 6),
        Mistake("this is one mean over all nine members. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 37 / 9),
        Mistake("this is Q(s) + bias(s). Asked is the bias alone.", 8.875),
        Mistake("this is the mean over the five other states, all at once. Take a mean for each input first, the "
                "state itself included.", 3.4),
        Mistake("the set of theta has three members, so its mean is 18 / 3 = 6.", 4.625),
        Mistake("each set's values are to be divided by the number of its members: a mean, not a sum.", 9.25),
        Mistake("the set of d has −8 in it, not 8.", (7.5 + 3.5 + 6 + 6.5) / 4),
        Mistake("the set of theta has −1 in it, not 1.", (7.5 + 3.5 + 20 / 3 - 1.5) / 4),
        Mistake("this is Q(s) itself. What do the sets say?", 5),
        Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 5),
        Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 6),
    ],
    hints=(
        "Four means, one for each input, then the mean of these four. The state itself is in every set.",
        "X: (5 + 10) / 2. theta has three members: (5 + 14 − 1) / 3.",
        "((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 − 1) / 3 + (5 − 8) / 2) / 4",
    ),
    gained="Four opinions have become one. Next you let the computer ask them.",
)  # fmt: skip

DRAWN = np.random.default_rng(7).normal(2.0, 6.0, size=(30, 5)).round(1)
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
        Mistake("return stands inside the loop: only the first input has a say.",
                {"total += q[siblings(shape, s, i)].mean(axis=0)": "return q[siblings(shape, s, i)].mean(axis=0)"}),
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

own_share = Exercise(
    task="return the share with which Q(s) itself enters bias(s)",
    right=solutions.own_share,
    returns="share",
    tape=[{"shape": shape} for shape in ((2, 2, 3, 2), (4, 4, 4, 4, 4), (2, 2), (3, 8), (7,), (5, 1))],
    mistakes=[
        Mistake("this adds the shares up. The bias is the mean of the means: divide by the number of inputs.",
                {"np.mean": "sum"}),
        Mistake("this is the share of one state among all states. Q(s) enters through its sets, which are much "
                "smaller.", {"np.mean([1 / n for n in shape])": "1 / np.prod(shape)"}),
        Mistake("this treats all members as one large set. In the set of input i the share is 1 / shape[i]; take the "
                "mean of these.", {"np.mean([1 / n for n in shape])": "len(shape) / sum(shape)"}),
        Mistake("this is one in all the different states that have a say. In the set of input i the share is 1 / "
                "shape[i]; take the mean of these.",
                {"np.mean([1 / n for n in shape])": "1 / (1 + sum(n - 1 for n in shape))"}),
        Mistake("s is in every set, but it is not the only member: in the set of input i it is one of shape[i].",
                {"np.mean([1 / n for n in shape])": "1 / len(shape)"}),
        Mistake("s is in every set, but it is not the only member: its share is below 1.",
                {"np.mean([1 / n for n in shape])": "1.0"}),
        Mistake("a product would fit a set inside a set. Here there is a set for each input: take a mean.",
                {"np.mean([1 / n for n in shape])": "np.prod([1 / n for n in shape]) / len(shape)"}),
        Mistake("this is the share of the others. What is left, 1 minus this, is the share of Q(s).",
                {"np.mean": "1 - np.mean"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"1 / n": "1 // n"}),
        Mistake("this is 1 + the share: how much Q(s) + bias(s) grows. Asked is bias(s) alone.",
                {"return np.mean": "return 1 + np.mean"}),
        Mistake("this is the mean number of bins. The share in a set of n members is 1 / n.", {"1 / n": "n"}),
        Mistake("only the first input counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / shape[0]]"}),
        Mistake("only the last input counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / shape[-1]]"}),
        Mistake("only the largest set counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / max(shape)]"}),
        Mistake("only the smallest set counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / min(shape)]"}),
        Mistake("the share in a set of n members is 1 / n: s is one of them, and n counts it already.",
                {"1 / n": "1 / (n + 1)"}),
        Mistake("this is one in all the members of all sets. In the set of input i the share is 1 / shape[i]; take the "
                "mean of these.", {"np.mean([1 / n for n in shape])": "1 / sum(shape)"}),
    ],
    hints=(
        "In each set s is one of several members. What is its share there? The bias is the mean of the sets.",
        "In the set of input i the share is 1 / shape[i].",
        "The mean of 1 / n over all n in shape.",
    ),
    gained="One short line, and it says how much of what looks like advice is only an echo.",
)  # fmt: skip
