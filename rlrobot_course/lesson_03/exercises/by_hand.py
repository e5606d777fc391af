"""The probabilities of ε-greedy with a tie, computed by hand."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

by_hand = [0.3 / 3 + 0.7 / 2, 0.3 / 3, 0.3 / 3 + 0.7 / 2]

exercise = Question(
    task="the three probabilities of ε-greedy, computed by hand",
    right=by_hand,
    because="0.3 / 3 = 0.1 for each action, and the remaining 0.7 in two halves for the two best: 0.1 + 0.35 = 0.45.",
    mistakes={
        "first_alone": Mistake(
            "actions 0 and 2 are equally good. Do not favour the first one: they share 1 − ε.", [0.8, 0.1, 0.1]
        ),
        "one_each": Mistake(
            "these sum to more than 1: the best actions share 1 − ε, not each of them gets it.", [0.8, 0.1, 0.8]
        ),
        "greedy": Mistake("this is greedy: it never explores. Each action first gets its part of ε.", [0.5, 0.0, 0.5]),
        "explores_the_others": Mistake(
            "to explore is to take any action, also one of the best. Divide ε by 3.", [0.35, 0.3, 0.35]
        ),
        "no_share_for_the_best": Mistake(
            "these sum to less than 1: the best actions, too, get their part of ε.", [0.35, 0.1, 0.35]
        ),
        "last_alone": Mistake(
            "actions 0 and 2 are equally good. Do not favour the last one: they share 1 − ε.", [0.1, 0.1, 0.8]
        ),
        "share_alone": Mistake(
            "this is the share of ε alone. The best two have 1 − ε on top, half each.", [0.1, 0.1, 0.1]
        ),
        "whole_epsilon_each": Mistake(
            "the sum is above 1. Divide ε by 3, the number of actions, before you add it.", [0.65, 0.3, 0.65]
        ),
        "half_each": Mistake("each of the best gets only half of 1 − ε.", [0.7, 0.3, 0.7]),
        "epsilon_swapped": Mistake(
            "ε and 1 − ε have changed places: ε is the probability to explore.",
            [0.7 / 3 + 0.15, 0.7 / 3, 0.7 / 3 + 0.15],
        ),
        "a_third_each": Mistake(
            "this gives each best action a third of 1 − ε. There are two of them: half each.",
            [0.1 + 0.7 / 3, 0.1, 0.1 + 0.7 / 3],
        ),
        "equal": Mistake("these are equal shares. The best two get 1 − ε on top of ε / 3.", [1 / 3, 1 / 3, 1 / 3]),
        "worst": Mistake("action 1 is the worst here, not the best.", [0.1, 0.8, 0.1]),
        "four_actions": Mistake("there are three actions here, not four: each gets ε / 3.", [0.425, 0.075, 0.425]),
        "twice_the_share": Mistake(
            "action 1 gets its ε / 3 = 0.1 and nothing more. What remains goes to the two best.", [0.4, 0.2, 0.4]
        ),
        "half_the_share": Mistake(
            "they sum to 1, but to explore is to take any action: action 1 has ε / 3.", [0.475, 0.05, 0.475]
        ),
        "best_alone": Mistake(
            "action 1 has its part of ε, too: ε / 3. To explore is to take any action.", [0.45, 0.0, 0.45]
        ),
        "share_forgotten": Mistake(
            "these are the halves of 1 − ε. What of ε itself? Each action, also a best one, gets ε / 3 on top.",
            [0.35, 0.0, 0.35],
        ),
        "unequal_best": Mistake(
            "the two best are equally good, and get the same: half of 1 − ε each.", [0.55, 0.1, 0.35]
        ),
        "never_explores": Mistake(
            "this never explores, and it leaves out that action 2 is as good as action 0.", [1.0, 0.0, 0.0]
        ),
        "graded_by_q": Mistake(
            "Q does not grade them: the best two share 1 − ε, and each action gets ε / 3.", [4 / 9, 1 / 9, 4 / 9]
        ),
    },
    hints=(
        "Each action gets its part of ε. What remains, 1 − ε, goes to the best. How many are they?",
        "ε / A = 0.3 / 3. The two best share 1 − 0.3 = 0.7.",
        "The list is [0.1 + 0.7 / …, 0.1, 0.1 + 0.7 / …].",
    ),
    gained="They sum to 1, and the tie is shared. That is more than many published programs do.",
    witnesses={
        "first_alone": [(0.8, 0.1, 0.1)],
        "one_each": [(0.8, 0.1, 0.8)],
        "greedy": [(0.5, 0, 0.5)],
        "explores_the_others": [(0.35, 0.3, 0.35)],
        "no_share_for_the_best": [np.array([0.35, 0.1, 0.35])],
        "twice_the_share": [[0.4, 0.2, 0.4]],
        "unequal_best": [[0.55, 0.1, 0.35]],
        "never_explores": [[1, 0, 0]],
        "best_alone": [[0.45, 0, 0.45]],
        "share_forgotten": [[0.35, 0, 0.35]],
    },
)
