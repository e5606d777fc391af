"""Exercises of lesson 06: true online SARSA(λ)."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_06 import solutions

lambda_return = Exercise(
    task="return the mean of all n-step returns, weighted by powers of λ",
    right=solutions.lambda_return,
    returns="G",
    tape=[
        {"rewards": [10.0], "values": [4.0], "gamma": 0.9, "lam": 0.9},
        {"rewards": [10.0, 10.0], "values": [0.0, 5.0], "gamma": 0.9, "lam": 0.9},
        {"rewards": [1.0, -2.0], "values": [6.0, 3.0], "gamma": 0.9, "lam": 0.5},
        {"rewards": [10.0, -0.02, -2.0], "values": [7.0, 5.0, 4.0], "gamma": 0.9, "lam": 0.8},
        {"rewards": [-0.02, -0.02, 10.0, 10.0], "values": [1.0, 2.0, 3.0, 0.0], "gamma": 0.8, "lam": 0.9},
        {"rewards": [1.0, 2.0, 3.0], "values": [4.0, 5.0, 6.0], "gamma": 0.9, "lam": 0.0},
    ],
    mistakes=[
        Mistake("the weights do not sum to 1. The last return, which stands for all the longer ones, has the weight "
                "λⁿ⁻¹, without the factor 1 − λ.", {"lam ** (n - 1) if k == n else ": ""}),
        Mistake("the longest return ends with γⁿ times the last value, in full. If you work back from the end, begin "
                "with the last value, not with 0.",
                {"* values[k - 1]": "* values[k - 1] * (1 - lam if k == n else 1)"}),
        Mistake("the weights of all returns but the last have the factor 1 − λ, so that they sum to 1.",
                {"(1 - lam) * ": ""}),
        Mistake("this is the longest return alone. The shorter ones count, too, with the weights (1 − λ)λᵏ⁻¹.",
                {"return mean": "return g"}),
        Mistake("this is the one-step return alone. The longer ones count, too.",
                {"return mean": "return rewards[0] + gamma * values[0]"}),
        Mistake("this is the plain mean of the returns. Each has a weight of its own, made of λ.",
                {"weight * g": "g / n"}),
        Mistake("the powers of λ are one too high: the one-step return has the weight (1 − λ)λ⁰.",
                {"lam ** (n - 1)": "lam**n", "lam ** (k - 1)": "lam**k"}),
        Mistake("the weights do not sum to 1: that of the last return is λⁿ⁻¹, not λⁿ.", {"lam ** (n - 1)": "lam**n"}),
        Mistake("the powers of γ of the rewards are one too high: the first reward counts in full.",
                {"gamma ** (k - 1)": "gamma**k"}),
        Mistake("the value reached after k steps is one step further off than the k-th reward: it is multiplied by γᵏ.",
                {"gamma**k": "gamma ** (k - 1)"}),
        Mistake("every value is multiplied by γ alone here. The one reached after k steps is multiplied by γᵏ.",
                {"gamma**k": "gamma"}),
        Mistake("the values are missing: a k-step return ends with γᵏ times the value reached.",
                {" + gamma**k * values[k - 1]": ""}),
        Mistake("γ is missing: the reward r_k is multiplied by γᵏ and the value after k steps by γᵏ.",
                {"gamma ** (k - 1)": "1", "gamma**k": "1"}),
    ],
)  # fmt: skip

dutch = Exercise(
    task="return the trace of the pair that is visited now",
    right=solutions.dutch,
    returns="e",
    tape=[{"e": e, "alpha": alpha} for e, alpha in ((0.0, 0.5), (0.81, 0.5), (0.81, 0.1), (2.0, 0.25), (1.4, 1.0))],
    mistakes=[
        Mistake("this is the replacing trace. The dutch one keeps the share 1 − α of what was there.",
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
    ],
)  # fmt: skip

largest_alpha = Question(
    task="the largest α at which accumulating traces cannot overshoot",
    right=solutions.largest_alpha,
    because="The trace climbs towards 1/(1 − 0.81) = 5.26, and 1/5.26 = 0.19. "
    "A dutch trace climbs to 1/(1 − (1 − α) · 0.81), and α times that never exceeds 1.",
    mistakes=[
        Mistake("this is γλ, the share of a trace that one step leaves. How high does a trace climb that gains 1 at "
                "every step and keeps this share?", 0.81),
        Mistake("this is how high the trace climbs. Which α times this gives 1?", 1 / (1 - 0.81)),
        Mistake("this is 1 − λ. But a trace fades by γλ, not by λ alone.", 1 - 0.9),
        Mistake("a trace of 1 would allow this. But an accumulating trace climbs above 1.", 1),
        Mistake("this is where the update overshoots by as much as it was off before. It should not overshoot at all: "
                "α · e ≤ 1.", 2 * (1 - 0.81)),
        Mistake("this allows for two visits in a row, where the trace is 1.81. With more visits it climbs further.",
                1 / 1.81),
        Mistake("4.47 is the trace after nine steps. On a longer drive it climbs further: how high?", 1 / 4.47),
        Mistake("this is for the trace after it has faded. It overshoots where it is highest: right after a visit.",
                (1 - 0.81) / 0.81),
    ],
)  # fmt: skip

by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=solutions.by_hand,
    because="e = 0.5 · 0.8 + 1 = 1.4 and δ = 10 + 0.9 · 10 − 6 = 13. So 6 + 0.5 · (13 + 6 − 4) · 1.4 = 16.5, "
    "and from this 0.5 · (6 − 4) = 1 is taken off.",
    mistakes=[
        Mistake("you stopped after the first line. Now take off α · (Q(s, a) − Q_old).", 16.5),
        Mistake("the first line needs δ + Q(s, a) − Q_old, not δ alone.", 14.1),
        Mistake("this has neither of the two new terms: it is SARSA(λ) with a dutch trace.", 15.1),
        Mistake("this is what a trace of 1 gives (the two new terms then cancel). The trace here is (1 − α) · 0.8 + 1.",
                12.5),
        Mistake("this is what an accumulating trace of 1.8 gives. The dutch trace is (1 − α) · 0.8 + 1.", 18.5),
        Mistake("this is what a trace of 0.8 gives. The pair is visited now, so its trace is (1 − α) · 0.8 + 1.", 11.0),
        Mistake("in the second line Q(s, a) is the value before this step, 6, not the 16.5 you have just computed.",
                10.25),
        Mistake("the second term is taken off, not added.", 17.5),
        Mistake("this is SARSA(λ) with an accumulating trace. Take the four lines above, one by one.", 17.7),
    ],
)  # fmt: skip

# One episode: pairs come back, some at once, and the last step ends it. (No episode follows: there e and Q_old start
# afresh, which is not the update's job.)
EPISODE = [*TAPE[5:7], *TAPE[:5]]

true_online_update = Exercise(
    task="change q and e in place, return the new q_old",
    right=solutions.true_online_update,
    memory={"q": Q_START, "e": np.zeros_like(Q_START), "q_old": 0.0},
    returns="q_old",
    tape=[row | {"alpha": 0.5, "gamma": 0.9, "lam": 0.8} for row in EPISODE],
    mistakes=[
        Mistake("Q_old is the value of (s', a') as it was before this step. Keep it in a variable before q changes.",
                {"return q_next": "return q_next if terminated else q[s_next, a_next]"}),
        Mistake("Q_old is for the next step, which begins at (s', a'). Return what that pair was worth, not (s, a).",
                {"return q_next": "return q_sa"}),
        Mistake("the second correction is missing: take α · (Q(s, a) − Q_old) off q[s, a].",
                {"q[s, a] -= alpha * (q_sa - q_old)": "pass"}),
        Mistake("the second correction is for the visited pair alone: q[s, a], not q.", {"q[s, a] -=": "q -="}),
        Mistake("all traced pairs learn from δ + Q(s, a) − Q_old, here they learn from δ alone.",
                {"delta + q_sa - q_old": "delta"}),
        Mistake("this is SARSA(λ) with a dutch trace. The two terms with Q_old are missing.",
                {"delta + q_sa - q_old": "delta", "q[s, a] -= alpha * (q_sa - q_old)": "pass"}),
        Mistake("the trace of the visited pair was set to 1. Call your dutch: (1 − α) · e + 1.",
                {"dutch(e[s, a], alpha)": "1"}),
        Mistake("the trace accumulates here. Only the share 1 − α of the old one stays.",
                {"dutch(e[s, a], alpha)": "e[s, a] + 1"}),
        Mistake("1 − α shrinks the trace of the visited pair alone, not those of all pairs.",
                {"e[s, a] = dutch(e[s, a], alpha)": "e *= 1 - alpha; e[s, a] += 1"}),
        Mistake("the traces faded before q was changed. They fade at the end of the step.",
                {"q += ": "e *= gamma * lam; q += ", "e *= gamma * lam": "pass"}),
        Mistake("your q is right, but e should be left faded: multiply it at the end of the step, not at the start.",
                {"q_sa = q[s, a]": "e *= gamma * lam; q_sa = q[s, a]", "e *= gamma * lam": "pass"}),
        Mistake("the traces never fade: multiply e by γ · λ at the end.", {"e *= gamma * lam": "pass"}),
        Mistake("the traces fade by γ · λ, here by γ alone.", {"gamma * lam": "gamma"}),
        Mistake("this bootstraps past the end. After a terminal step the value of what follows is 0, and so is Q_old.",
                {"0 if terminated else ": ""}),
        Mistake("in the second correction Q(s, a) is the value before this step. Keep it in a variable before q "
                "changes.", {"alpha * (q_sa - q_old)": "alpha * (q[s, a] - q_old)"}),
        Mistake("only q[s, a] learns here. All pairs learn, each in proportion to its trace.",
                {"q +=": "q[s, a] +=", ") * e": ") * e[s, a]"}),
    ],
)  # fmt: skip
