"""The new value of Q(s, a) by SARSA, computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question
from rlrobot_course.grading.shared_hints import DISCOUNTS_THE_REWARD

by_hand = -4 + 0.25 * (-3 + 0.5 * -40 - -4)

exercise = Question(
    task="the new Q(s, a) after SARSA's update, computed by hand",
    right=by_hand,
    because="−4 + 0.25 · (−3 + 0.5 · (−40) + 4) = −8.75: the careless action that follows counts.",
    hints=(
        "SARSA asks what the action that comes next is worth, not the best one. Which of the four values is that?",
        "The target is r + γ · Q(s', a'), with a' = down. Then Q goes a quarter of the way from −4 to it.",
        "−4 + 0.25 · (−3 + 0.5 · (−40) − (−4))",
    ),
    gained="This is what makes SARSA careful: one careless action follows, and the way to it looks worse.",
    mistakes={
        "q_learning": Mistake(
            "this is Q-learning's answer: it took the best value in s'. SARSA takes that of a', −40.",
            -4 + 0.25 * (-3 + 0.5 * -3 + 4),
        ),
        "target_itself": Mistake(
            "this is the target itself. With α = 0.25, Q goes only a quarter of the way towards it.", -3 + 0.5 * -40
        ),
        "no_gamma": Mistake("you forgot γ: the value of a' in s' counts half.", -4 + 0.25 * (-3 - 40 + 4)),
        "alpha_times_target": Mistake(
            "you added α times the target. The TD error is the target minus the old Q(s, a).",
            -4 + 0.25 * (-3 + 0.5 * -40),
        ),
        "delta_alone": Mistake(
            "this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", -3 + 0.5 * -40 + 4
        ),
        "step_alone": Mistake("this is the step α · δ. Add it to the old Q(s, a).", 0.25 * (-3 + 0.5 * -40 + 4)),
        "mean": Mistake(
            "this counts the mean over the actions of s'. SARSA looks at one action only, at a'.",
            -4 + 0.25 * (-3 + 0.5 * -13.5 + 4),
        ),
        "no_reward": Mistake("the reward is missing: the target is r + γ · Q(s', a').", -4 + 0.25 * (0.5 * -40 + 4)),
        "signs": Mistake("watch the signs: taking off a negative number adds it.", -4 + 0.25 * (-3 + 0.5 * -40 - 4)),
        "discounts_the_reward": Mistake(DISCOUNTS_THE_REWARD, -4 + 0.25 * (0.5 * (-3 - 40) + 4)),
        "right": Mistake(
            "this takes the value of right, −5. The action that follows is down.", -4 + 0.25 * (-3 + 0.5 * -5 + 4)
        ),
        "left": Mistake(
            "this takes the value of left, −6. The action that follows is down.", -4 + 0.25 * (-3 + 0.5 * -6 + 4)
        ),
        "downwards": Mistake("α · δ was taken off. It is added, whatever its sign.", -4 - 0.25 * (-3 + 0.5 * -40 + 4)),
        "one_minus_alpha": Mistake(
            "α and 1 − α have changed places: Q goes a quarter of the way, not three quarters.",
            -4 + 0.75 * (-3 + 0.5 * -40 + 4),
        ),
        "alpha_target_alone": Mistake(
            "this is α times the target; what remains of the old value, three quarters of −4, is missing.",
            0.25 * (-3 + 0.5 * -40),
        ),
        "reward_without_its_sign": Mistake("the reward has lost its sign: it is −3.", -4 + 0.25 * (3 + 0.5 * -40 + 4)),
        "alpha_and_gamma_swapped": Mistake(
            "α and γ have changed places: γ multiplies the value of a', α the whole gap.",
            -4 + 0.5 * (-3 + 0.25 * -40 + 4),
        ),
        "other_gamma": Mistake("with γ = 0.9 it would be this. Here γ is 0.5.", -4 + 0.25 * (-3 + 0.9 * -40 + 4)),
        "other_alpha": Mistake("with α = 0.1 it would be this. Here α is 0.25.", -4 + 0.1 * (-3 + 0.5 * -40 + 4)),
        "gamma_on_the_gap": Mistake(
            "γ multiplies Q(s', a') alone. The old Q(s, a) is taken off in full: mind the brackets.",
            -4 + 0.25 * (-3 + 0.5 * (-40 + 4)),
        ),
        "sum": Mistake("this adds up all four values of s'. Only that of a' counts.", -4 + 0.25 * (-3 + 0.5 * -54 + 4)),
        "one_rate_for_both": Mistake(
            "γ = 0.5 multiplies Q(s', a'), and α = 0.25 the whole gap. You took 0.25 for both, or γ twice.",
            -4 + 0.25 * (-3 + 0.25 * -40 + 4),
        ),
        "minus_what_follows": Mistake(
            "γ · Q(s', a') is added, and is negative already: −3 + 0.5 · (−40).", -4 + 0.25 * (-3 - 0.5 * -40 + 4)
        ),
        "alpha_on_the_reward_alone": Mistake(
            "α multiplies the whole gap, 0.25 · (target − Q(s, a)), not the reward alone: mind the brackets.",
            -4 + 0.25 * -3 + 0.5 * -40 + 4,
        ),
        "target_in_full": Mistake(
            "the target has the weight α, as the old value has 1 − α.", 0.75 * -4 + (-3 + 0.5 * -40)
        ),
        "gamma_for_alpha": Mistake(
            "the gap is multiplied by γ, and α is missing. α is the share to go, γ belongs to the value of a'.",
            -4 + 0.5 * (-3 + 0.5 * -40 + 4),
        ),
        "old_value_follows": Mistake(
            "the target is r + γ · Q(s', a'). What follows counts here, but not the old value: δ is the target minus "
            "Q(s, a).",
            -4 + (-3 + 0.5 * -40),
        ),
    },
    witnesses={
        "q_learning": [-4.125],
        "target_itself": [-23],
        "no_gamma": [-13.75],
        "alpha_times_target": [-9.75],
        "delta_alone": [-19],
        "step_alone": [-4.75],
        "discounts_the_reward": [-8.375],
        "no_reward": [-8],
        "form": [8.75],
        "gamma_on_the_gap": [-4 + 0.25 * (-3 + 0.5 * (-40 + 4))],
        "alpha_and_gamma_swapped": [-8.5],
        "other_gamma": [-12.75],
        "gamma_for_alpha": [-13.5],
        "sum": [-4 + 0.25 * (-3 + 0.5 * (-3 - 5 - 40 - 6) + 4)],
        "one_rate_for_both": [-4 + 0.25 * (-3 + 0.25 * -40 + 4)],
    },
)
