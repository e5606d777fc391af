"""Exercises of lesson 06: true online SARSA(λ)."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise, Mistake, Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE
from rlrobot_edu.course.lesson_06.lambda_return import lambda_return

__all__ = ["by_hand", "dutch", "lambda_return", "largest_alpha", "true_online_update"]


def _replaces(e, alpha):
    e = 1.0
    return e


dutch = Exercise(
    task="return the trace of the pair that is visited now",
    right=lambda e, alpha: (1 - alpha) * e + 1,
    returns="e",
    tape=[{"e": e, "alpha": alpha} for e, alpha in ((0.0, 0.5), (0.81, 0.5), (0.81, 0.1), (2.0, 0.25), (1.4, 1.0))],
    mistakes=[
        Mistake("this is the replacing trace. The dutch one keeps the share 1 − α of what was there.",
                _replaces),
        Mistake("this is the accumulating trace. The dutch one keeps only the share 1 − α of what was there.",
                lambda e, alpha: e + 1),
        Mistake("α is the share that is lost. The share that stays is 1 − α.", lambda e, alpha: alpha * e + 1),
        Mistake("the new visit is missing: it adds 1.", lambda e, alpha: (1 - alpha) * e),
        Mistake("only the old trace shrinks. The 1 of the new visit is added afterwards, in full.",
                lambda e, alpha: (1 - alpha) * (e + 1)),
        Mistake("the new visit adds 1, not α. The learning rate comes in at the update.",
                lambda e, alpha: (1 - alpha) * e + alpha),
        Mistake("the brackets: 1 − α is multiplied by e, not α · e subtracted from 1.", lambda e, alpha: 1 - alpha * e),
    ],
)  # fmt: skip

by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=15.5,
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


def _step(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam, wrong=""):
    """True online SARSA(λ), right but for what `wrong` names."""
    q_sa = q[s, a]
    q_next = 0.0 if terminated and wrong != "past the end" else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    fade = {"no lambda": gamma, "no fading": 1.0}.get(wrong, gamma * lam)

    if wrong == "replacing":
        e[s, a] = 1.0
    elif wrong == "dutch for all":
        e *= 1 - alpha
        e[s, a] += 1
    else:
        e[s, a] = (1.0 if wrong == "accumulating" else 1 - alpha) * e[s, a] + 1
    if wrong == "fades first":
        e *= fade

    first = alpha * (delta if wrong in ("no first", "neither") else delta + q_sa - q_old)
    if wrong == "one pair":
        q[s, a] += first * e[s, a]
    else:
        q += first * e
    if wrong == "second for all":
        q -= alpha * (q_sa - q_old)
    elif wrong not in ("no second", "neither"):
        q[s, a] -= alpha * ((q[s, a] if wrong == "changed q" else q_sa) - q_old)
    if wrong != "fades first":
        e *= fade
    if wrong == "q_old after" and not terminated:
        return q[s_next, a_next]
    return q_sa if wrong == "q_old is q_sa" else q_next


def _true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    return _step(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam)


def _fades_before_the_visit(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    e *= gamma * lam
    return _step(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam, "no fading")


def _spoilt(wrong):
    return lambda *arguments: _step(*arguments, wrong)


# One episode: pairs come back, some at once, and the last step ends it. (No episode follows: there e and Q_old start
# afresh, which is not the update's job.)
EPISODE = [*TAPE[5:7], *TAPE[:5]]

true_online_update = Exercise(
    task="change q and e in place, return the new q_old",
    right=_true_online_update,
    memory={"q": Q_START, "e": np.zeros_like(Q_START), "q_old": 0.0},
    returns="q_old",
    tape=[row | {"alpha": 0.5, "gamma": 0.9, "lam": 0.8} for row in EPISODE],
    mistakes=[
        Mistake("Q_old is the value of (s', a') as it was before this step. Keep it in a variable before q changes.",
                _spoilt("q_old after")),
        Mistake("Q_old is for the next step, which begins at (s', a'). Return what that pair was worth, not (s, a).",
                _spoilt("q_old is q_sa")),
        Mistake("the second correction is missing: take α · (Q(s, a) − Q_old) off q[s, a].", _spoilt("no second")),
        Mistake("the second correction is for the visited pair alone: q[s, a], not q.", _spoilt("second for all")),
        Mistake("all traced pairs learn from δ + Q(s, a) − Q_old, here they learn from δ alone.", _spoilt("no first")),
        Mistake("this is SARSA(λ) with a dutch trace. The two terms with Q_old are missing.", _spoilt("neither")),
        Mistake("the trace of the visited pair was set to 1. Call your dutch: (1 − α) · e + 1.", _spoilt("replacing")),
        Mistake("the trace accumulates here. Only the share 1 − α of the old one stays.", _spoilt("accumulating")),
        Mistake("1 − α shrinks the trace of the visited pair alone, not those of all pairs.",
                _spoilt("dutch for all")),
        Mistake("the traces faded before q was changed. They fade at the end of the step.", _spoilt("fades first")),
        Mistake("your q is right, but e should be left faded: multiply it at the end of the step, not at the start.",
                _fades_before_the_visit),
        Mistake("the traces never fade: multiply e by γ · λ at the end.", _spoilt("no fading")),
        Mistake("the traces fade by γ · λ, here by γ alone.", _spoilt("no lambda")),
        Mistake("this bootstraps past the end. After a terminal step the value of what follows is 0, and so is Q_old.",
                _spoilt("past the end")),
        Mistake("in the second correction Q(s, a) is the value before this step. Keep it in a variable before q "
                "changes.", _spoilt("changed q")),
        Mistake("only q[s, a] learns here. All pairs learn, each in proportion to its trace.", _spoilt("one pair")),
    ],
)  # fmt: skip

largest_alpha = Question(
    task="the largest α at which accumulating traces cannot overshoot",
    right=1 - 0.9 * 0.9,
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
