"""The new value of Q(s, a) by SARSA, computed by hand."""

from __future__ import annotations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.shared_hints import DISCOUNTS_THE_REWARD

by_hand = -6 + 0.25 * (-2 + 0.5 * -40 - -6)

exercise = Question(
    task="the new Q(s, a) after SARSA's update, computed by hand",
    right=by_hand,
    because="−6 + 0.25 · (−2 + 0.5 · (−40) + 6) = −10: the careless action that follows counts.",
    hints=(
        "SARSA asks what the action that comes next is worth, not the best one. Which of the four values is that?",
        "The target is r + γ · Q(s', a'), with a' = down. Then Q goes a quarter of the way from −6 to it.",
        "−6 + 0.25 · (−2 + 0.5 · (−40) − (−6))",
    ),
    gained="This is what makes SARSA careful: one careless action follows, and the way to it looks worse.",
    mistakes={
        "q_learning": Mistake(
            "this is Q-learning's answer: it took the best value in s'. SARSA takes that of a', −40.", -5.375
        ),
        "target_itself": Mistake(
            "this is the target itself. With α = 0.25, Q goes only a quarter of the way towards it.", -22.0
        ),
        "no_gamma": Mistake("you forgot γ: the value of a' in s' counts half.", -15.0),
        "alpha_times_target": Mistake(
            "you added α times the target. The TD error is the target minus the old Q(s, a).", -11.5
        ),
        "delta_alone": Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", -16.0),
        "step_alone": Mistake("this is the step α · δ. Add it to the old Q(s, a).", -4.0),
        "mean": Mistake("this counts the mean over the actions of s'. SARSA looks at one action only, at a'.", -6.6875),
        "no_reward": Mistake("the reward is missing: the target is r + γ · Q(s', a').", -9.5),
        "signs": Mistake("watch the signs: taking off a negative number adds it.", -13.0),
        "discounts_the_reward": Mistake(DISCOUNTS_THE_REWARD, -9.75),
        "right": Mistake("this takes the value of right, −5. The action that follows is down.", -5.625),
        "left": Mistake("this takes the value of left, −6. The action that follows is down.", -5.75),
        "downwards": Mistake("α · δ was taken off. It is added, whatever its sign.", -2.0),
        "one_minus_alpha": Mistake(
            "α and 1 − α have changed places: Q goes a quarter of the way, not three quarters.", -18.0
        ),
        "alpha_target_alone": Mistake(
            "this is α times the target; what remains of the old value, three quarters of −6, is missing.", -5.5
        ),
        "reward_of_2": Mistake(
            "two slips lead here. Either the reward has lost its sign, it is −2; or α and γ have changed places, and "
            "it is γ that multiplies the value of a'.",
            -9.0,
        ),
        "gamma_on_the_gap": Mistake(
            "γ multiplies Q(s', a') alone. The old Q(s, a) is taken off in full: mind the brackets.", -10.75
        ),
        "sum": Mistake("this adds up all four values of s'. Only that of a' counts.", -11.75),
        "one_rate_for_both": Mistake(
            "γ = 0.5 multiplies Q(s', a'), and α = 0.25 the whole gap. You took 0.25 for both, or γ twice.", -7.5
        ),
        "minus_what_follows": Mistake("γ · Q(s', a') is added, and is negative already: −2 + 0.5 · (−40).", 0.0),
        "alpha_on_the_reward_alone": Mistake(
            "α multiplies the whole gap, 0.25 · (target − Q(s, a)), not the reward alone: mind the brackets.",
            -6 + 0.25 * -2 + 0.5 * -40 + 6,
        ),
        "target_in_full": Mistake("the target has the weight α, as the old value has 1 − α.", 0.75 * -6 - 22),
        "gamma_for_alpha": Mistake(
            "the gap is multiplied by γ, and α is missing. α is the share to go, γ belongs to the value of a'.",
            -6 + 0.5 * -16,
        ),
        "old_value_follows": Mistake(
            "the target is r + γ · Q(s', a'). What follows counts here, but not the old value: δ is the target minus "
            "Q(s, a).",
            -6 - 22.0,
        ),
    },
    witnesses={
        "q_learning": [-5.375],
        "target_itself": [-22],
        "no_gamma": [-15],
        "alpha_times_target": [-11.5],
        "delta_alone": [-16],
        "step_alone": [-4],
        "discounts_the_reward": [-9.75],
        "no_reward": [-9.5],
        "form": [10],
        "gamma_on_the_gap": [-6 + 0.25 * (-2 + 0.5 * (-40 + 6))],
        "reward_of_2": [-6 + 0.5 * (-2 + 0.25 * -40 + 6)],
        "sum": [-6 + 0.25 * (-2 + 0.5 * (-3 - 5 - 40 - 6) + 6)],
        "one_rate_for_both": [-6 + 0.25 * (-2 + 0.25 * -40 + 6)],
    },
)
