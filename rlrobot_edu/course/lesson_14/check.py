"""Exercises of lesson 14: what repetitions prove."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_14 import solutions

p_value = Exercise(
    task="return the share of the shuffled numbers that are at least as large as the observed one",
    right=solutions.p_value,
    returns="p",
    tape=[
        {"observed": observed, "shuffled": np.array(shuffled)}
        for observed, shuffled in (
            (3.0, [0.2, 1.1, 3.0, 0.7, 5.2, 0.1, 0.4, 2.9, 0.6, 3.0, 1.5]),
            (26.0, [0.5, 1.5, 2.5, 0.1]),
            (0.5, [0.5, 1.5, 2.5, 0.1, 0.9, 0.3, 0.2]),
            (0.05, [0.7, 1.5, 2.5]),
            (2.0, [2.0, 0.4, 0.1, 0.3, 0.8, 1.2, 0.0, 1.9, 0.6, 0.5, 0.2, 0.9, 1.1]),
        )
    ],
    mistakes=[
        Mistake("this is the share that is smaller. A small p must mean: chance hardly ever gets that far.",
                {">=": "<"}),
        Mistake("at least as large: those that equal the observed one count, too.", {">=": ">"}),
        Mistake("this is how many they are; divide by how many were shuffled.", {" / len(shuffled)": ""}),
        Mistake("this is the share that is at most as large as the observed one: the other side.", {">=": "<="}),
        Mistake("this is the share that equals the observed one. Those that are larger count, too.", {">=": "=="}),
        Mistake("this is in per cent. A share lies between 0 and 1.", {"sum(": "100 * sum("}),
        Mistake("this is the mean of the shuffled numbers. Compare each with the observed one first.",
                {"f >= observed for f": "f for f"}),
        Mistake("the numbers are added up that are at least as large. Count them.",
                {"f >= observed for f in shuffled": "f for f in shuffled if f >= observed"}),
        Mistake("you compare with the mean of the shuffled numbers. Compare with each of them.",
                {"sum(f >= observed for f in shuffled)": "(shuffled.mean() >= observed) * len(shuffled)"}),
        Mistake("the observed one is not among the shuffled: divide by how many were shuffled.",
                {"len(shuffled)": "(len(shuffled) + 1)"}),
        Mistake("divide by how many were shuffled, len(shuffled). It need not be 2000.", {"len(shuffled)": "2000"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"/": "//"}),
        Mistake("this says whether chance gets that far at all. How often does it?",
                {"sum(f >= observed for f in shuffled) / len(shuffled)": "any(f >= observed for f in shuffled)"}),
        Mistake("this is the largest of the shuffled numbers, compared. How many of them get that far?",
                {"sum(f >= observed for f in shuffled) / len(shuffled)": "observed / max(shuffled)"}),
    ],
    hints=(
        "Go through the shuffled numbers, count those that get as far as the observed one, and divide.",
        "shuffled >= observed is an array of True and False, and the mean of these is a share.",
        "return np.mean(shuffled >= …), or the same with sum and len.",
    ),
    gained="You have written the test behind every p of the paper, and it needs no table and no formula.",
)  # fmt: skip

_draw = np.random.default_rng(14)
GROUPS = [
    [np.array([1.0, 2.0, 4.5]), np.array([5.0, 8.0, 5.5])],
    [np.array([3.0, 4.0]), np.array([4.2, 6.0, 5.0, 7.7, 6.1]), np.array([2.5, 3.5, 3.1])],
    [_draw.normal(mean, 1.0, n).round(1) for mean, n in ((4, 6), (5, 4), (5.5, 8), (4.4, 5))],
    [np.array([2.0, 3.0, 5.0]), np.array([4.0, 4.5, 1.5])],
]

F = "(between / (len(groups) - 1)) / (within / (len(everyone) - len(groups)))"

f_ratio = Exercise(
    task="return F, the mean square between the groups over the mean square within them",
    right=solutions.f_ratio,
    returns="F",
    tape=[{"groups": groups} for groups in GROUPS],
    mistakes=[
        Mistake("upside down: between stands above the line, within below.",
                {F: "(within / (len(everyone) - len(groups))) / (between / (len(groups) - 1))"}),
        Mistake("these are the sums of squares. Divide each by its degrees of freedom first.",
                {F: "between / within"}),
        Mistake("the degrees of freedom have changed places: k − 1 belongs to between, N − k to within.",
                {F: "(between / (len(everyone) - len(groups))) / (within / (len(groups) - 1))"}),
        Mistake("between has k − 1 degrees of freedom, one less than there are groups.",
                {"(len(groups) - 1)": "len(groups)"}),
        Mistake("within has N − k degrees of freedom: all numbers, less one for each group.",
                {"(len(everyone) - len(groups))": "len(everyone)"}),
        Mistake("within has N − k degrees of freedom, and not N − 1: each group has a mean of its own.",
                {"(len(everyone) - len(groups))": "(len(everyone) - 1)"}),
        Mistake("between has k − 1 degrees of freedom and within N − k; here it is k and N.",
                {"(len(groups) - 1)": "len(groups)", "(len(everyone) - len(groups))": "len(everyone)"}),
        Mistake("N is the number of agents in all groups together, not the number in one.",
                {"(len(everyone) - len(groups))": "(len(groups[0]) - 1)"}),
        Mistake("in between, each group counts as often as it has agents: len(g) times the square.",
                {"len(g) * (": "("}),
        Mistake("in between, the mean of each group is compared with the mean of all numbers. (The mean of the means "
                "is another one, where groups differ in size.)",
                {"everyone.mean()": "np.mean([np.mean(h) for h in groups])"}),
        Mistake("within compares each number with the mean of its own group, not with the mean of all.",
                {"(g - np.mean(g))": "(g - everyone.mean())"}),
        Mistake("the squares are missing in between.", {"everyone.mean()) ** 2": "everyone.mean())"}),
        Mistake("within is a sum over all agents, not a mean: leave out the division by the size of each group.",
                {"np.sum((g": "np.mean((g"}),
        Mistake("this is η², the share of the spread that lies between the groups. F divides between by within.",
                {F: "between / (between + within)"}),
        Mistake("this is only the mean square between. Divide it by the mean square within.",
                {F: "between / (len(groups) - 1)"}),
        Mistake("this is only the mean square within. It stands below the line.",
                {F: "within / (len(everyone) - len(groups))"}),
        Mistake("F is the ratio of mean squares: leave out the root.", {F: f"np.sqrt({F})"}),
        Mistake("there need not be three groups: k is len(groups).", {"len(groups)": "3"}),
        Mistake("not only the first two groups count.", {"for g in groups": "for g in groups[:2]"}),
    ],
    hints=(
        "Four numbers: the two sums of squares, and their degrees of freedom. everyone = np.concatenate(groups) helps.",
        "between = sum(len(g) * (g.mean() - everyone.mean()) ** 2 for g in groups); within sums (g − its mean)².",
        "return (between / (len(groups) - 1)) / (within / (… - …))",
    ),
    gained="Any table of an ANOVA is open to you now: you can work out its F yourself.",
)  # fmt: skip

agents_needed = Question(
    task="how many agents of each method it takes",
    right=solutions.agents_needed,
    because="3 · √(2/n) = 0.5 / 3, so √(2/n) = 1/18 and n = 2 · 18² = 648.",
    mistakes=[
        Mistake("the uncertainty of a difference has √(2/n): two means are uncertain, not one.", 324),
        Mistake("648 are enough, to the last agent: 2 · 18².", 649),
        Mistake("that makes the uncertainty as large as the difference itself. It should be a third of it.", 72),
        Mistake("that is for one mean, and an uncertainty as large as the difference.", 36),
        Mistake("solve 3 · √(2/n) = 0.5 / 3 for n: both sides must be squared.", 18),
        Mistake("2 · 18² = 648: is the 2 squared, too? Or is this the number of both methods together?", 1296),
        Mistake("a third of the difference: divide 0.5 by 3, do not multiply.", 8),
        Mistake("that is √(2/n) upside down. Square it, and mind the 2.", 12.727922),
        Mistake("the root must be squared away: n = 2 · 18².", 36 * 2**0.5),
        Mistake("this is 2/n. Solve for n.", 1 / 324),
    ],
    hints=(
        "The uncertainty of the difference should be a third of the difference: write that as an equation.",
        "3 · √(2/n) = 0.5 / 3. Divide by 3, then square both sides.",
        "2/n = (1/18)², so n = 2 · …",
    ),
    gained="Now you can tell how long an experiment must be before you begin it.",
)
