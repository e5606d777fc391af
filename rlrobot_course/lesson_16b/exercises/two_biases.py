"""The biases of OBIASSR and VBIASSR, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

two_biases = (((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 1 * 10 + 3 * 2) / (3 + 1 + 3))

exercise = Question(
    task="the paper's bias, and the one weighed by visits, as (…, …)",
    right=two_biases,
    because="½ · (12/4 + 2/4) = 1.75, and (6 + 10 + 6) / 7 = 3.14. What was never tried pulls the first towards 0.",
    mistakes={
        "swapped": Mistake("these are the right numbers in the wrong order: the paper's first.", (22 / 7, 1.75)),
        "unvisited_left_out": Mistake(
            "the second is right. In the first the states that were never visited count, too, with their 0: each "
            "set has four members.",
            (4.0, 22 / 7),
        ),
        "first_without_s": Mistake(
            "the second is right. s is a member of both sets: the second set's mean is 2/4, not 0.", (1.5, 22 / 7)
        ),
        "first_summed": Mistake(
            "the second is right. The first is the mean of the two sets' means, not their sum.", (3.5, 22 / 7)
        ),
        "s_not_a_member": Mistake(
            "the second is right. In the first s itself is a member of its sets.", (5 / 3, 22 / 7)
        ),
        "first_of_four": Mistake(
            "the second is right. In the first each set gives a mean of four, and then comes their mean.",
            (14 / 8 * 4, 22 / 7),
        ),
        "s_twice_in_the_second": Mistake(
            "the first is right. In the second s counts in both of its sets: 3 · 2 and its 3 visits twice.", (1.75, 4.0)
        ),
        "one_mean_for_both": Mistake(
            "the first is right. The second is one sum over both sets, divided by all their visits: not the mean "
            "of two means.",
            (1.75, 3.0),
        ),
        "by_visits": Mistake(
            "the first is right. In the second each value counts as often as it was visited.", (1.75, 14 / 3)
        ),
        "divided_by_members": Mistake(
            "the first is right. Divide the second by the visits, 3 + 1 + 3, not by the number of members.",
            (1.75, 22 / 8),
        ),
        "not_divided": Mistake(
            "the first is right. The second is still to be divided by the visits, 3 + 1 + 3.", (1.75, 22.0)
        ),
    },
    hints=(
        "Write down the two sets, four states each, with s in both. First means of four; then sums weighed by visits.",
        "First: the mean of (2 + 10 + 0 + 0) / 4 and (2 + 0 + 0 + 0) / 4. Second: N · Q summed over both sets, divided "
        "by the sum of N.",
        "(((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 1 * 10 + 3 * 2) / …)",
    ),
    gained="Here the weighing nearly doubles the bias. Whether that is better, only robots can say.",
    witnesses={
        "swapped": [(22 / 7, 1.75)],
        "unvisited_left_out": [(4.0, 22 / 7)],
        "s_twice_in_the_second": [(1.75, 4.0)],
        "one_mean_for_both": [(1.75, 3.0)],
        "first_summed": [(3.5, 22 / 7)],
    },
)
