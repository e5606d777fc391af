"""The update of SARSA."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import ADDS_TARGET, DISCOUNTS_THE_REWARD, FORGOT_GAMMA, IS_TRUE
from rlrobot_course.tapes import Q_START, TAPE


def sarsa_update(q, s, a, r, s_next, a_next, terminated, alpha, gamma):
    target = r if terminated else r + gamma * q[s_next, a_next]
    delta = target - q[s, a]
    q[s, a] = q[s, a] + alpha * delta


# Another world for the last four steps: two actions, values with many digits, and an end that comes with a loss.
OTHER_Q = np.array([[-0.4871, 1.0032], [2.7183, -3.1416], [0.1234, -0.5772]])

OTHER_STEPS: tuple[dict[str, object], ...] = (
    {"q": OTHER_Q, "s": 1, "a": 1, "r": -0.3, "s_next": 2, "a_next": 1, "terminated": False},
    {"q": OTHER_Q, "s": 0, "a": 1, "r": -5.5, "s_next": 1, "a_next": 0, "terminated": np.True_},
    {"q": OTHER_Q, "s": 2, "a": 0, "r": 0.0, "s_next": 1, "a_next": 1, "terminated": False},
    {"q": OTHER_Q, "s": 1, "a": 0, "r": 0.0, "s_next": 0, "a_next": None, "terminated": True},
)

# α and γ of each step: none is the default twice, and no product of them is round
RATES = (
    (0.1, 0.9),
    (0.3, 0.8),
    (0.25, 0.95),
    (0.1, 0.7),
    (0.6, 0.9),
    (0.45, 0.55),
    (0.2, 0.99),
    (0.35, 0.85),
    (0.15, 0.6),
    (0.37, 0.93),
    (0.23, 0.81),
    (0.31, 0.77),
    (0.47, 0.88),
)

ANEW = "lesson 02's, and it looks at the best action of s'. SARSA takes a_next: write its lines anew"

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="change q[s, a] by α times SARSA's TD error",
    right=sarsa_update,
    memory={"q": Q_START},
    lenders={
        "update": ANEW,
        "target": ANEW,
        "choose": "not needed here: what comes next has been chosen, and is called a_next",
    },
    tape=[
        {**row, "alpha": alpha, "gamma": gamma}
        for row, (alpha, gamma) in zip((*TAPE, *OTHER_STEPS), RATES, strict=True)
    ],
    hints=(
        "it is your update of lesson 02, but the next action is not the best one: it is known, and called a_next.",
        "first the target: r alone if terminated, else r + gamma * q[s_next, …]. Then q[s, a] goes the share alpha "
        "of the way to it.",
        "target = r if terminated else r + gamma * q[s_next, a_next], and then q[s, a] += alpha * (target - …)",
    ),
    gained="With one line changed, your agent counts its own clumsiness in. At the cliff this line will save it.",
    mistakes={
        "past_the_end": Mistake("this bootstraps past the end. After a terminal step nothing follows, so the target "
            "is the reward alone.", {"r if terminated else ": ""}),
        "nothing_at_the_end": Mistake("a terminated step teaches, too: its target is the reward alone.",
            {"alpha * delta": "alpha * delta * (not terminated)"}),
        "q_learning": Mistake("this is Q-learning: it takes the best action of s'. SARSA takes a_next, good or bad.",
            {"q[s_next, a_next]": "q[s_next].max()"}),
        "counts_twice": Mistake("the old value is counted twice: += adds to it already. Write either += or q[s, a] + "
            "…, not both.", {"q[s, a] = q[s, a]": "q[s, a] += q[s, a]"}),
        "changes_before_the_target": Mistake("q[s, a] has changed before the target looks at it. Where a step leads "
            "back to the same pair, that is another number. Compute δ first, then change q[s, a] in one line.",
            CHANGED["changes_before_the_target"]),
        "action_0_as_none": Mistake("is there an if a_next? Action 0 counts as no there. Ask for terminated alone.",
            {"r if terminated else": "r if terminated or not a_next else"}),
        "gap_from_the_next_pair": Mistake("δ is measured from the old value of the pair that learns, q[s, a], not "
            "from that of (s', a').", {"target - q[s, a]": "target - q[s_next, a_next]"}),
        "old_action": Mistake("in s' the action a_next will be taken, not the old action a once more.",
            {"a_next": "a"}),
        "value_of_s": Mistake("a_next is taken in the next state: its value is q[s_next, a_next], not q[s, a_next].",
            {"s_next": "s"}),
        "no_gamma": Mistake(FORGOT_GAMMA, {"gamma * ": ""}),
        "adds_target": Mistake(ADDS_TARGET,
            {" - q[s, a]": ""}),
        "replaces": Mistake("q[s, a] should change by α · δ. You replaced it: write += instead of =.",
            {"q[s, a] + alpha": "alpha"}),
        "jumps": Mistake("q[s, a] jumps to the target. It should go only the share α of the way.", {"alpha * ": ""}),
        "writes_to_the_next_pair": Mistake("the pair that learns is (s, a), where the step began, not (s', a').",
            {"q[s, a] = q[s, a] +": "q[s_next, a_next] +="}),
        "next_pair_learns": Mistake("the pair that learns is (s, a). This changes (s', a'), and takes its old value "
            "off, too.", {"q[s, a]": "q[s_next, a_next]"}),
        "next_action_learns": Mistake("the action that learns is a, which was done; a_next is still to come.",
            {"q[s, a]": "q[s, a_next]"}),
        "adds_reward_at_the_end": Mistake("at the end, too, the old value must be taken off: δ is r − q[s, a] there.",
            {"target - q[s, a]": "target - q[s, a] * (not terminated)"}),
        "becomes_the_reward": Mistake("at the end q[s, a] does not become the reward, it goes the share α of the way "
            "to it.", {"q[s, a] + alpha * delta": "r if terminated else q[s, a] + alpha * delta"}),
        "no_reward_at_the_end": Mistake("the end has the reward as its target, not 0.",
            {"r if terminated": "0 if terminated"}),
        "inverted": Mistake("here the if is the wrong way round: the reward stands alone where the episode has ended.",
            {"if terminated": "if not terminated"}),
        "row": Mistake("all actions of s change. Only the one that was taken should: q[s, a], not q[s].",
            {"q[s, a] = q[s, a] +": "q[s] +="}),
        "whole_table": Mistake("the whole table changes. One step of SARSA teaches the pair (s, a) alone.",
            {"q[s, a] = q[s, a] +": "q +="}),
        "downwards": Mistake("the sign is the wrong way round: δ is the target minus the old value, and α · δ is "
            "added.", {"q[s, a] + alpha": "q[s, a] - alpha"}),
        "discounts_the_reward": Mistake(DISCOUNTS_THE_REWARD,
            {"r + gamma * q[s_next, a_next]": "gamma * (r + q[s_next, a_next])"}),
        "alpha_and_gamma_swapped": Mistake("α and γ have changed places: γ belongs to the value that follows, α to "
            "the whole step.", {"gamma": "alpha", "alpha": "gamma"}),
        "q_a_s": Mistake("the state comes first: it is q[s, a], here and for s' and a'.",
            {"q[s, a]": "q[a, s]", "q[s_next, a_next]": "q[a_next, s_next]"}),
        "half_the_best": Mistake("this counts the best action of s' half. SARSA looks at a_next alone.",
            {"q[s_next, a_next]": "(q[s_next, a_next] + q[s_next].max()) / 2"}),
        "mean": Mistake("this takes the mean over the actions of s'. SARSA looks at a_next alone.",
            {"q[s_next, a_next]": "q[s_next].mean()"}),
        "worst": Mistake("this takes the worst action of s'. SARSA takes a_next, good or bad.",
            {"q[s_next, a_next]": "q[s_next].min()"}),
        "sum": Mistake("this adds all actions of s' up. SARSA looks at a_next alone.",
            {"q[s_next, a_next]": "q[s_next].sum()"}),
        "target_in_full": Mistake("the old value counts 1 − α, and the target α: α is missing at the target.",
            {"q[s, a] + alpha * delta": "(1 - alpha) * q[s, a] + target"}),
        "one_minus_alpha": Mistake("α and 1 − α have changed places: the old value counts 1 − α, the target α.",
            {"q[s, a] + alpha * delta": "alpha * q[s, a] + (1 - alpha) * target"}),
        "alpha_target_alone": Mistake("the old value must stay in it: this is α times the target alone.",
            {"q[s, a] + alpha * delta": "alpha * target"}),
        "old_value_off_twice": Mistake("the old value is taken off twice: δ has it already.",
            {"q[s, a] + alpha * delta": "(1 - alpha) * q[s, a] + alpha * delta"}),
        "no_reward": Mistake("the reward is missing: the target is r + γ · Q(s', a').", {"r + gamma": "gamma"}),
        "abs_of_delta": Mistake("δ may be negative, and then q[s, a] must fall. abs and max do not belong here.",
            {"target - q[s, a]": "abs(target - q[s, a])"}),
        "never_falls": Mistake("δ may be negative, and then q[s, a] must fall. max does not belong here.",
            {"target - q[s, a]": "max(0, target - q[s, a])"}),
        "not_below_zero": Mistake("a value may be negative. max does not belong here.",
            {"q[s_next, a_next]": "max(0, q[s_next, a_next])"}),
        "rounds_2": Mistake("your numbers are rounded. Keep them as they are: rounding is for showing.",
            {"q[s, a] + alpha * delta": "round(q[s, a] + alpha * delta, 2)"}),
        "rounds_3": Mistake("your numbers are rounded. Keep them as they are: rounding is for showing.",
            {"q[s, a] + alpha * delta": "round(q[s, a] + alpha * delta, 3)"}),
        "rounds_1": Mistake("your numbers are rounded. Keep them as they are: rounding is for showing.",
            {"q[s, a] + alpha * delta": "round(q[s, a] + alpha * delta, 1)"}),
        "int": Mistake("int cuts off what comes after the point. Values are numbers with a fraction.",
            {"q[s, a] + alpha * delta": "int(q[s, a] + alpha * delta)"}),
        "replaces_at_the_end": Mistake("at the end, too, q[s, a] changes by α · δ: write += there, as everywhere.",
            {"q[s, a] + alpha * delta": "(0 if terminated else q[s, a]) + alpha * delta"}),
        "gamma_twice": Mistake("γ stands inside the target only, before the value that follows. The whole δ is "
            "multiplied by α alone.", {"alpha * delta": "alpha * gamma * delta"}),
        "gamma_on_the_gap": Mistake("γ belongs to the value that follows. Here the old q[s, a] is discounted, too: "
            "mind the brackets.", {"target - q[s, a]": "target - (1 if terminated else gamma) * q[s, a]"}),
        "moves_first": Mistake("s was overwritten before it was used. The pair that learns is where the step began.",
            {"target = r": "s = s_next; target = r"}),
        "is_true": Mistake(IS_TRUE, {"if terminated": "if terminated is True"}),
        "best_and_next": Mistake("both are added here, the best value of s' and that of a'. SARSA takes a' alone.",
            {"q[s_next, a_next]": "(q[s_next, a_next] + q[s_next].max())"}),
        "both_ends": Mistake("(s', a') changes, too. One step of SARSA teaches the pair (s, a) alone.",
            {"q[s, a] = q[s, a] + alpha * delta":
                "q[s, a] = q[s, a] + alpha * delta; q[s_next, a_next] = q[s_next, a_next] + alpha * delta"}),
        "next_q_a_s": Mistake("the state comes first: it is q[s_next, a_next].",
            {"q[s_next, a_next]": "q[a_next, s_next]"}),
        "action_as_value": Mistake("an action is a number like 2, a value what it is worth: q[s_next, a_next] is its "
            "value.", {"q[s_next, a_next]": "a_next"}),
        "argmax": Mistake("argmax is the number of the best action. You need a value, and that of a_next.",
            {"q[s_next, a_next]": "q[s_next].argmax()"}),
        "empties_the_end": Mistake("at the end an episode teaches its last pair. The values of the state after it "
            "stay as they are.",
            {"q[s, a] = q[s, a] + alpha * delta":
                "q[s, a] = q[s, a] + alpha * delta; q[s_next] = q[s_next] * (not terminated)"}),
    },
    witnesses=WITNESSES,
)  # fmt: skip
