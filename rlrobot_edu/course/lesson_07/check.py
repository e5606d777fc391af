"""Exercises of lesson 07: QBIASSR."""

from __future__ import annotations

import math

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake, Question
from rlrobot_edu.learning.qbiassr import bias_of


def _stride(shape, i):
    return math.prod(shape[i + 1 :])


def _siblings(shape, s, i):
    first = s - s // _stride(shape, i) % shape[i] * _stride(shape, i)
    return [first + k * _stride(shape, i) for k in range(shape[i])]


def _without_s(shape, s, i):
    return [k for k in _siblings(shape, s, i) if k != s]


def _shares_input_i_alone(shape, s, i):
    mine = np.unravel_index(s, shape)[i]
    return [k for k in range(math.prod(shape)) if np.unravel_index(k, shape)[i] == mine]


def _of_all_inputs(shape, s, i):
    return sorted({k for j in range(len(shape)) for k in _siblings(shape, s, j)})


def _first_input_fastest(shape, s, i):
    bins = list(np.unravel_index(s, shape, order="F"))
    return sorted(int(np.ravel_multi_index((*bins[:i], k, *bins[i + 1 :]), shape, order="F")) for k in range(shape[i]))


def _begins_at_s(shape, s, i):
    return [s + k * _stride(shape, i) for k in range(shape[i])]


def _neighbours_in_number(shape, s, i):
    first = s - s % shape[i]
    return list(range(first, first + shape[i]))


def _as_bins(shape, s, i):
    return [[int(b) for b in np.unravel_index(k, shape)] for k in _siblings(shape, s, i)]


siblings = Exercise(
    task="return the numbers of the states that share all inputs with s but input i, from small to large",
    right=_siblings,
    returns="siblings",
    tape=[
        {"shape": shape, "s": s, "i": i}
        for shape, s, i in (
            ((2, 2, 3, 2), 21, 2), ((2, 2, 3, 2), 21, 0), ((2, 2, 3, 2), 4, 3), ((2, 2, 3, 2), 13, 1),
            ((4, 3), 7, 0), ((4, 3), 7, 1), ((5,), 2, 0), ((2, 5, 3), 17, 1),
        )
    ],
    mistakes=[
        Mistake("s itself belongs to the set, too: it shares all other inputs with itself.", _without_s),
        Mistake("this is s alone. Input i may take any of its bins; all others stay as they are in s.",
                lambda shape, s, i: [s]),
        Mistake("you have turned it round: these states share input i and differ in the others. "
                "They should share all others.", _shares_input_i_alone),
        Mistake("these are the sets of all inputs in one. Only input i may differ.", _of_all_inputs),
        Mistake("here the first input counts fastest. In this course the last one does (lesson 01).",
                _first_input_fastest),
        Mistake("this counts upward from s. The set begins where input i is in bin 0, which may lie below s.",
                _begins_at_s),
        Mistake("these are neighbours in number. To change input i by one bin, the number changes by the product of "
                "the bins of all inputs after i.", _neighbours_in_number),
        Mistake("these are the bins of the right states. Turn each back into a number, with your state_number.",
                _as_bins),
        Mistake("the right states, but not in order: from small to large, please, as a list.",
                lambda shape, s, i: [s, *_without_s(shape, s, i)]),
        Mistake("the right states, but a set has no order. Return a sorted list.",
                lambda shape, s, i: set(_siblings(shape, s, i))),
    ],
)  # fmt: skip

by_hand = Question(
    task="the bias for spin right in state (1, 1, 90, T), computed by hand",
    right=4.25,
    because="The means are 6 (X), 5 (Y), 5 (theta) and 1 (d), and the mean of these four is 17 / 4 = 4.25.",
    mistakes=[
        Mistake("this is the sum of the four means. The bias is their mean: divide by the number of inputs.", 17.0),
        Mistake("you left the state itself out of its sets. It is a member of each of the four.", 4.375),
        Mistake("this is one mean over all six states. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 4.5),
        Mistake("this is one mean over all nine members. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 13 / 3),
        Mistake("this is Q(s) + bias(s). Asked is the bias alone.", 8.25),
        Mistake("this is the mean over the five other states, all at once. Take a mean for each input first, the state "
                "itself included.", 4.6),
        Mistake("the set of theta has three members, so its mean is 15 / 3 = 5.", 4.875),
        Mistake("each set's values are to be divided by the number of its members: a mean, not a sum.", 39 / 4),
    ],
)  # fmt: skip

Q = np.random.default_rng(7).normal(2.0, 6.0, size=(24, 3)).round(1)


def _rows(q, states):
    return np.asarray(q)[np.asarray(states)]


def _leaves_s_out(q, shape, s):
    sets = [_without_s(shape, s, i) for i in range(len(shape)) if shape[i] > 1]
    return np.mean([_rows(q, states).mean(axis=0) for states in sets], axis=0)


def _all_members_at_once(q, shape, s):
    return _rows(q, _of_all_inputs(shape, s, 0)).mean(axis=0)


def _all_members_in_one_list(q, shape, s):
    return _rows(q, [k for i in range(len(shape)) for k in _siblings(shape, s, i)]).mean(axis=0)


def _sums_the_sets(q, shape, s):
    return np.mean([_rows(q, _siblings(shape, s, i)).sum(axis=0) for i in range(len(shape))], axis=0)


def _last_input_only(q, shape, s):
    return _rows(q, _siblings(shape, s, len(shape) - 1)).mean(axis=0)


def _means_of(sets):
    return lambda q, shape, s: np.mean([_rows(q, sets(shape, s, i)).mean(axis=0) for i in range(len(shape))], axis=0)


def _writes_into_q(q, shape, s):
    bias = bias_of(q, shape, s)
    q[s] += bias
    return bias


bias = Exercise(
    task="return bias(s), an array with one number for each action",
    right=bias_of,
    returns="bias",
    memory={"q": Q},
    tape=[
        {"shape": shape, "s": s}
        for shape, s in (((2, 2, 3, 2), 21), ((2, 2, 3, 2), 4), ((4, 6), 9), ((3, 2, 4), 16), ((24,), 5))
    ],
    mistakes=[
        Mistake("s is missing from its sets. It is a member of each of them.", _leaves_s_out),
        Mistake("this is one mean over all the states at once. Take the mean of each input's set first, then the mean "
                "of these means: it differs, because not all sets have the same size.", _all_members_at_once),
        Mistake("this is one mean over the members of all sets together. Take the mean of each set first, then the "
                "mean of these means: large sets must not count more.", _all_members_in_one_list),
        Mistake("this is the sum of the means. Divide by the number of inputs.",
                lambda q, shape, s: bias_of(q, shape, s) * len(shape)),
        Mistake("each set gives a mean: divide by the number of its members, which is shape[i].", _sums_the_sets),
        Mistake("this is Q(s) itself, so your sets hold s alone. Input i may take any of its bins.",
                lambda q, shape, s: q[s].copy()),
        Mistake("this is Q(s) + bias(s). Return the bias alone.", lambda q, shape, s: q[s] + bias_of(q, shape, s)),
        Mistake("this is one number for all actions together. The bias has one for each: take means along axis=0.",
                lambda q, shape, s: float(bias_of(q, shape, s).mean())),
        Mistake("this counts the last input only. Is something overwritten in your loop that should be added up?",
                _last_input_only),
        Mistake("the states are counted with the first input fastest here. In this course the last one is (lesson 01).",
                _means_of(_first_input_fastest)),
        Mistake("your sets share input i and differ in the others. They should share all others.",
                _means_of(_shares_input_i_alone)),
        Mistake("your function changed q. The bias is for the choice alone: nothing is written to the table.",
                _writes_into_q),
    ],
)  # fmt: skip

own_share = Exercise(
    task="return the share with which Q(s) itself enters bias(s)",
    right=lambda shape: sum(1 / n for n in shape) / len(shape),
    returns="share",
    tape=[{"shape": shape} for shape in ((2, 2, 3, 2), (4, 4, 4, 4, 4), (2, 2), (3, 8), (7,))],
    mistakes=[
        Mistake("this adds the shares up. The bias is the mean of the means: divide by the number of inputs.",
                lambda shape: sum(1 / n for n in shape)),
        Mistake("this is the share of one state among all states. Q(s) enters through its sets, which are much "
                "smaller.", lambda shape: 1 / math.prod(shape)),
        Mistake("this treats all members as one large set. In the set of input i the share is 1 / shape[i]; take the "
                "mean of these.", lambda shape: len(shape) / sum(shape)),
        Mistake("this is one in all the different states that have a say. In the set of input i the share is "
                "1 / shape[i]; take the mean of these.", lambda shape: 1 / (1 + sum(n - 1 for n in shape))),
        Mistake("s is in every set, but it is not the only member: in the set of input i it is one of shape[i].",
                lambda shape: 1 / len(shape)),
        Mistake("s is in every set, but it is not the only member: its share is below 1.", lambda shape: 1.0),
        Mistake("a product would fit a set inside a set. Here there is a set for each input: take a mean.",
                lambda shape: math.prod(1 / n for n in shape) / len(shape)),
        Mistake("this is the share of the others. What is left, 1 minus this, is the share of Q(s).",
                lambda shape: 1 - sum(1 / n for n in shape) / len(shape)),
    ],
)  # fmt: skip

best_adviser = Question(
    task="the name of the input whose set gives the best advice",
    right="floor",
    because="What is good does not depend on the colour of the floor, so four states give each other their experience. "
    "An input that does not matter makes learning slower; QBIASSR undoes a part of that.",
    mistakes=[
        Mistake("with the line on the other side, the other turn is best: two of the three members disagree with the "
                "third.", "line"),
        Mistake("to go straight on is good where the way is free, and a crash where it is not: these two states should "
                "not listen to each other.", "ahead"),
        Mistake("with the trailer left and right change places: the other state's advice is wrong exactly where it is "
                "most sure.", "trailer"),
        Mistake("their advice is not equally good. Take two states that differ in one input alone: is the same action "
                "best in both?", "all"),
        Mistake("one of these inputs hardly matters for what is to be done. Then what was learned with one of its "
                "values holds for the others, too.", "none"),
    ],
)  # fmt: skip
