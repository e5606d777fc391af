"""Exercises of lesson 05a: how many traces are enough, and how long a memory lasts."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.lesson_05a import solutions
from rlrobot_edu.learning.memory import trace_steps

n_traces = Exercise(
    task="return the largest whole number n of steps after which (γλ)ⁿ is still above the threshold",
    right=solutions.n_traces,
    library=trace_steps,
    returns="n",
    tape=[
        dict(zip(("gamma", "lam", "threshold"), row, strict=True))
        for row in ((0.9, 0.9, 0.01), (0.9, 0.5, 0.01), (0.99, 0.95, 0.002), (0.95, 0.9, 0.1), (0.5, 0.6, 0.05),
                    (0.6, 0.5, 0.4), (0.85, 0.97, 0.6), (0.2, 0.5, 0.9))
    ],
    hints=(
        "after n steps a trace is (γλ)ⁿ. For which n is that still above the threshold?",
        "n must be below log(threshold) / log(γλ). Which whole number is the largest below it?",
        "math.floor(math.log(threshold) / math.log(…)), or a loop that multiplies by γλ as long as it stays above",
    ),
    gained="22 states instead of 1024: in each step, so much less is to be updated.",
    mistakes=[
        Mistake("one too many: after that many steps the trace has already crossed the threshold. Round down.",
                {"math.floor": "math.ceil"}),
        Mistake("rounding to the nearest number can go up, past the threshold. Round down.", {"math.floor": "round"}),
        Mistake("this is the bound itself, and steps are whole numbers. Round it down.", {"math.floor": ""}),
        Mistake("you forgot λ: a trace fades by γ · λ in each step.", {" * lam": ""}),
        Mistake("you forgot γ: a trace fades by γ · λ in each step.", {"gamma * ": ""}),
        Mistake("the logarithms have changed places: it is log(threshold) divided by log(γλ).",
                {"threshold": "gamma * lam", "gamma * lam": "threshold"}),
        Mistake("the logarithm of γλ is log(γ) + log(λ), not their product.",
                {"math.log(gamma * lam)": "(math.log(gamma) * math.log(lam))"}),
        Mistake("a trace does not lose the same amount in each step, but the same share. That is a power, and it "
                "takes a logarithm to undo it.",
                {"math.log(threshold) / math.log(gamma * lam)": "(1 - threshold) / (1 - gamma * lam)"}),
        Mistake("one too few: after one more step the trace is still above the threshold.",
                {"return math.floor(": "return -1 + math.floor("}),
        Mistake("γ and λ are multiplied, not added: a trace fades by γ · λ in each step.",
                {"gamma * lam": "(gamma + lam) / 2"}),
        Mistake("the sign is the wrong way round: both logarithms are negative, so n is positive.",
                {"return math.floor(": "return -math.floor("}),
        Mistake("it is the threshold that (γλ)ⁿ must stay above, not always 0.01.",
                {"math.log(threshold)": "math.log(0.01)"}),
        Mistake("γ and λ are arguments, not always 0.9.", {"gamma * lam": "0.81"}),
        Mistake("the logarithms are divided, not subtracted: n · log(γλ) is to be log(threshold).",
                {"math.log(threshold) / math.log(gamma * lam)": "math.log(gamma * lam) - math.log(threshold)"}),
        Mistake("a power is computed before a product: gamma * lam ** n is γ · λⁿ. Brackets: (gamma * lam) ** n.",
                {"math.floor(math.log(threshold) / math.log(gamma * lam))":
                 "max(-1, math.floor(math.log(threshold / gamma) / math.log(lam)))"}),
        Mistake("one too few: after one more step the trace is still above the threshold.",
                {"return math.floor(math.log(threshold) / math.log(gamma * lam))":
                 "return max(0, math.floor(math.log(threshold) / math.log(gamma * lam)) - 1)"}),
        Mistake("the search ends too soon: with other arguments n is above 99.",
                {"return math.floor(": "return min(99, math.floor(", "lam))": "lam)))"}),
        Mistake("these are logarithms of two kinds. Take the same one above and below the line.",
                {"math.log(threshold)": "math.log10(threshold)"}),
        Mistake("these are all the n for which it is above the threshold. Asked is the largest of them.",
                {"return math.floor(math.log(threshold) / math.log(gamma * lam))":
                 "return list(range(math.floor(math.log(threshold) / math.log(gamma * lam)) + 1))"}),
        Mistake("γ and λ are multiplied, not added: a trace fades by γ · λ in each step.",
                {"return math.floor(math.log(threshold) / math.log(gamma * lam))":
                 "return int(math.log(threshold) / math.log(gamma + lam))"}),
        Mistake("n may be 0: where the trace falls below the threshold in one step, no step is left.",
                {"return math.floor(math.log(threshold) / math.log(gamma * lam))":
                 "return max(1, math.floor(math.log(threshold) / math.log(gamma * lam)))"}),
    ],
)  # fmt: skip

lam_for = Exercise(
    task="return the λ with which a trace of 1 falls to the threshold in so many steps, 1.0 where none is enough",
    right=solutions.lam_for,
    returns="lam",
    tape=[
        dict(zip(("gamma", "steps", "threshold"), row, strict=True))
        for row in ((0.9, 10, 0.01), (0.95, 84, 0.02), (0.9, 210, 0.01), (0.99, 210, 0.05), (0.8, 5, 0.1),
                    (0.99, 1000, 0.01), (0.95, 2, 0.1))
    ],
    hints=(
        "in each step a trace is multiplied by γλ. Which number, multiplied with itself n times, gives the threshold?",
        "the n-th root: decay = threshold ** (1 / steps). That is γλ; what is λ? And may it be above 1?",
        "min(1.0, threshold ** (1 / steps) / …)",
    ),
    gained="You can now say how long your robot shall remember, in steps or in seconds, and have the λ for it.",
    mistakes=[
        Mistake("λ may not be above 1. Where γ alone fades faster than you wish, 1.0 is the best you can do.",
                {"min(1.0, decay / gamma)": "decay / gamma"}),
        Mistake("this is the whole decay γλ. λ is what remains when you divide it by γ.",
                {"min(1.0, decay / gamma)": "decay"}),
        Mistake("γλ must be that root, so λ is the root divided by γ, not multiplied.",
                {"decay / gamma": "decay * gamma"}),
        Mistake("you took a power where a root is needed: (γλ)ⁿ = threshold, so γλ is the n-th root of the threshold.",
                {"(1 / steps)": "steps"}),
        Mistake("γ, too, counts once for each step: first take the root of the threshold, then divide by γ.",
                {"threshold **": "(threshold / gamma) **", "decay / gamma": "decay"}),
        Mistake("divided evenly, the threshold would be a sum. It is a product of n equal factors: take the n-th root. "
                "(** comes before /, so 1 / steps needs its brackets.)", {"** (1 / steps)": "/ steps"}),
        Mistake("this is the logarithm of γλ. Undo it with the exponential function, then divide by γ.",
                {"min(1.0, decay / gamma)": "math.log(threshold) / steps"}),
        Mistake("a logarithm turns the power into a product, and math.exp turns it back. Without it this is no λ yet.",
                {"decay / gamma": "math.log(threshold) / steps / gamma"}),
        Mistake("this is the larger of λ and 1. λ may not exceed 1, so you need the smaller: min.",
                {"min": "max"}),
        Mistake("γ is an argument, not always 0.9.", {"/ gamma": "/ 0.9"}),
        Mistake("the threshold is an argument, not always 0.01.", {"threshold **": "0.01 **"}),
        Mistake("λ is what remains when γ is divided out, not taken off.", {"decay / gamma": "decay - gamma"}),
        Mistake("λ is the root divided by γ. Here it is upside down.", {"decay / gamma": "gamma / decay"}),
        Mistake("the root of the threshold is asked, not the threshold-th root of n.",
                {"threshold ** (1 / steps)": "steps ** -threshold"}),
        Mistake("it is the n-th root, not the square root.", {"(1 / steps)": "0.5"}),
        Mistake("where even λ = 1 forgets sooner, the answer is 1.0, the longest memory there is, not 0.",
                {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else 0.0)"}),
        Mistake("where even λ = 1 forgets sooner, return 1.0.",
                {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else None)"}),
        Mistake("the root is missing: (γλ)ⁿ is the threshold, so λⁿ is threshold / γⁿ, and λ is its n-th root.",
                {"decay / gamma": "threshold / gamma**steps"}),
        Mistake("the root of the threshold is γλ already, for one step. So divide by γ, not by γ to a power.",
                {"decay / gamma": "decay / gamma**steps"}),
        Mistake("where even λ = 1 forgets sooner, the answer is 1.0, not γ.",
                {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else gamma)"}),
        Mistake("λ may be 1, but not above: where even λ = 1 forgets sooner, return 1.0.",
                {"min(1.0, decay": "min(0.99, decay"}),
        Mistake("where even λ = 1 forgets sooner, return 1.0, a number, and no text.",
                {"min(1.0, decay / gamma)": "(decay / gamma if decay <= gamma else 'none')"}),
        Mistake("a trace of 1 falls in so many steps, not in one more.", {"1 / steps": "1 / (steps + 1)"}),
        Mistake("a trace of 1 falls in so many steps, not in one fewer.", {"1 / steps": "1 / (steps - 1)"}),
    ],
)  # fmt: skip
