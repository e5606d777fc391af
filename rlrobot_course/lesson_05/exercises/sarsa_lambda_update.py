"""The update of SARSA(λ) with replacing traces."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import ADDS_TARGET, DISCOUNTS_THE_REWARD
from rlrobot_course.tapes import Q_START, TAPE


def sarsa_lambda_update(q, e, s, a, r, s_next, a_next, terminated, alpha, gamma, lam):
    q_next = 0 if terminated else q[s_next, a_next]
    delta = r + gamma * q_next - q[s, a]
    e[s, a] = 1
    q += alpha * delta * e
    e *= gamma * lam


# one episode; (0, 1) and (1, 2) come twice, and in the fourth step the next pair has a trace already
EPISODE = [TAPE[i] for i in (0, 1, 2, 3, 7)] + [
    {"s": 1, "a": 2, "r": -0.02, "s_next": 1, "a_next": 2, "terminated": False},
    TAPE[8],
]

# Another world, two actions: some traces are small (a threshold would drop them), one reward is 0, values have digits
OTHER_Q = np.array([[-0.4871, 1.0032], [2.7183, -3.1416], [0.1234, -0.5772]])

OTHER_E = np.array([[0.0073, 0.0], [0.31, 0.0004], [0.0, 0.62]])

OTHER: list[dict[str, object]] = [
    {"q": OTHER_Q, "e": OTHER_E, "s": 1, "a": 1, "r": -0.3, "s_next": 2, "a_next": 1, "terminated": False},
    {"q": OTHER_Q, "e": OTHER_E, "s": 2, "a": 0, "r": 0.0, "s_next": 1, "a_next": 1, "terminated": False},
    {"q": OTHER_Q, "e": OTHER_E, "s": 0, "a": 1, "r": 0.0, "s_next": 1, "a_next": 0, "terminated": True},
    {"q": OTHER_Q, "e": OTHER_E, "s": 2, "a": 0, "r": 0.1234, "s_next": 1, "a_next": 0, "terminated": True},  # δ = 0
]

RATES = (
    *((0.1, 0.9, 0.8), (0.3, 0.8, 0.7), (0.25, 0.95, 0.6), (0.15, 0.7, 0.9), (0.6, 0.9, 0.5), (0.45, 0.55, 0.85)),
    *((0.2, 0.99, 0.75), (0.35, 0.85, 0.95), (0.12, 0.6, 0.4), (0.37, 0.93, 0.0), (0.2, 0.9, 0.5)),
)

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="compute δ, set the trace of (s, a) to 1, let every pair learn its share, and let every trace fade",
    right=sarsa_lambda_update,
    memory={"q": Q_START, "e": np.zeros_like(Q_START)},
    tape=[
        {**row, "alpha": alpha, "gamma": gamma, "lam": lam}
        for row, (alpha, gamma, lam) in zip(EPISODE + OTHER, RATES, strict=True)
    ],
    lenders={"sarsa_update": "your function of lesson 04, and it changes one pair only: write its lines anew"},
    hints=(
        "δ is one number, and q and e are tables of one shape. So every pair can learn in one line.",
        "compute delta as in lesson 04; then e[s, a] = 1; then q += …, with alpha, delta and e in it; then e *= …",
        "q += alpha * delta * e, and after it e *= gamma * … Before both: delta, and e[s, a] = 1",
    ),
    gained="Every step now teaches the whole way that led to it. On the lake, and on the robot, it is your turn next.",
    mistakes={
        "fades_before_q": Mistake("the traces fade too soon: the pair of this step should learn with its full trace, "
            "1. Let them fade after q has learned.",
            {"q += alpha * delta * e": "e *= gamma * lam", "e *= gamma * lam": "q += alpha * delta * e"}),
        "fades_first": Mistake("your q is right, but e is handed on before it fades. Let the traces fade at the end "
            "of the step: the lessons to come go on from there.",
            {"e[s, a] = 1": "e *= gamma * lam; e[s, a] = 1", "e *= gamma * lam": "pass"}),
        "stays_1": Mistake("all traces fade at the end of a step, that of (s, a), too.",
            {"e *= gamma * lam": "e *= gamma * lam; e[s, a] = 1"}),
        "trace_too_late": Mistake("set the trace of (s, a) to 1 before q learns; otherwise this step's own pair "
            "misses its share.", {"e[s, a] = 1": "q += alpha * delta * e", "q += alpha * delta * e": "e[s, a] = 1"}),
        "new_e": Mistake("the traces do not fade. Is that line missing, or does it make a new array? e = … does; e *= "
            "… changes the array that everybody sees.", {"e *= gamma": "e = e * gamma"}),
        "no_lambda": Mistake("you forgot λ: a trace fades by γ · λ.", {" * lam": ""}),
        "no_gamma_in_fading": Mistake("you forgot γ: a trace fades by γ · λ.", {"gamma * lam": "lam"}),
        "accumulates": Mistake("these traces accumulate. A replacing trace goes to 1 at a visit, whatever it was: = "
            "instead of +=.", {"e[s, a] = 1": "e[s, a] += 1"}),
        "one_pair_learns": Mistake("only the pair (s, a) learns. Every pair should, by α · δ times its own trace.",
            {"q += alpha * delta * e": "q[s, a] += alpha * delta"}),
        "no_share": Mistake("every pair that has a trace learns the whole α · δ. Multiply by the trace: the older, "
            "the less.", {"delta * e": "delta * (e > 0)"}),
        "past_the_end": Mistake("this bootstraps past the end. After a terminal step nothing follows: the target is "
            "the reward alone.", {"0 if terminated else ": ""}),
        "q_learning": Mistake("this takes the best action of s', as Q-learning does. SARSA takes a', which will "
            "really follow.", {"q[s_next, a_next]": "q[s_next].max()"}),
        "own_deltas": Mistake("each pair has a δ of its own here. There is one δ, that of this step's (s, a), shared "
            "by all pairs.", {"q += alpha * delta * e": "q += alpha * (delta + q[s, a] - q) * e"}),
        "delta_in_the_loop": Mistake("δ changes while q learns. Compute it once, before any entry of q changes.",
            CHANGED["delta_in_the_loop"]),
        "row_of_traces": Mistake("all actions of s got a trace. Only the one that was taken should: e[s, a], not e[s].",
            {"e[s, a] = 1": "e[s] = 1"}),
        "new_q": Mistake("q does not change. Does your line make a new array? q = q + … does; q += … changes the "
            "array that everybody sees.", {"q += alpha": "q = q + alpha"}),
        "new_q_and_e": Mistake("neither q nor the fading is seen outside: q = … and e = … make new arrays. q += … and "
            "e *= … change those that everybody sees.", {"q += alpha": "q = q + alpha", "e *= gamma": "e = e * gamma"}),
        "clears_at_the_end": Mistake("clearing the traces is the loop's work, when it resets the world. The update "
            "leaves them to fade.", {"e *= gamma * lam": "e *= gamma * lam * (not terminated)"}),
        "no_alpha": Mistake("you forgot α: the whole δ is far too large a step.", {"alpha * delta": "delta"}),
        "no_gamma": Mistake("you forgot γ in δ: the value that follows counts γ times.", {"gamma * q_next": "q_next"}),
        "no_trace": Mistake("you forgot e: here the whole table learns alike. Multiply by the traces.",
            CHANGED["no_trace"]),
        "adds_target": Mistake(ADDS_TARGET,
            {" - q[s, a]": ""}),
        "adds_reward_at_the_end": Mistake("at the end, too, the old value must be taken off: δ is r − q[s, a] there.",
            {" - q[s, a]": " - q[s, a] * (not terminated)"}),
        "inverted": Mistake("the if is the wrong way round: what follows counts 0 where the episode has ended.",
            {"if terminated": "if not terminated"}),
        "no_reward_at_the_end": Mistake("the reward is missing at the end: δ is r − q[s, a] there, and just that "
            "step is paid.", {"r + gamma * q_next": "(0 if terminated else r + gamma * q_next)"}),
        "nothing_at_the_end": Mistake("at the end nothing is learned here, and it is the step with the reward: δ is r "
            "− q[s, a] there.", {"q += alpha": "q += (not terminated) * alpha"}),
        "downwards": Mistake("the sign is the wrong way round: α · δ · e is added.", {"q += alpha": "q -= alpha"}),
        "lambda_for_gamma": Mistake("in δ stands γ. λ is for the fading only.", {"gamma * q_next": "lam * q_next"}),
        "lambda_in_delta": Mistake("in δ stands γ alone. λ is for the fading only.",
            {"gamma * q_next": "gamma * lam * q_next"}),
        "alpha_in_the_fading": Mistake("α is not in the fading: e ← γλe.",
            {"e *= gamma * lam": "e *= alpha * gamma * lam"}),
        "adds_rates": Mistake("the traces fade by the product γ · λ, not by the sum.",
            {"e *= gamma * lam": "e *= gamma + lam"}),
        "trace_never_set": Mistake("the trace of (s, a) is never set, so nobody learns: e[s, a] = 1.",
            {"e[s, a] = 1": "pass"}),
        "trace_of_the_next_pair": Mistake("the trace is given to the pair that was visited, (s, a); (s', a') gets its "
            "own in the next step.", {"e[s, a] = 1": "e[s_next, a_next] = 1"}),
        "wipes_the_row": Mistake("the traces of the other actions of s are wiped out. (Some books do so.) Here they "
            "only fade.", {"e[s, a] = 1": "e[s] = 0; e[s, a] = 1"}),
        "wipes_all": Mistake("all other traces are wiped out at a visit. They should only fade.",
            {"e[s, a] = 1": "e[:] = 0; e[s, a] = 1"}),
        "no_fading_at_the_end": Mistake("at the end, too, the traces fade. (The loop clears them when it resets the "
            "world.)", {"e *= gamma * lam": "e *= 1 if terminated else gamma * lam"}),
        "only_one_trace_fades": Mistake("only the trace of (s, a) fades. Every trace should: e *= gamma * lam.",
            {"e *= gamma * lam": "e[s, a] *= gamma * lam"}),
        "only_a_row_fades": Mistake("only the traces of s fade. Every trace should: e *= gamma * lam.",
            {"e *= gamma * lam": "e[s] *= gamma * lam"}),
        "only_a_row_learns": Mistake("only the actions of s learn. Every pair should: q += alpha * delta * e.",
            {"q += alpha * delta * e": "q[s] += alpha * delta * e[s]"}),
        "faded_trace_of_now": Mistake("the other pairs learn, but not (s, a) by its whole δ: its trace is 1 before q "
            "learns.", {"e[s, a] = 1": "e[s, a] = gamma * lam"}),
        "fades_only_where_learned": Mistake("where δ is 0 nothing is learned, but the traces fade all the same.",
            {"e *= gamma * lam": "e *= gamma * lam if delta != 0 else 1"}),
        "drops_small_traces": Mistake("small traces are dropped here. That is a trick for speed; here every trace "
            "only fades.", {"e *= gamma * lam": "e *= gamma * lam; e[e < 0.01] = 0"}),
        "small_traces_do_not_teach": Mistake("pairs with a small trace do not learn here. Small traces teach, too: "
            "every pair learns by α · δ times its trace.", {"delta * e": "delta * e * (e > 1e-3)"}),
        "delta_cut_off": Mistake("int(…) cuts off what δ has after the point. Take δ as it is.",
            {"alpha * delta": "alpha * int(delta)"}),
        "old_action": Mistake("in s' the action a_next will be taken, not the old action a once more.",
            {"a_next": "a"}),
        "value_of_s": Mistake("a_next is taken in the next state: its value is q[s_next, a_next].", {"s_next": "s"}),
        "q_a_s": Mistake("the state comes first: it is q[s, a] and e[s, a], here and for s' and a'.",
            {"[s, a]": "[a, s]", "[s_next, a_next]": "[a_next, s_next]"}),
        "alpha_and_gamma_swapped": Mistake("α and γ have changed places: γ belongs to the value that follows and to "
            "the fading.", {"alpha": "gamma", "gamma": "alpha"}),
        "replaces_q": Mistake("q becomes α · δ · e and loses what it was. Add to it: q += …",
            {"q += alpha * delta * e": "q[:] = alpha * delta * e"}),
        "no_reward": Mistake("the reward is missing in δ.", {"r + gamma": "gamma"}),
        "discounts_the_reward": Mistake(DISCOUNTS_THE_REWARD,
            {"r + gamma * q_next": "gamma * (r + q_next)"}),
        "trace_squared": Mistake("the trace enters once: α · δ · e.", CHANGED["trace_squared"]),
        "dutch": Mistake("the new trace is 1, not 1 − α or something else of lesson 06.",
            {"e[s, a] = 1": "e[s, a] = (1 - alpha) * e[s, a] + 1"}),
        "no_reward_on_the_way": Mistake("the reward is missing where the world goes on: δ is r + γ · Q(s', a') − Q(s, "
            "a).", {"r + gamma * q_next": "(r if terminated else gamma * q_next)"}),
        "e_a_s": Mistake("the state comes first: it is e[s, a].", {"e[s, a]": "e[a, s]"}),
        "rounds": Mistake("your numbers are rounded. Keep them as they are: rounding is for showing.",
            {"q += alpha * delta * e": "q[:] = (q + alpha * delta * e).round(2)"}),
        "loop_over_s_and_a": Mistake("a loop over all pairs with the names s and a loses the pair of this step. "
            "Compute δ before the loop, and give the loop other names.", CHANGED["loop_over_s_and_a"]),
        "fades_by_an_amount": Mistake("a trace fades by a share, not by an amount: e *= gamma * lam.",
            {"e *= gamma": "e -= gamma"}),
        "pair_learns_twice": Mistake("the pair (s, a) learns twice here. Its trace is 1, so q += alpha * delta * e "
            "teaches it already.", {"q += alpha * delta * e": "q[s, a] += alpha * delta; q += alpha * delta * e"}),
        "next_trace_alone": Mistake("the traces of all pairs fade, and the next pair gets its 1 in the next step: e "
            "*= gamma * lam.", {"e *= gamma * lam": "e[s_next, a_next] = gamma * lam"}),
        "lambda_moved": Mistake("λ is for the fading, where it stands beside γ. In δ stands γ alone.",
            {"gamma * q_next": "lam * q_next", "e *= gamma * lam": "e *= gamma"}),
        "row_of_s_next_fades": Mistake("only the traces of s' fade. Every trace should: e *= gamma * lam.",
            {"e *= gamma * lam": "e[s_next] *= gamma * lam"}),
        "traces_of_all": Mistake("every pair gets a trace of 1 here. Only the one that was visited does: e[s, a] = 1.",
            {"e[s, a] = 1": "e[:] = 1"}),
        "power_of_a_trace": Mistake("**= raises to a power. A trace is multiplied by γλ once in each step: e *= gamma "
            "* lam.", {"e *= gamma * lam": "e **= gamma * lam"}),
        "gamma_to_the_lambda": Mistake("the traces fade by the product γ · λ, not by γ to the power λ.",
            {"gamma * lam": "gamma**lam"}),
        "alpha_squared": Mistake("α enters once: α · δ · e.", {"alpha * delta": "alpha * alpha * delta"}),
        "learns_before_its_trace": Mistake("the pair (s, a) learns twice where it has a trace already. Set its trace "
            "to 1 first: then the line for all pairs is enough.",
            {"e[s, a] = 1": "q[s, a] += alpha * delta", "e *= gamma * lam": "e[s, a] = 1; e *= gamma * lam"}),
        "trace_of_delta": Mistake("a trace remembers a visit, not a δ: e[s, a] = 1. The δ of now is for all pairs.",
            {"e[s, a] = 1": "e[s, a] = delta", "alpha * delta * e": "alpha * e"}),
        "traces_grow": Mistake("the traces grow here. They are multiplied by γλ, not divided.",
            {"e *= gamma * lam": "e /= gamma * lam"}),
    },
    witnesses=WITNESSES,
)  # fmt: skip
