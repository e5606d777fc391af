"""The new value of a pair that was visited two steps ago, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

by_hand = 2 + 0.1 * (-10) * (0.9 * 0.5) ** 2

exercise = Question(
    task="the new Q(s, a) of a pair that was visited two steps ago",
    right=by_hand,
    because="Its trace is (0.9 · 0.5)² = 0.2025, so Q ← 2 + 0.1 · (−10) · 0.2025 = 1.7975.",
    hints=(
        "three things make the change: α, the δ of now, and how much of the pair's trace is left.",
        "a visit sets the trace to 1; each step since has multiplied it by 0.9 · 0.5. The value changes by α · δ · e.",
        "2 + 0.1 * (-10) * (0.9 * 0.5) ** 2",
    ),
    gained="A step that happened two steps ago has learned from the bump of now. Nobody had to go there again.",
    mistakes={
        "trace_of_1": Mistake(
            "this is what the pair of this very step gets, whose trace is 1. Ours has faded for two steps.", 1.0
        ),
        "faded_once": Mistake("this trace has faded for one step only. Two steps make (γλ)².", 1.55),
        "faded_three_times": Mistake(
            "this trace has faded for three steps. The collision comes two steps after the visit.", 1.908875
        ),
        "no_lambda": Mistake("you forgot λ: in each step the trace is multiplied by γ and by λ.", 1.19),
        "no_gamma": Mistake("you forgot γ: in each step the trace is multiplied by γ and by λ.", 1.75),
        "no_alpha": Mistake("you forgot α: the pair learns α · δ · e.", -0.025),
        "trace_itself": Mistake("this is the trace itself. Q changes by α · δ · e.", 0.2025),
        "change_alone": Mistake("this is the change α · δ · e. Add it to the old value, 2.", -0.2025),
        "upwards": Mistake("a collision makes Q smaller: δ is −10, not +10.", 2.2025),
        "gamma_once": Mistake("γ fades the trace in each step, too: it is 0.9 twice, like 0.5.", 2 - 0.9 * 0.25),
        "lambda_once": Mistake("λ fades the trace in each step, too: it is 0.5 twice, like 0.9.", 2 - 0.81 * 0.5),
        "evenly": Mistake("a trace is not halved evenly: it is multiplied by γλ twice, which is (γλ)².", 2 - 0.9),
        "takes_q_off": Mistake(
            "δ is −10 already: it is the TD error, not the reward. Nothing is taken off it.", 2 - 1.2 * 0.2025
        ),
        "q_fades": Mistake("the old value does not fade. It stays as it is, and α · δ · e is added to it.", 2 * 0.2025),
        "alpha_in_the_fading": Mistake("α is not in the fading: it enters once, as α · δ · (γλ)².", 2 - 10 * 0.045**2),
        "mean_of_both": Mistake("the trace fades by the product of γ and λ, not by their mean.", 2 - 0.7**2),
        "sum_of_both": Mistake(
            "γ and λ are multiplied, not added: in each step a trace fades by 0.9 · 0.5.", 2 - 1.4**2
        ),
        "multiplies": Mistake("the change α · δ · e is added to the old value, not multiplied with it.", 2 * -0.2025),
        "takes_q_off_and_fades_once": Mistake(
            "δ is −10 already, with the old value taken off; and the trace has faded twice.", 2 - 1.2 * 0.45
        ),
    },
    witnesses={
        "trace_of_1": [1.0],
        "faded_once": [2 - 0.45],
        "no_lambda": [2 - 0.81],
        "no_gamma": [1.75],
        "no_alpha": [2 - 10 * 0.2025],
        "trace_itself": [0.45**2],
        "upwards": [2 + 0.45**2],
        "q_fades": [2 * 0.2025],
        "alpha_in_the_fading": [2 - 10 * (0.1 * 0.45) ** 2],
    },
)
