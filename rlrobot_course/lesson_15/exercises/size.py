"""How many states a design has, and how often each is met."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

size = [3 * 4 * 2 * 8, 3600 / (3 * 4 * 2 * 8)]

STATES, STEPS = 3 * 4 * 2 * 8, 3600

exercise = Question(
    task="the number of states, and how many of 3600 steps each gets on average",
    right=size,
    because="3 · 4 · 2 · 8 = 192 states, and 3600 / 192 = 18.75 steps for each: about two for each action.",
    mistakes={
        "cuts_as_bins": Mistake(
            "k cut points make k + 1 bins: 2 cuts are 3 bins, 3 cuts 4, 1 cut 2. The sectors are 8 already.",
            [2 * 3 * 1 * 8, STEPS / (2 * 3 * 1 * 8)],
        ),
        "nine_sectors": Mistake(
            "8 sectors of a circle are 8 bins: a circle has no ends.", [3 * 4 * 2 * 9, STEPS / (3 * 4 * 2 * 9)]
        ),
        "sum": Mistake(
            "the bins multiply, for every bin of one input may come with every bin of another.",
            [3 + 4 + 2 + 8, STEPS / (3 + 4 + 2 + 8)],
        ),
        "no_heading": Mistake(
            "the heading makes states, too: all four inputs count.", [3 * 4 * 2, STEPS / (3 * 4 * 2)]
        ),
        "pairs": Mistake(
            "these are pairs of a state and an action. Asked are states, and how often each is met.",
            [STATES * 9, STEPS / (STATES * 9)],
        ),
        "mean_of_a_pair": Mistake(
            "the states are right. The second number is for a state, not for each of its nine actions.",
            [STATES, STEPS / (STATES * 9)],
        ),
        "upside_down": Mistake(
            "the states are right. The second number is upside down: steps divided by states.", [STATES, STATES / STEPS]
        ),
        "rounded_down": Mistake(
            "the states are right. The mean is 3600 / 192 and need not be a whole number.", [STATES, 18]
        ),
        "rounded_up": Mistake(
            "the states are right. The mean is 3600 / 192 and need not be a whole number.", [STATES, 19]
        ),
        "swapped": Mistake("the right numbers have changed places: the states come first.", [STEPS / STATES, STATES]),
    },
    hints=(
        "How many bins has each of the four inputs? Then multiply.",
        "k cut points make k + 1 bins; 8 sectors are 8. So there are 3 · 4 · 2 · 8 states.",
        "size = [3 * 4 * 2 * 8, 3600 / (3 * 4 * 2 * 8)]",
    ),
    gained="Two lines of arithmetic before the first run save many hours after it.",
    witnesses={
        "cuts_as_bins": [[48, 75]],
        "nine_sectors": [[216, 16.6667]],
        "sum": [[17, 211.76]],
        "pairs": [[1728, 2.08333]],
        "mean_of_a_pair": [[192, 2.08333]],
        "swapped": [(18.75, 192)],
    },
)
