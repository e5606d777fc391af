"""For how many steps a trace stays above a threshold."""

from __future__ import annotations

import math

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_edu.learning.memory import trace_steps


def n_traces(gamma, lam, threshold):
    return math.floor(math.log(threshold) / math.log(gamma * lam))


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the largest whole number n of steps after which (γλ)ⁿ is still above the threshold",
    right=n_traces,
    library=trace_steps,
    returns="n",
    tape=[
        dict(zip(("gamma", "lam", "threshold"), row, strict=True))
        for row in (
            (0.9, 0.9, 0.01),
            (0.9, 0.5, 0.01),
            (0.99, 0.95, 0.002),
            (0.95, 0.9, 0.1),
            (0.5, 0.6, 0.05),
            (0.6, 0.5, 0.4),
            (0.85, 0.97, 0.6),
            (0.2, 0.5, 0.9),
        )
    ],
    hints=(
        "after n steps a trace is (γλ)ⁿ. For which n is that still above the threshold?",
        "n must be below log(threshold) / log(γλ). Which whole number is the largest below it?",
        "math.floor(math.log(threshold) / math.log(…)), or a loop that multiplies by γλ as long as it stays above",
    ),
    gained="22 states instead of 1024: in each step, so much less is to be updated.",
    mistakes={
        "rounds_up": Mistake(
            "one too many: after that many steps the trace has already crossed the threshold. Round down.",
            {"math.floor": "math.ceil"},
        ),
        "rounds": Mistake(
            "rounding to the nearest number can go up, past the threshold. Round down.", {"math.floor": "round"}
        ),
        "bound_itself": Mistake(
            "this is the bound itself, and steps are whole numbers. Round it down.", {"math.floor": ""}
        ),
        "no_lambda": Mistake("you forgot λ: a trace fades by γ · λ in each step.", {" * lam": ""}),
        "no_gamma": Mistake("you forgot γ: a trace fades by γ · λ in each step.", {"gamma * ": ""}),
        "upside_down": Mistake(
            "the logarithms have changed places: it is log(threshold) divided by log(γλ).",
            {"threshold": "gamma * lam", "gamma * lam": "threshold"},
        ),
        "logs_multiplied": Mistake(
            "the logarithm of γλ is log(γ) + log(λ), not their product.",
            {"math.log(gamma * lam)": "(math.log(gamma) * math.log(lam))"},
        ),
        "logs_multiplied_and_cut": Mistake(
            "the logarithm of γλ is log(γ) + log(λ), not their product.",
            {"math.log(gamma * lam)": "(math.log(gamma) * math.log(lam))", "math.floor": "int"},
        ),
        "evenly": Mistake(
            "a trace does not lose the same amount in each step, but the same share. That is a power, and it "
            "takes a logarithm to undo it.",
            {"math.log(threshold) / math.log(gamma * lam)": "(1 - threshold) / (1 - gamma * lam)"},
        ),
        "one_too_few": Mistake(
            "one too few: after one more step the trace is still above the threshold.",
            {"return math.floor(": "return -1 + math.floor("},
        ),
        "mean_of_both": Mistake(
            "γ and λ are multiplied, not added: a trace fades by γ · λ in each step.",
            {"gamma * lam": "(gamma + lam) / 2"},
        ),
        "negative": Mistake(
            "the sign is the wrong way round: both logarithms are negative, so n is positive.",
            {"return math.floor(": "return -math.floor("},
        ),
        "own_threshold": Mistake(
            "it is the threshold that (γλ)ⁿ must stay above, not always 0.01.",
            {"math.log(threshold)": "math.log(0.01)"},
        ),
        "own_rates": Mistake("γ and λ are arguments, not always 0.9.", {"gamma * lam": "0.81"}),
        "subtracts_logs": Mistake(
            "the logarithms are divided, not subtracted: n · log(γλ) is to be log(threshold).",
            {"math.log(threshold) / math.log(gamma * lam)": "math.log(gamma * lam) - math.log(threshold)"},
        ),
        "lambda_alone_to_the_n": Mistake(
            "a power is computed before a product: gamma * lam ** n is γ · λⁿ. Brackets: (gamma * lam) ** n.",
            {
                "math.floor(math.log(threshold) / math.log(gamma * lam))": (
                    "max(-1, math.floor(math.log(threshold / gamma) / math.log(lam)))"
                )
            },
        ),
        "one_too_few_from_0": Mistake(
            "one too few: after one more step the trace is still above the threshold.",
            {
                "return math.floor(math.log(threshold) / math.log(gamma * lam))": (
                    "return max(0, math.floor(math.log(threshold) / math.log(gamma * lam)) - 1)"
                )
            },
        ),
        "search_ends": Mistake(
            "the search ends too soon: with other arguments n is above 99.",
            {"return math.floor(": "return min(99, math.floor(", "lam))": "lam)))"},
        ),
        "two_kinds_of_logs": Mistake(
            "these are logarithms of two kinds. Take the same one above and below the line.",
            {"math.log(threshold)": "math.log10(threshold)"},
        ),
        "list_of_all": Mistake(
            "these are all the n for which it is above the threshold. Asked is the largest of them.",
            {
                "return math.floor(math.log(threshold) / math.log(gamma * lam))": (
                    "return list(range(math.floor(math.log(threshold) / math.log(gamma * lam)) + 1))"
                )
            },
        ),
        "adds_rates": Mistake(
            "γ and λ are multiplied, not added: a trace fades by γ · λ in each step.",
            {
                "return math.floor(math.log(threshold) / math.log(gamma * lam))": (
                    "return int(math.log(threshold) / math.log(gamma + lam))"
                )
            },
        ),
        "at_least_1": Mistake(
            "n may be 0: where the trace falls below the threshold in one step, no step is left.",
            {
                "return math.floor(math.log(threshold) / math.log(gamma * lam))": (
                    "return max(1, math.floor(math.log(threshold) / math.log(gamma * lam)))"
                )
            },
        ),
    },
    witnesses=WITNESSES,
)
