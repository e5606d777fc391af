"""The new value of Q(s, a), computed by hand."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question
from rlrobot_course.grading.shared_hints import DISCOUNTS_THE_REWARD

by_hand = 4 + 0.2 * (10 + 0.9 * 6 - 4)

exercise = Question(
    task="the new Q(s, a), computed by hand",
    right=by_hand,
    because="4 + 0.2 · (10 + 0.9 · 6 − 4) = 6.28: one fifth of the way from 4 to the target of 15.4.",
    mistakes={
        "target_itself": Mistake(
            "this is the target itself. With α = 0.2, Q goes only a fifth of the way towards it.", 15.4
        ),
        "no_gamma": Mistake("you forgot γ: the value of the next state counts 0.9 times.", 6.4),
        "no_gamma_and_gap_first": Mistake(
            "you forgot γ, and the gap begins at the old Q(s, a): take 4 off before you multiply by α.", 7.2
        ),
        "alpha_times_target": Mistake(
            "you added α times the target. The TD error is the target minus the old Q(s, a).", 7.08
        ),
        "nothing_follows": Mistake("the next state counts, too: add γ times its best value to the reward.", 5.2),
        "delta_alone": Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", 11.4),
        "step_alone": Mistake("this is the step α · δ. Add it to the old Q(s, a).", 2.28),
        "alpha_target_alone": Mistake(
            "this is α times the target. Q moves from 4 towards the target: 4 + α · δ.", 3.08
        ),
        "alpha_and_gamma_swapped": Mistake(
            "α and γ have changed places: α multiplies the whole of δ, γ the value of s'.", 10.48
        ),
        "downwards": Mistake("you took α · δ off. The gap is positive, so Q rises.", 1.72),
        "discounts_the_reward": Mistake(DISCOUNTS_THE_REWARD, 6.08),
        "one_minus_alpha": Mistake(
            "this goes four fifths of the way. α is the share to go, 1 − α the share that stays.", 13.12
        ),
        "best_of_s_next": Mistake(
            "6 is what the best action of s' is worth. Q(s, a) moves a part of the way from 4 to the target. (If "
            "you have rounded: give two digits more.)",
            6.0,
        ),
        "first_action": Mistake("from the next state its best action counts: 6, not 3.7.", 5.866),
        "last_action": Mistake("from the next state its best action counts: 6, not −1.", 5.02),
        "mean": Mistake("from the next state its best action counts: 6, not the mean.", 5.722),
        "sum": Mistake("from the next state its best action counts: 6, not the sum.", 6.766),
        "other_alpha": Mistake("with α = 0.1 it would be this. Here α is 0.2.", 5.14),
        "alpha_on_the_reward_alone": Mistake(
            "brackets: α multiplies the whole gap, 0.2 · (10 + 0.9 · 6 − 4), not the reward alone.", 7.4
        ),
        "gamma_on_the_gap_of_6_and_4": Mistake(
            "brackets: γ multiplies the 6 alone. The old Q(s, a) is taken off in full.", 6.36
        ),
        "minus_what_follows": Mistake("what the next state is worth is added to the reward, not taken off.", 4.12),
        "gamma_as_alpha": Mistake(
            "this goes 0.9 of the way. The share to go is α = 0.2; γ multiplies the value of s'.", 14.26
        ),
        "old_value_follows": Mistake("what follows is worth the best of s', 6, not the old Q(s, a) once more.", 5.92),
        "four_plus_alpha": Mistake(
            "this multiplies 4 + α by the gap. Multiply first, then add: 4 + 0.2 · 11.4.", 47.88
        ),
        "no_reward": Mistake("the reward is missing: the target is 10 + 0.9 · 6.", 4.28),
        "adds_old_value": Mistake("the old Q(s, a) is taken off the target, not added to it.", 7.88),
        "target_in_full": Mistake(
            "the target has the weight α, as the old value has 1 − α: 0.8 · 4 + 0.2 · 15.4.", 18.6
        ),
        "old_value_twice": Mistake(
            "the old value is taken off twice: δ has it already. All of the 4 stays: 4 + 0.2 · 11.4.", 5.48
        ),
        "gamma_times_delta": Mistake(
            "γ belongs to what follows, not to the whole gap. Here the gap is multiplied by it once more.",
            4 + 0.2 * 0.9 * 11.4,
        ),
    },
    hints=(
        "Q(s, a) moves a part of the way from where it is to the target. How far is the target, how large the part?",
        "Target: 10 + 0.9 · (the best of the three). δ: the target minus 4. New value: 4 + 0.2 · δ.",
        "4 + 0.2 * (10 + 0.9 * … - 4): only the best value of s' is missing.",
    ),
    gained="This one line of arithmetic is all that the robot does to learn. The rest is repetition.",
    witnesses={
        "target_itself": [15.4],
        "no_gamma": [6.4],
        "alpha_times_target": [7.08],
        "delta_alone": [11.4],
        "first_action": [5.866],
        "form": [6.3, "6.28"],
        "discounts_the_reward": [6.08],
        "alpha_on_the_reward_alone": [4 + 0.2 * 10 + 0.9 * 6 - 4],
        "gamma_on_the_gap_of_6_and_4": [4 + 0.2 * (10 + 0.9 * (6 - 4))],
        "minus_what_follows": [4 + 0.2 * (10 - 0.9 * 6 - 4)],
        "gamma_as_alpha": [4 + 0.9 * (10 + 0.9 * 6 - 4)],
        "old_value_follows": [4 + 0.2 * (10 + 0.9 * 4 - 4)],
        "four_plus_alpha": [4.2 * 11.4],
    },
)
