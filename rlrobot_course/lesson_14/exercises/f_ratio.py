"""The F ratio of an analysis of variance."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def f_ratio(groups):
    everyone = np.concatenate(groups)
    between = sum(len(g) * (np.mean(g) - everyone.mean()) ** 2 for g in groups)
    within = sum(np.sum((g - np.mean(g)) ** 2) for g in groups)
    return (between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))


_draw = np.random.default_rng(14)

GROUPS = [
    [np.array([1.0, 2.0, 4.5]), np.array([5.0, 8.0, 5.5])],
    [np.array([3.0, 4.0]), np.array([4.2, 6.0, 5.0, 7.7, 6.1]), np.array([2.5, 3.5, 3.1])],
    [_draw.normal(mean, 1.0, n).round(1) for mean, n in ((4, 6), (5, 4), (5.5, 8), (4.4, 5))],
    [np.array([2.0, 3.0, 5.0]), np.array([4.0, 4.5, 1.5])],
]

F = "(between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return F, the mean square between the groups over the mean square within them",
    right=f_ratio,
    returns="F",
    tape=[{"groups": groups} for groups in GROUPS],
    mistakes={
        "upside_down": Mistake(
            "upside down: between stands above the line, within below.",
            {F: "(within / (len(everyone) - len(groups))) / (between / (len(groups) - 1))"},
        ),
        "plain_sums": Mistake(
            "these are the sums of squares. Divide each by its degrees of freedom first.", {F: "between / within"}
        ),
        "freedoms_swapped": Mistake(
            "the degrees of freedom have changed places: k − 1 belongs to between, M − k to within.",
            {F: "(between / (len(everyone) - len(groups))) / (within / (len(groups) - 1))"},
        ),
        "k_for_k_minus_1": Mistake(
            "between has k − 1 degrees of freedom, one less than there are groups.",
            {"(len(groups) - 1)": "len(groups)"},
        ),
        "n_for_n_minus_k": Mistake(
            "within has M − k degrees of freedom: all numbers, less one for each group.",
            {"(len(everyone) - len(groups))": "len(everyone)"},
        ),
        "n_minus_1": Mistake(
            "within has M − k degrees of freedom, and not M − 1: each group has a mean of its own.",
            {"(len(everyone) - len(groups))": "(len(everyone) - 1)"},
        ),
        "k_and_n": Mistake(
            "between has k − 1 degrees of freedom and within M − k; here it is k and M.",
            {"(len(groups) - 1)": "len(groups)", "(len(everyone) - len(groups))": "len(everyone)"},
        ),
        "one_group_counted": Mistake(
            "M is the number of agents in all groups together, not the number in one.",
            {"(len(everyone) - len(groups))": "(len(groups[0]) - 1)"},
        ),
        "each_group_once": Mistake(
            "in between, each group counts as often as it has agents: len(g) times the square.", {"len(g) * (": "("}
        ),
        "mean_of_means": Mistake(
            "in between, the mean of each group is compared with the mean of all numbers. (The mean of the means "
            "is another one, where groups differ in size.)",
            {"everyone.mean()": "np.mean([np.mean(h) for h in groups])"},
        ),
        "from_the_mean_of_all": Mistake(
            "within compares each number with the mean of its own group, not with the mean of all.",
            {"(g - np.mean(g))": "(g - everyone.mean())"},
        ),
        "no_squares": Mistake("the squares are missing in between.", {"everyone.mean()) ** 2": "everyone.mean())"}),
        "means_within": Mistake(
            "within is a sum over all agents, not a mean: leave out the division by the size of each group.",
            {"np.sum((g": "np.mean((g"},
        ),
        "eta_squared": Mistake(
            "this is η², the share of the spread that lies between the groups. F divides between by within.",
            {F: "between / (between + within)"},
        ),
        "between_alone": Mistake(
            "this is only the mean square between. Divide it by the mean square within.",
            {F: "between / (len(groups) - 1)"},
        ),
        "within_alone": Mistake(
            "this is only the mean square within. It stands below the line.",
            {F: "within / (len(everyone) - len(groups))"},
        ),
        "root": Mistake("F is the ratio of mean squares: leave out the root.", {F: f"np.sqrt({F})"}),
        "own_k": Mistake("there need not be three groups: k is len(groups).", {"len(groups)": "3"}),
        "two_groups": Mistake("not only the first two groups count.", {"for g in groups": "for g in groups[:2]"}),
    },
    hints=(
        "Four numbers: the two sums of squares, and their degrees of freedom. everyone = np.concatenate(groups) helps.",
        "between = sum(len(g) * (g.mean() - everyone.mean()) ** 2 for g in groups); within sums (g − its mean)².",
        "return (between / (len(groups) - 1)) / (within / (… - …))",
    ),
    gained="Any table of an ANOVA is open to you now: you can work out its F yourself.",
    witnesses=WITNESSES,
)
