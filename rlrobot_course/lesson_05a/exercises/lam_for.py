"""The λ whose traces last so many steps."""

from __future__ import annotations

import math  # noqa: F401  (a mistake calls it)

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def lam_for(gamma, steps, threshold):
    decay = threshold ** (1 / steps)
    return min(1.0, decay / gamma)


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the λ with which a trace of 1 falls to the threshold in so many steps, 1.0 where none is enough",
    right=lam_for,
    returns="lam",
    tape=[
        dict(zip(("gamma", "steps", "threshold"), row, strict=True))
        for row in (
            (0.9, 10, 0.01),
            (0.95, 84, 0.02),
            (0.9, 210, 0.01),
            (0.99, 210, 0.05),
            (0.8, 5, 0.1),
            (0.99, 1000, 0.01),
            (0.95, 2, 0.1),
        )
    ],
    hints=(
        "in each step a trace is multiplied by γλ. Which number, multiplied with itself n times, gives the threshold?",
        "the n-th root: decay = threshold ** (1 / steps). That is γλ; what is λ? And may it be above 1?",
        "min(1.0, threshold ** (1 / steps) / …)",
    ),
    gained="You can now say how long your robot shall remember, in steps or in seconds, and have the λ for it.",
    mistakes={
        "above_1": Mistake(
            "λ may not be above 1. Where γ alone fades faster than you wish, 1.0 is the best you can do.",
            {"min(1.0, decay / gamma)": "decay / gamma"},
        ),
        "whole_decay": Mistake(
            "this is the whole decay γλ. λ is what remains when you divide it by γ.",
            {"min(1.0, decay / gamma)": "decay"},
        ),
        "times_gamma": Mistake(
            "γλ must be that root, so λ is the root divided by γ, not multiplied.", {"decay / gamma": "decay * gamma"}
        ),
        "power_for_root": Mistake(
            "you took a power where a root is needed: (γλ)ⁿ = threshold, so γλ is the n-th root of the threshold.",
            {"(1 / steps)": "steps"},
        ),
        "gamma_under_the_root": Mistake(
            "γ, too, counts once for each step: first take the root of the threshold, then divide by γ.",
            {"threshold **": "(threshold / gamma) **", "decay / gamma": "decay"},
        ),
        "evenly": Mistake(
            "divided evenly, the threshold would be a sum. It is a product of n equal factors: take the n-th root. "
            "(** comes before /, so 1 / steps needs its brackets.)",
            {"** (1 / steps)": "/ steps"},
        ),
        "logarithm": Mistake(
            "this is the logarithm of γλ. Undo it with the exponential function, then divide by γ.",
            {"min(1.0, decay / gamma)": "math.log(threshold) / steps"},
        ),
        "logarithm_over_gamma": Mistake(
            "a logarithm turns the power into a product, and math.exp turns it back. Without it this is no λ yet.",
            {"decay / gamma": "math.log(threshold) / steps / gamma"},
        ),
        "larger": Mistake(
            "this is the larger of λ and 1. λ may not exceed 1, so you need the smaller: min.", {"min": "max"}
        ),
        "own_gamma": Mistake("γ is an argument, not always 0.9.", {"/ gamma": "/ 0.9"}),
        "own_threshold": Mistake("the threshold is an argument, not always 0.01.", {"threshold **": "0.01 **"}),
        "takes_gamma_off": Mistake(
            "λ is what remains when γ is divided out, not taken off.", {"decay / gamma": "decay - gamma"}
        ),
        "upside_down": Mistake(
            "λ is the root divided by γ. Here it is upside down.", {"decay / gamma": "gamma / decay"}
        ),
        "root_of_n": Mistake(
            "the root of the threshold is asked, not the threshold-th root of n.",
            {"threshold ** (1 / steps)": "steps ** -threshold"},
        ),
        "square_root": Mistake("it is the n-th root, not the square root.", {"(1 / steps)": "0.5"}),
        "nothing_where_it_cannot": Mistake(
            "where even λ = 1 forgets sooner, the answer is 1.0, the longest memory there is, not 0.",
            {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else 0.0)"},
        ),
        "none_where_it_cannot": Mistake(
            "where even λ = 1 forgets sooner, return 1.0.",
            {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else None)"},
        ),
        "no_root": Mistake(
            "the root is missing: (γλ)ⁿ is the threshold, so λⁿ is threshold / γⁿ, and λ is its n-th root.",
            {"decay / gamma": "threshold / gamma**steps"},
        ),
        "gamma_to_the_n": Mistake(
            "the root of the threshold is γλ already, for one step. So divide by γ, not by γ to a power.",
            {"decay / gamma": "decay / gamma**steps"},
        ),
        "gamma_where_it_cannot": Mistake(
            "where even λ = 1 forgets sooner, the answer is 1.0, not γ.",
            {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else gamma)"},
        ),
        "at_most_0_99": Mistake(
            "λ may be 1, but not above: where even λ = 1 forgets sooner, return 1.0.",
            {"min(1.0, decay": "min(0.99, decay"},
        ),
        "text_where_it_cannot": Mistake(
            "where even λ = 1 forgets sooner, return 1.0, a number, and no text.",
            {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else 'none')"},
        ),
        "ten_times_the_steps": Mistake(
            "steps is how many there are already. Do not multiply it by ten once more.",
            {"1 / steps": "1 / (10 * steps)"},
        ),
        "one_step_more": Mistake(
            "a trace of 1 falls in so many steps, not in one more.", {"1 / steps": "1 / (steps + 1)"}
        ),
        "one_step_less": Mistake(
            "a trace of 1 falls in so many steps, not in one fewer.", {"1 / steps": "1 / (steps - 1)"}
        ),
    },
    witnesses=WITNESSES,
)
