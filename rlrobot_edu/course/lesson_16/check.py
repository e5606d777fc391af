"""Exercises of lesson 16: an imagined step by hand, Dyna's loop, two rulers, and what is biased about the bias."""

from __future__ import annotations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_16 import solutions
from rlrobot_edu.course.lesson_16.dyna_check import dyna
from rlrobot_edu.course.lesson_16.overlaps_check import overlaps

__all__ = ["by_hand", "dyna", "overlaps", "two_biases"]

by_hand = Question(
    task="Q(A, right) after the three imagined steps",
    right=solutions.by_hand,
    because="The first changes nothing, for B was worth 0. The second: 0.5 · 0.9 · 0.5 = 0.225. The third: "
    "0.5 · 0.9 · 0.225.",
    mistakes=[
        Mistake("so it is after the first imagined step, when B is still worth nothing. But (A, right) comes once "
                "more, after (B, right).", 0),
        Mistake("this is Q(B, right), after the second. The third imagined step builds on it.", 0.225),
        Mistake("one α is missing: Q(C, right) is 0.5, and an imagined step closes only half of the gap, too.", 0.2025),
        Mistake("both α are missing: an imagined step closes only half of the gap, as a real one.", 0.405),
        Mistake("both γ are missing: what comes one step later counts 0.9 times.", 0.125),
        Mistake("one γ is missing: what comes one step later counts 0.9 times, in each of the two steps.", 0.1125),
        Mistake("this is 0.9 · 0.5, the target of (B, right). Q moves half of the way to it.", 0.45),
        Mistake("the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
                0.5 * (1 + 0.9 * 0.5 * (1 + 0.45))),
        Mistake("the reward of 1 came at the goal alone. What was seen after (A, right) and (B, right) paid 0.",
                0.5 + 0.5 * (1 + 0.9 * 0.725 - 0.5)),
        Mistake("this is Q(C, right), what the real step has taught. How far does it get back in thought?", 0.5),
        Mistake("after its first time Q(A, right) is 0, not half of something: B was worth nothing then.",
                0.5 * 0.225 + 0.5 * 0.9 * 0.225),
        Mistake("nearly: 0.1 is rounded too far. Give a digit or two more, or the formula itself.", 0.1),
    ],
    hints=(
        "Do one after the other, as if they were real steps: target 0 + 0.9 · the best of s′, and half of the way.",
        "(A, right): B is worth 0, nothing changes. (B, right): half of the way to 0.9 · 0.5. And then A again.",
        "0.5 * 0.9 * Q(B, right), and Q(B, right) is 0.5 * 0.9 * 0.5 by now.",
    ),
    gained="Three thoughts, and one of them changed nothing: the order of thoughts matters. Keep that for section 2.",
)  # fmt: skip

two_biases = Question(
    task="the paper's bias, and the one weighed by visits, as (…, …)",
    right=solutions.two_biases,
    because="½ · (12/4 + 2/4) = 1.75, and (6 + 10 + 6) / 7 = 3.14. What was never tried pulls the first towards 0.",
    mistakes=[
        Mistake("these are the right numbers in the wrong order: the paper's first.", (22 / 7, 1.75)),
        Mistake("the second is right. In the first the states that were never visited count, too, with their 0: each "
                "set has four members.", (4.0, 22 / 7)),
        Mistake("the second is right. s is a member of both sets: the second set's mean is 2/4, not 0.",
                (1.5, 22 / 7)),
        Mistake("the second is right. The first is the mean of the two sets' means, not their sum.", (3.5, 22 / 7)),
        Mistake("the second is right. In the first s itself is a member of its sets.", (5 / 3, 22 / 7)),
        Mistake("the second is right. In the first each set gives a mean of four, and then comes their mean.",
                (14 / 8 * 4, 22 / 7)),
        Mistake("the first is right. In the second s counts in both of its sets: 3 · 2 and its 3 visits twice.",
                (1.75, 4.0)),
        Mistake("the first is right. The second is one sum over both sets, divided by all their visits: not the mean "
                "of two means.", (1.75, 3.0)),
        Mistake("the first is right. In the second each value counts as often as it was visited.", (1.75, 14 / 3)),
        Mistake("the first is right. Divide the second by the visits, 3 + 1 + 3, not by the number of members.",
                (1.75, 22 / 8)),
        Mistake("the first is right. The second is still to be divided by the visits, 3 + 1 + 3.", (1.75, 22.0)),
    ],
    hints=(
        "Write down the two sets, four states each, with s in both. First means of four; then sums weighed by visits.",
        "First: the mean of (2 + 10 + 0 + 0) / 4 and (2 + 0 + 0 + 0) / 4. Second: N · Q summed over both sets, divided "
        "by the sum of N.",
        "(((2 + 10) / 4 + 2 / 4) / 2, (3 * 2 + 1 * 10 + 3 * 2) / …)",
    ),
    gained="Here the weighing nearly doubles the bias. Whether that is better, only robots can say.",
)  # fmt: skip
