"""The update of true online SARSA(λ)."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.lesson_06.exercises.dutch import dutch
from rlrobot_course.tapes import Q_START, TAPE


def true_online_update(q, e, q_old, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_sa = q[s, a]
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q_sa
    e[s, a] = dutch(e[s, a], alpha)
    q += alpha * (delta + q_sa - q_old) * e
    q[s, a] -= alpha * (q_sa - q_old)
    e *= gamma * lam
    return q_next


# One episode: pairs come back, some at once, and the last step ends it. (No episode follows: there e and Q_old start
# afresh, which is not the update's job.) It begins with traces and a Q_old that an earlier step may have left.
EPISODE = [*TAPE[5:7], *TAPE[:5]]

E_START = np.array([[0.35, 0.0, 0.0], [0.0, 0.62, 0.0], [0.0, 0.0, 0.17], [0.004, 0.0, 0.0]])

PARAMETERS = [
    {"alpha": alpha, "gamma": gamma, "lam": lam}
    for alpha, gamma, lam in (
        (0.3, 0.9, 0.8),
        (0.3, 0.9, 0.0),
        (0.2, 0.8, 0.9),
        (0.3, 0.9, 0.6),
        (0.45, 0.7, 0.8),
        (0.5, 0.95, 0.7),
        (0.6, 0.85, 0.9),
    )
]

CHANGED, WITNESSES = read_answers(__file__, {"dutch": dutch})

exercise = Exercise(
    task="change q and e in place, return the new q_old",
    right=true_online_update,
    memory={"q": Q_START, "e": E_START, "q_old": 0.7},
    returns="q_old",
    tape=[row | more for row, more in zip(EPISODE, PARAMETERS, strict=True)],
    lenders={"dutch": "your function of this lesson: run the cell with its exercise again"},
    mistakes={
        "q_old_after_update": Mistake("Q_old is the value of (s', a') as it was before this step. Keep it in a "
            "variable before q changes.", {"return q_next": "return q_next if terminated else q[s_next, a_next]"}),
        "q_old_of_s": Mistake("Q_old is for the next step, which begins at (s', a'). Return what that pair was worth, "
            "not (s, a).", {"return q_next": "return q_sa"}),
        "no_second_line": Mistake("the second correction is missing: take α · (Q(s, a) − Q_old) off q[s, a].",
            {"q[s, a] -= alpha * (q_sa - q_old)": "pass"}),
        "second_line_for_all": Mistake("the second correction is for the visited pair alone: q[s, a], not q.",
            {"q[s, a] -=": "q -="}),
        "no_old_in_the_first": Mistake("all traced pairs learn from δ + Q(s, a) − Q_old, here they learn from δ alone.",
            {"delta + q_sa - q_old": "delta"}),
        "dutch_alone": Mistake("this is SARSA(λ) with a dutch trace. The two terms with Q_old are missing, or they "
            "cancel: the second one is for q[s, a] alone, and without e.",
            {"delta + q_sa - q_old": "delta", "q[s, a] -= alpha * (q_sa - q_old)": "pass"}),
        "replaces": Mistake("the trace of the visited pair was set to 1. Call your dutch: (1 − α) · e + 1.",
            {"dutch(e[s, a], alpha)": "1"}),
        "accumulates": Mistake("the trace accumulates here. Only the share 1 − α of the old one stays.",
            {"dutch(e[s, a], alpha)": "e[s, a] + 1"}),
        "all_shrink": Mistake("1 − α shrinks the trace of the visited pair alone, not those of all pairs.",
            {"e[s, a] = dutch(e[s, a], alpha)": "e *= 1 - alpha; e[s, a] += 1"}),
        "fades_before_q": Mistake("the traces faded before q was changed. They fade at the end of the step.",
            {"q += ": "e *= gamma * lam; q += ", "e *= gamma * lam": "pass"}),
        "fades_first": Mistake("fade e at the end of the step, not at the start: here it is handed over faded. "
            "(Sutton & Barto fade it first, and hand it over unfaded; a whole life comes to the same q.)",
            {"q_sa = q[s, a]": "e *= gamma * lam; q_sa = q[s, a]", "e *= gamma * lam": "pass"}),
        "no_fading": Mistake("the traces do not fade: multiply e by γ · λ at the end, in place, with e *= … (e = e * "
            "… makes a new array, and the caller's stays as it was).", {"e *= gamma * lam": "pass"}),
        "no_lambda": Mistake("the traces fade by γ · λ, here by γ alone.", {"gamma * lam": "gamma"}),
        "no_gamma_in_fading": Mistake("the traces fade by γ · λ, here by λ alone.", {"e *= gamma * lam": "e *= lam"}),
        "new_q": Mistake("q = q + … makes a new table, and the caller's stays as it was. q += … changes it in place.",
            {"q += ": "q = q + "}),
        "no_alpha": Mistake("α is missing in the first line: q += α · (…) · e.", {"q += alpha * ": "q += "}),
        "no_alpha_in_the_second": Mistake("α is missing in the second line: q[s, a] −= α · (Q(s, a) − Q_old).",
            {"q[s, a] -= alpha * ": "q[s, a] -= "}),
        "no_trace": Mistake("e is missing in the first line: each pair learns in proportion to its trace.",
            {"q_old) * e": "q_old)"}),
        "no_gamma": Mistake("γ is missing in δ: r + γ · Q(s', a') − Q(s, a).", {"gamma * q_next": "q_next"}),
        "q_learning": Mistake("this is Q-learning's target, the best action in s'. SARSA takes a', the action that "
            "will be taken.", {"q[s_next, a_next]": "q[s_next].max()"}),
        "swapped_in_the_bracket": Mistake("the bracket of the first line is δ + Q(s, a) − Q_old: here the last two "
            "have changed places.", {"+ q_sa - q_old": "- q_sa + q_old"}),
        "adds_second_line": Mistake("the second correction is taken off, not added.", {"q[s, a] -=": "q[s, a] +="}),
        "second_line_for_the_row": Mistake("the second correction is for the visited pair alone: q[s, a], not the "
            "whole row q[s].", {"q[s, a] -=": "q[s] -="}),
        "q_old_past_the_end": Mistake("after a terminal step Q_old is 0, like the value of what follows.",
            {"q_sa = q[s, a]": "q_sa, seen = q[s, a], q[s_next, a_next]", "return q_next": "return seen"}),
        "adds_reward_at_the_end": Mistake("at the end of an episode the value of what follows is 0, but Q(s, a) is "
            "still taken off: δ = r − Q(s, a).",
            {"r + gamma * q_next - q_sa": "r if terminated else r + gamma * q_next - q_sa"}),
        "q_old_at_the_end": Mistake("return the number that you noted: what (s', a') was worth before this step, or 0 "
            "after a terminal one.", {"return q_next": "return q[s_next, a_next]"}),
        "minus_what_follows": Mistake("γ · Q(s', a') is added to r, not taken off.",
            {"r + gamma * q_next": "r - gamma * q_next"}),
        "adds_target": Mistake("δ lacks its last part: r + γ · Q(s', a') − Q(s, a).", {"q_next - q_sa": "q_next"}),
        "fades_twice": Mistake("the traces fade twice here.", {"e *= gamma * lam": "e *= (gamma * lam) ** 2"}),
        "sarsa": Mistake("only q[s, a] learns here, and without its trace. All pairs learn, each in proportion to its "
            "trace.", {"q += alpha * (delta + q_sa - q_old) * e": "q[s, a] += alpha * delta"}),
        "new_e": Mistake("your e is a copy: the caller's stays as it was. Change e itself, in place.",
            {"e[s, a] = dutch": "e = e.copy(); e[s, a] = dutch"}),
        "q_a_s": Mistake("the state and the action have changed places: it is q[s, a].",
            {"q_sa = q[s, a]": "q_sa = q[a, s]", "q[s, a] -=": "q[a, s] -="}),
        "returns_delta": Mistake("you return δ. Asked is the new Q_old: what (s', a') was worth before this step.",
            {"return q_next": "return delta"}),
        "returns_the_old_q_old": Mistake("you return the old Q_old. The new one is what (s', a') was worth before "
            "this step.", {"return q_next": "return q_old"}),
        "row_shrinks": Mistake("the traces of the other actions in s shrink here, too. 1 − α is for the visited pair "
            "alone.", {"e[s, a] = dutch(e[s, a], alpha)": "e[s] *= 1 - alpha; e[s, a] += 1"}),
        "trace_too_late": Mistake("q learns before the trace of the visited pair is renewed. The trace comes first.",
            {"e[s, a] = dutch(e[s, a], alpha)": "pass",
             "e *= gamma * lam": "e[s, a] = dutch(e[s, a], alpha); e *= gamma * lam"}),
        "keeps_alpha": Mistake("of the old trace the share 1 − α stays, not α. Call your dutch: (1 − α) · e + 1.",
            {"dutch(e[s, a], alpha)": "alpha * e[s, a] + 1"}),
        "no_q_in_the_first": Mistake("the bracket of the first line is δ + Q(s, a) − Q_old: here Q(s, a) is missing.",
            {"delta + q_sa - q_old": "delta - q_old"}),
        "discounts_q_old": Mistake("Q_old is noted as it is: γ comes in where δ is computed.",
            {"return q_next": "return gamma * q_next"}),
        "adds_alpha": Mistake("the new visit adds 1 to the trace, not α.",
            {"dutch(e[s, a], alpha)": "(1 - alpha) * e[s, a] + alpha"}),
        "dutch_swapped": Mistake("the arguments of dutch have changed places: dutch(e, alpha).",
            {"dutch(e[s, a], alpha)": "dutch(alpha, e[s, a])"}),
        "no_new_trace": Mistake("the trace of the visited pair is not renewed: e[s, a] = dutch(e[s, a], alpha) comes "
            "first. (dutch only returns it.)", {"e[s, a] = dutch(e[s, a], alpha)": "pass"}),
        "clears_at_the_end": Mistake("all traces end with the episode only because the next one begins with none: "
            "here let them fade as ever.", {"e *= gamma * lam": "e *= 0 if terminated else gamma * lam"}),
        "adds_dutch": Mistake("dutch returns a number. Write it into the table: e[s, a] = dutch(…), in place of "
            "adding it.", {"e[s, a] = dutch": "e[s, a] += dutch"}),
        "past_the_end": Mistake("this bootstraps past the end. After a terminal step the value of what follows is 0, "
            "and so is Q_old.", {"0 if terminated else ": ""}),
        "q_after_update": Mistake("in the second correction Q(s, a) is the value before this step. Keep it in a "
            "variable before q changes.", {"alpha * (q_sa - q_old)": "alpha * (q[s, a] - q_old)"}),
        "one_pair_learns": Mistake("only q[s, a] learns here. All pairs learn, each in proportion to its trace.",
            {"q +=": "q[s, a] +=", ") * e": ") * e[s, a]"}),
        "one_row_learns": Mistake("only the state s learns here. All pairs learn, each in proportion to its trace.",
            {"q +=": "q[s] +=", ") * e": ") * e[s]"}),
        "q_old_renewed_first": Mistake("q_old got its new value before the two lines that need the old one. Return "
            "the new one at the end.", {"delta = r": "q_old = q_next; delta = r"}),
        "q_old_renewed_between": Mistake("q_old got its new value before the second line, which needs the old one. "
            "Return the new one at the end.", {"q[s, a] -=": "q_old = q_next; q[s, a] -="}),
        "dutch_for_all": Mistake("dutch is for the pair that is visited, e[s, a] alone. Here all traces grow by 1.",
            {"e[s, a] = dutch(e[s, a], alpha)": "e[:] = dutch(e, alpha)"}),
        "dutch_for_the_row": Mistake("dutch is for the pair that is visited, e[s, a] alone. Here all actions of s "
            "gain 1.", {"e[s, a] = dutch(e[s, a], alpha)": "e[s] = dutch(e[s], alpha)"}),
        "next_in_the_second": Mistake("in the second correction stands Q(s, a) − Q_old, with the pair of this step, "
            "not (s', a').", {"alpha * (q_sa - q_old)": "alpha * (q_next - q_old)"}),
        "next_in_the_first": Mistake("in the first line stands δ + Q(s, a) − Q_old, with the pair of this step, not "
            "(s', a').", {"delta + q_sa": "delta + q_next"}),
        "delta_in_the_second": Mistake("the second correction is α · (Q(s, a) − Q_old), without δ.",
            {"alpha * (q_sa - q_old)": "alpha * (delta + q_sa - q_old)"}),
        "trace_in_the_second": Mistake("the second correction is α · (Q(s, a) − Q_old), without the trace.",
            {"(q_sa - q_old)": "(q_sa - q_old) * e[s, a]"}),
        "gamma_in_the_second": Mistake("the second correction is made of the values alone, without γ.",
            {"(q_sa - q_old)": "(gamma * q_sa - q_old)"}),
        "brackets_of_both": Mistake("brackets are missing in the first line: α and e are for all three of δ + Q(s, a) "
            "− Q_old.", {"alpha * (delta + q_sa - q_old) * e": "alpha * delta * e + alpha * q_sa - q_old"}),
        "brackets_of_alpha_and_e": Mistake("brackets are missing in the first line: α and e are for all three of δ + "
            "Q(s, a) − Q_old.", {"alpha * (delta + q_sa - q_old) * e": "alpha * delta + q_sa - q_old * e"}),
        "brackets_of_the_second": Mistake("brackets are missing in the second line: α is for both, Q(s, a) and Q_old.",
            {"alpha * (q_sa - q_old)": "alpha * q_sa - q_old"}),
        "alpha_and_gamma_swapped": Mistake("α and γ have changed places: γ belongs to δ and to the fading.",
            {"alpha": "gamma", "gamma": "alpha"}),
        "fades_by_an_amount": Mistake("a trace fades by a share, not by an amount: e *= gamma * lam.",
            {"e *= gamma": "e -= gamma"}),
        "trace_last": Mistake("the trace of the visited pair is renewed first, before q learns and before the traces "
            "fade.",
            {"e[s, a] = dutch(e[s, a], alpha)": "pass",
             "e *= gamma * lam": "e *= gamma * lam; e[s, a] = dutch(e[s, a], alpha)"}),
        "multiplies_delta": Mistake("in the first line Q(s, a) − Q_old is added to δ, not multiplied with it.",
            {"delta + q_sa - q_old": "delta * (q_sa - q_old)"}),
        "q_old_in_delta": Mistake("in δ stands Q(s, a), as it is now. Q_old belongs to the two lines after it.",
            {"q_next - q_sa": "q_next - q_old"}),
        "returns_everything": Mistake("q and e are changed in place, so the caller has them already. Return the new "
            "Q_old alone.", {"return q_next": "return q, e, q_next"}),
        "one_pair_at_the_end": Mistake("at the end, too, every pair that has a trace learns. Only what follows is 0 "
            "there.", CHANGED["one_pair_at_the_end"]),
    },
    hints=(
        "Note Q(s, a) and Q(s', a') first, then go through the four lines in their order, and return the second note.",
        "q += α · (δ + Q(s, a) − Q_old) · e is for all pairs, q[s, a] −= α · (Q(s, a) − Q_old) for one. Both Q(s, a) "
        "are the noted one.",
        "q_sa, q_next = q[s, a], 0 if terminated else q[s_next, a_next]; then delta; then e[s, a] = dutch(e[s, a], "
        "alpha); then the two lines with q; then e *= gamma * lam; and return q_next.",
    ),
    gained="That is true online SARSA(λ), whole: the learning of the paper's best algorithm. Below it crosses a lake "
    "and drives a robot, and in lessons 07 and 09 it comes back.",
    witnesses=WITNESSES,
)  # fmt: skip
