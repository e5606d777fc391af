"""The dutch trace."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def dutch(e, alpha):
    return (1 - alpha) * e + 1


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the trace of the pair that is visited now",
    right=dutch,
    returns="e",
    tape=[
        {"e": e, "alpha": alpha}
        for e, alpha in ((0.813, 0.3), (0.0, 0.5), (1.377, 0.12), (2.37, 0.25), (1.4, 1.0), (0.53, 0.0))
    ],
    mistakes={
        "replaces": Mistake(
            "this is the replacing trace. The dutch one keeps the share 1 − α of what was there, and may be above 1.",
            {"(1 - alpha) * e + 1": "1.0"},
        ),
        "accumulates": Mistake(
            "this is the accumulating trace. The dutch one keeps only the share 1 − α of what was there.",
            {"(1 - alpha) * ": ""},
        ),
        "keeps_alpha": Mistake("α is the share that is lost. The share that stays is 1 − α.", {"(1 - alpha)": "alpha"}),
        "no_visit": Mistake("the new visit is missing: it adds 1.", {" + 1": ""}),
        "shrinks_the_visit": Mistake(
            "only the old trace shrinks. The 1 of the new visit is added afterwards, in full.", {"e + 1": "(e + 1)"}
        ),
        "adds_alpha": Mistake(
            "the new visit adds 1, not α. The learning rate comes in at the update.", {"+ 1": "+ alpha"}
        ),
        "brackets": Mistake(
            "the brackets: 1 − α is multiplied by e, not α · e subtracted from 1.",
            {"(1 - alpha) * e + 1": "1 - alpha * e"},
        ),
        "takes_alpha_off": Mistake(
            "a share of the trace is lost, not α itself: (1 − α) times e.", {"(1 - alpha) * e + 1": "e - alpha + 1"}
        ),
        "one_plus_alpha": Mistake(
            "1 − α is smaller than 1: the old trace shrinks. Here it grows.", {"1 - alpha": "1 + alpha"}
        ),
        "larger_of_both": Mistake(
            "this is the larger one of the old trace and 1. The new visit adds its 1 to what is left of the old.",
            {"(1 - alpha) * e + 1": "max(e, 1)"},
        ),
        "larger_after_shrinking": Mistake(
            "the new visit is added to what is left of the old trace; here the larger of the two is taken.",
            {"(1 - alpha) * e + 1": "max(1, (1 - alpha) * e)"},
        ),
        "only_above_1": Mistake(
            "a trace below 1 shrinks and gains 1 like any other: no if is needed.",
            {"(1 - alpha) * e + 1": "(1 - alpha) * e + 1 if e > 1 else 1"},
        ),
        "mean_of_both": Mistake(
            "this takes the mean of old and new, with α for the old trace. Keep the share 1 − α of the old one, "
            "and add 1 in full.",
            {"(1 - alpha) * e + 1": "alpha * e + 1 - alpha"},
        ),
        "divides": Mistake(
            "the old trace is divided by 1 − α, so it grows. Multiply.", {"(1 - alpha) * e": "e / (1 - alpha)"}
        ),
        "divides_by_one_plus": Mistake(
            "the old trace is divided by 1 + α. It is multiplied by 1 − α.", {"(1 - alpha) * e": "e / (1 + alpha)"}
        ),
        "takes_1_off": Mistake("1 is taken off here. The new visit adds it.", {"e + 1": "e - 1"}),
        "fades_after": Mistake(
            "that a trace fades by γλ is not this function's job: it happens to all traces, at the end of the step.",
            {"(1 - alpha) * e + 1": "0.81 * ((1 - alpha) * e + 1)"},
        ),
        "fades_before": Mistake(
            "that a trace fades by γλ is not this function's job: it happened at the end of the step before.",
            {"(1 - alpha) * e + 1": "(1 - alpha) * 0.81 * e + 1"},
        ),
        "swapped": Mistake("e and α have changed places.", {"(1 - alpha) * e": "(1 - e) * alpha"}),
        "brackets_and_the_visit": Mistake(
            "the brackets are missing: (1 - alpha) * e. Without them only alpha is multiplied by e.",
            {"(1 - alpha) * e + 1": "1 - alpha * e + 1"},
        ),
        "share_turned_round": Mistake("the share that stays is 1 − α, not α − 1.", {"1 - alpha": "alpha - 1"}),
        "power": Mistake("a share is multiplied, not raised to a power: (1 − α) · e.", {"* e": "** e"}),
    },
    hints=(
        "A part of the old trace stays, and the visit that happens now adds 1. Which part stays?",
        "An update keeps the share 1 − α of what was in Q, so the trace keeps the same share.",
        "return (1 - alpha) * … + 1",
    ),
    gained="One line between forgetting and piling up: with α = 1 it replaces, with α = 0 it accumulates. Your update "
    "below is built on it.",
    witnesses=WITNESSES,
)
