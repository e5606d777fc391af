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
    ],
)  # fmt: skip

by_hand = Question(
    task="the bias for spin right in state (1, 1, 90, T), computed by hand",
    right=solutions.by_hand,
    because="The means are 6 (X), 5 (Y), 5 (theta) and 1 (d), and the mean of these four is 17 / 4 = 4.25.",
    mistakes=[
        Mistake("this is the sum of the four means. The bias is their mean: divide by the number of inputs.", 17.0),
        Mistake("you left the state itself out of its sets. It is a member of each of the four.", 4.375),
        Mistake("this is one mean over all six states. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 4.5),
        Mistake("this is one mean over all nine members. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 13 / 3),
        Mistake("this is Q(s) + bias(s). Asked is the bias alone.", 8.25),
        Mistake("this is the mean over the five other states, all at once. Take a mean for each input first, the "
                "state itself included.", 4.6),
        Mistake("the set of theta has three members, so its mean is 15 / 3 = 5.", 4.875),
        Mistake("each set's values are to be divided by the number of its members: a mean, not a sum.", 39 / 4),
    ],
)  # fmt: skip

Q = np.random.default_rng(7).normal(2.0, 6.0, size=(24, 3)).round(1)

bias = Exercise(
    task="return bias(s), an array with one number for each action",
    right=solutions.bias,
    library=bias_of,
    returns="bias",
    memory={"q": Q},
    tape=[
        {"shape": shape, "s": s}
        for shape, s in (((2, 2, 3, 2), 21), ((2, 2, 3, 2), 4), ((4, 6), 9), ((3, 2, 4), 16), ((24,), 5))
    ],
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
        Mistake("your function changed q. The bias is for the choice alone: nothing is written to the table.",
                {"return ": "q[s] += total / len(shape)\n    return "}),
    ],
)  # fmt: skip

own_share = Exercise(
    task="return the share with which Q(s) itself enters bias(s)",
    right=solutions.own_share,
    returns="share",
    tape=[{"shape": shape} for shape in ((2, 2, 3, 2), (4, 4, 4, 4, 4), (2, 2), (3, 8), (7,))],
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
    ],
)  # fmt: skip

best_adviser = Question(
    task="the name of the input whose set gives the best advice",
    right=solutions.best_adviser,
    because="What is good does not depend on the colour of the floor, so four states give each other their experience. "
    "An input that does not matter makes learning slower; QBIASSR undoes a part of that.",
    mistakes=[
        Mistake("with the line on the other side, the other turn is best: two of the three members disagree with the "
                "third.", "line"),
        Mistake("to go straight on is good where the way is free, and a crash where it is not: these two states "
                "should not listen to each other.", "ahead"),
        Mistake("with the trailer left and right change places: the other state's advice is wrong exactly where it is "
                "most sure.", "trailer"),
        Mistake("their advice is not equally good. Take two states that differ in one input alone: is the same action "
                "best in both?", "all"),
        Mistake("one of these inputs hardly matters for what is to be done. Then what was learned with one of its "
                "values holds for the others, too.", "none"),
    ],
)  # fmt: skip
