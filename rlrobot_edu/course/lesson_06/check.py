"""Exercises of lesson 06: true online SARSA(λ). That on its update stands in `update_check`."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_06 import solutions
from rlrobot_edu.course.lesson_06.update_check import true_online_update

__all__ = ["by_hand", "dutch", "true_online_update"]

dutch = Exercise(
    task="return the trace of the pair that is visited now",
    right=solutions.dutch,
    returns="e",
    tape=[
        {"e": e, "alpha": alpha}
        for e, alpha in ((0.813, 0.3), (0.0, 0.5), (1.377, 0.12), (2.37, 0.25), (1.4, 1.0), (0.53, 0.0))
    ],
    mistakes=[
        Mistake("this is the replacing trace. The dutch one keeps the share 1 − α of what was there, and may be "
                "above 1.",
                {"(1 - alpha) * e + 1": "1.0"}),
        Mistake("this is the accumulating trace. The dutch one keeps only the share 1 − α of what was there.",
                {"(1 - alpha) * ": ""}),
        Mistake("α is the share that is lost. The share that stays is 1 − α.", {"(1 - alpha)": "alpha"}),
        Mistake("the new visit is missing: it adds 1.", {" + 1": ""}),
        Mistake("only the old trace shrinks. The 1 of the new visit is added afterwards, in full.",
                {"e + 1": "(e + 1)"}),
        Mistake("the new visit adds 1, not α. The learning rate comes in at the update.", {"+ 1": "+ alpha"}),
        Mistake("the brackets: 1 − α is multiplied by e, not α · e subtracted from 1.",
                {"(1 - alpha) * e + 1": "1 - alpha * e"}),
        Mistake("a share of the trace is lost, not α itself: (1 − α) times e.",
                {"(1 - alpha) * e + 1": "e - alpha + 1"}),
        Mistake("1 − α is smaller than 1: the old trace shrinks. Here it grows.", {"1 - alpha": "1 + alpha"}),
        Mistake("this is the larger one of the old trace and 1. The new visit adds its 1 to what is left of the old.",
                {"(1 - alpha) * e + 1": "max(e, 1)"}),
        Mistake("the new visit is added to what is left of the old trace; here the larger of the two is taken.",
                {"(1 - alpha) * e + 1": "max(1, (1 - alpha) * e)"}),
        Mistake("a trace below 1 shrinks and gains 1 like any other: no if is needed.",
                {"(1 - alpha) * e + 1": "(1 - alpha) * e + 1 if e > 1 else 1"}),
        Mistake("this takes the mean of old and new, with α for the old trace. Keep the share 1 − α of the old one, "
                "and add 1 in full.", {"(1 - alpha) * e + 1": "alpha * e + 1 - alpha"}),
        Mistake("the old trace is divided by 1 − α, so it grows. Multiply.", {"(1 - alpha) * e": "e / (1 - alpha)"}),
        Mistake("the old trace is divided by 1 + α. It is multiplied by 1 − α.",
                {"(1 - alpha) * e": "e / (1 + alpha)"}),
        Mistake("1 is taken off here. The new visit adds it.", {"e + 1": "e - 1"}),
        Mistake("that a trace fades by γλ is not this function's job: it happens to all traces, at the end of the "
                "step.", {"(1 - alpha) * e + 1": "0.81 * ((1 - alpha) * e + 1)"}),
        Mistake("that a trace fades by γλ is not this function's job: it happened at the end of the step before.",
                {"(1 - alpha) * e + 1": "(1 - alpha) * 0.81 * e + 1"}),
        Mistake("e and α have changed places.", {"(1 - alpha) * e": "(1 - e) * alpha"}),
        Mistake("a share is multiplied, not raised to a power: (1 − α) · e.", {"* e": "** e"}),
    ],
    hints=(
        "A part of the old trace stays, and the visit that happens now adds 1. Which part stays?",
        "An update keeps the share 1 − α of what was in Q, so the trace keeps the same share.",
        "return (1 - alpha) * … + 1",
    ),
    gained="One line between forgetting and piling up: with α = 1 it replaces, with α = 0 it accumulates. Your update "
    "below is built on it.",
)  # fmt: skip

by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=solutions.by_hand,
    because="e = 0.75 · 0.6 + 1 = 1.45 and δ = 10 + 0.9 · 10 − 6 = 13. So 6 + 0.25 · (13 + 6 − 4) · 1.45 = 11.4375, "
    "and from this 0.25 · (6 − 4) = 0.5 is taken off.",
    mistakes=[
        Mistake("you stopped after the first line. Now take off α · (Q(s, a) − Q_old).", 11.4375),
        Mistake("the first line needs δ + Q(s, a) − Q_old, not δ alone.", 10.2125),
        Mistake("this has neither of the two new terms: it is SARSA(λ) with a dutch trace.", 10.7125),
        Mistake("this is what a trace of 1 gives (the two new terms then cancel). The trace here is (1 − α) · 0.6 + 1.",
                9.25),
        Mistake("this is what an accumulating trace of 1.6 gives. The dutch trace is (1 − α) · 0.6 + 1.", 11.5),
        Mistake("this is what a trace of 0.6 gives. The pair is visited now, so its trace is (1 − α) · 0.6 + 1.", 7.75),
        Mistake("here the trace keeps the share α. The share that stays is 1 − α.", 9.8125),
        Mistake("only the old trace shrinks: (1 − α) · 0.6, and then 1 is added in full.", 10.0),
        Mistake("in the second line Q(s, a) is the value before this step, 6, not the 11.4375 you have just computed.",
                9.578125),
        Mistake("the second term is taken off, not added.", 11.9375),
        Mistake("this is SARSA(λ) with an accumulating trace. Take the four lines above, one by one.", 11.2),
        Mistake("γ is missing: δ = r + γ · Q(s', a') − Q(s, a).", 11.3),
        Mistake("δ lacks Q(s', a'). This step is not the last of its episode.", 7.675),
        Mistake("δ = r + γ · Q(s', a') − Q(s, a): you have left out the last part.", 13.1125),
        Mistake("this is the change alone. Asked is the new value: 6 and the change.", 4.9375),
        Mistake("α is missing in the first line.", 27.25),
        Mistake("α is missing in the second line.", 9.4375),
        Mistake("the bracket of the first line is δ + Q(s, a) − Q_old: here the last two have changed places.", 9.4875),
        Mistake("the trace of 0.6 is what the step before has left: it fades again only at the end of this one.",
                6 + 0.25 * 15 * (0.75 * 0.81 * 0.6 + 1) - 0.5),
        Mistake("α is not added to the trace. It shrinks to the share 1 − α, and then 1 is added.",
                6 + 0.25 * 15 * 0.85 - 0.5),
        Mistake("the reward is missing in δ.", 6 + 0.25 * 5 * 1.45 - 0.5),
        Mistake("α and γ have changed places: α is 0.25.", 6 + 0.9 * (6.5 + 2) * 1.06 - 0.9 * 2),
    ],
    hints=(
        "Four small calculations in the order of the four lines: trace, δ, first line, second line.",
        "e = 0.75 · 0.6 + 1 and δ = 10 + 0.9 · 10 − 6. The bracket of the first line is δ + 6 − 4.",
        "6 + 0.25 · (13 + 6 − 4) · 1.45 − 0.25 · (6 − 4)",
    ),
    gained="What you have just done on paper, your code will do thousands of times.",
)  # fmt: skip
