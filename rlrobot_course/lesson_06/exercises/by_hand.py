"""The new value of Q(s, a) by true online SARSA(λ), computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

by_hand = 6 + 0.25 * ((10 + 0.9 * 10 - 6) + 6 - 4) * (0.75 * 0.6 + 1) - 0.25 * (6 - 4)

exercise = Question(
    task="the new Q(s, a), computed by hand",
    right=by_hand,
    because="e = 0.75 · 0.6 + 1 = 1.45 and δ = 10 + 0.9 · 10 − 6 = 13. So 6 + 0.25 · (13 + 6 − 4) · 1.45 = 11.4375, "
    "and from this 0.25 · (6 − 4) = 0.5 is taken off.",
    mistakes={
        "first_line_alone": Mistake("you stopped after the first line. Now take off α · (Q(s, a) − Q_old).", 11.4375),
        "delta_alone": Mistake("the first line needs δ + Q(s, a) − Q_old, not δ alone.", 10.2125),
        "dutch_alone": Mistake("this has neither of the two new terms: it is SARSA(λ) with a dutch trace.", 10.7125),
        "trace_of_1": Mistake(
            "this is what a trace of 1 gives (the two new terms then cancel). The trace here is (1 − α) · 0.6 + 1.",
            9.25,
        ),
        "accumulates": Mistake(
            "this is what an accumulating trace of 1.6 gives. The dutch trace is (1 − α) · 0.6 + 1.", 11.5
        ),
        "no_visit": Mistake(
            "this is what a trace of 0.6 gives. The pair is visited now, so its trace is (1 − α) · 0.6 + 1.", 7.75
        ),
        "keeps_alpha": Mistake("here the trace keeps the share α. The share that stays is 1 − α.", 9.8125),
        "shrinks_the_visit": Mistake("only the old trace shrinks: (1 − α) · 0.6, and then 1 is added in full.", 10.0),
        "q_after_update": Mistake(
            "in the second line Q(s, a) is the value before this step, 6, not the 11.4375 you have just computed.",
            9.578125,
        ),
        "adds_second_line": Mistake("the second term is taken off, not added.", 11.9375),
        "sarsa_lambda": Mistake(
            "this is SARSA(λ) with an accumulating trace. Take the four lines above, one by one.", 11.2
        ),
        "no_gamma": Mistake("γ is missing: δ = r + γ · Q(s', a') − Q(s, a).", 11.3),
        "nothing_follows": Mistake("δ lacks Q(s', a'). This step is not the last of its episode.", 7.675),
        "no_old_value": Mistake("δ = r + γ · Q(s', a') − Q(s, a): you have left out the last part.", 13.1125),
        "change_alone": Mistake("this is the change alone. Asked is the new value: 6 and the change.", 4.9375),
        "no_alpha": Mistake("α is missing in the first line.", 27.25),
        "no_alpha_in_the_second": Mistake("α is missing in the second line.", 9.4375),
        "swapped_in_the_bracket": Mistake(
            "the bracket of the first line is δ + Q(s, a) − Q_old: here the last two have changed places.", 9.4875
        ),
        "fades_again": Mistake(
            "the trace of 0.6 is what the step before has left: it fades again only at the end of this one.",
            6 + 0.25 * 15 * (0.75 * 0.81 * 0.6 + 1) - 0.5,
        ),
        "adds_alpha": Mistake(
            "α is not added to the trace. It shrinks to the share 1 − α, and then 1 is added.",
            6 + 0.25 * 15 * 0.85 - 0.5,
        ),
        "no_reward": Mistake("the reward is missing in δ.", 6 + 0.25 * 5 * 1.45 - 0.5),
        "alpha_and_gamma_swapped": Mistake(
            "α and γ have changed places: α is 0.25.", 6 + 0.9 * (6.5 + 2) * 1.06 - 0.9 * 2
        ),
    },
    hints=(
        "Four small calculations in the order of the four lines: trace, δ, first line, second line.",
        "e = 0.75 · 0.6 + 1 and δ = 10 + 0.9 · 10 − 6. The bracket of the first line is δ + 6 − 4.",
        "6 + 0.25 · (13 + 6 − 4) · 1.45 − 0.25 · (6 − 4)",
    ),
    gained="What you have just done on paper, your code will do thousands of times.",
    witnesses={
        "first_line_alone": [11.4375],
        "delta_alone": [10.2125],
        "trace_of_1": [9.25],
        "accumulates": [11.5],
        "q_after_update": [9.578],
        "sarsa_lambda": [11.2],
        "keeps_alpha": [9.8125],
        "change_alone": [4.9375],
        "adds_alpha": [6 + 0.25 * 15 * (0.6 + 0.25) - 0.5],
        "form": [11],
    },
)
