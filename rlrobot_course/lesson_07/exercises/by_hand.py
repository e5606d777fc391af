"""The bias of a state, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

by_hand = ((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 - 1) / 3 + (5 - 8) / 2) / 4

exercise = Question(
    task="the bias for spin right in state 21, computed by hand",
    right=by_hand,
    because="The means are 7.5 (X), 3.5 (Y), 6 (theta) and −1.5 (d), and the mean of these four is 15.5 / 4 = 3.875.",
    mistakes={
        "sum_of_means": Mistake(
            "this is the sum of the four means. The bias is their mean: divide by the number of inputs.", 15.5
        ),
        "without_s": Mistake("you left the state itself out of its sets. It is a member of each of the four.", 2.625),
        "mean_of_the_union": Mistake(
            "this is one mean over all six states. Take a mean for each input first, and then the mean of the "
            "four: theta has three members, the others two.",
            22 / 6,
        ),
        "mean_of_all_members": Mistake(
            "this is one mean over all nine members. Take a mean for each input first, and then the mean of the "
            "four: theta has three members, the others two.",
            37 / 9,
        ),
        "adds_q": Mistake("this is Q(s) + bias(s). Asked is the bias alone.", 8.875),
        "mean_of_the_others": Mistake(
            "this is the mean over the five other states, all at once. Take a mean for each input first, the "
            "state itself included.",
            3.4,
        ),
        "wrong_mean_of_theta": Mistake("the set of theta has three members, so its mean is 18 / 3 = 6.", 4.625),
        "sums_of_sets": Mistake(
            "each set's values are to be divided by the number of its members: a mean, not a sum.", 9.25
        ),
        "d_without_sign": Mistake("the set of d has −8 in it, not 8.", (7.5 + 3.5 + 6 + 6.5) / 4),
        "theta_without_sign": Mistake("the set of theta has −1 in it, not 1.", (7.5 + 3.5 + 20 / 3 - 1.5) / 4),
        "q_itself": Mistake("this is Q(s) itself. What do the sets say?", 5),
        "divides_by_five": Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 5),
        "divides_by_six": Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 6),
        "divides_by_three": Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 3),
        "sum_over_members": Mistake("take a mean for each input first: of two members, or of three.", 22 / 4),
        "theta_summed": Mistake(
            "the state itself is a member of every set, and the set of theta gives a mean, not a sum.", 17 / 4
        ),
        "without_s_in_one_mean": Mistake(
            "the state itself belongs to its sets; and take a mean for each input first.", 17 / 6
        ),
        "theta_without_s": Mistake(
            "either this is rounded too far, or the state itself is missing in the set of theta. Give the formula.", 4
        ),
        "brackets": Mistake("brackets are missing: the sum of all four means is divided by 4.", 16.625),
        "not_theta": Mistake("the set of theta is missing: there are four inputs.", 9.5 / 3),
        "median_of_theta": Mistake("of the set of theta the mean is asked, 18 / 3, not the median.", 14.5 / 4),
        "not_d": Mistake("the set of d is missing: there are four inputs.", 17 / 3),
        "without_signs": Mistake(
            "two values are negative: −1 in the set of theta, −8 in that of d.", (7.5 + 3.5 + 20 / 3 + 6.5) / 4
        ),
    },
    hints=(
        "Four means, one for each input, then the mean of these four. The state itself is in every set.",
        "X: (5 + 10) / 2. theta has three members: (5 + 14 − 1) / 3.",
        "((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 − 1) / 3 + (5 − 8) / 2) / 4",
    ),
    gained="Four opinions have become one. Next you let the computer ask them.",
    witnesses={
        "sum_of_means": [7.5 + 3.5 + 6 - 1.5],
        "without_s": [(10 + 2 + (14 - 1) / 2 - 8) / 4],
        "mean_of_the_union": [(5 + 10 + 2 + 14 - 1 - 8) / 6],
        "adds_q": [5 + 3.875],
        "mean_of_all_members": [(4 * 5 + 10 + 2 + 14 - 1 - 8) / 9],
        "mean_of_the_others": [(10 + 2 + 14 - 1 - 8) / 5],
        "theta_without_s": [(7.5 + 3.5 + 13 / 2 - 1.5) / 4],
        "brackets": [7.5 + 3.5 + 6 - 1.5 / 4],
        "form": [3.9],
    },
)
