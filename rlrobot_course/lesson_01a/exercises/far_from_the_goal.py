"""The value of a state four steps from the goal."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

far_from_the_goal = 0.8**3

exercise = Question(
    task="the value of a state that is four steps away from the goal, with γ = 0.8",
    right=far_from_the_goal,
    because="The rewards ahead are 0, 0, 0 and 1, so V = 0.8 · 0.8 · 0.8 · 1 = 0.512.",
    mistakes={
        "one_too_many": Mistake(
            "one factor too many: the fourth step has γ to the power of 3, because the first has the power of 0.",
            0.8**4,
        ),
        "two_too_many": Mistake("two factors too many. Write down the four rewards and number them from 0.", 0.8**5),
        "one_too_few": Mistake("one factor too few. Write down the four rewards and number them from 0.", 0.8**2),
        "no_gamma": Mistake(
            "you forgot γ: a reward that lies three steps behind the next one does not count in full.", 1.0
        ),
        "gamma_once": Mistake("γ counts once for every step that the reward lies ahead, not once in all.", 0.8),
        "next_reward_alone": Mistake("only the next reward is 0. The value looks at all that is to come.", 0.0),
        "all_pay": Mistake("only the step into the goal pays 1; the steps before it pay 0.", 1 + 0.8 + 0.8**2 + 0.8**3),
        "pays_for_ever": Mistake(
            "only the step into the goal pays 1, and it pays once. Nothing follows after it.", 5.0
        ),
        "plain_sum": Mistake("only the step into the goal pays 1; the steps before it pay 0.", 4.0),
        "gamma_times_4": Mistake("γ is a factor for each step. You multiplied it by their number.", 0.8 * 4),
        "gamma_times_3": Mistake("γ is a factor for each step. You multiplied it by their number.", 0.8 * 3),
        "divides_by_4": Mistake("γ is a factor for each step. You divided it by their number.", 0.2),
        "takes_off": Mistake("γ is a factor for each step. Here 0.2 is taken away for each.", 0.4),
        "one_minus_gamma": Mistake("the factor for each step is γ = 0.8, not 1 − γ.", 0.2**3),
        "one_minus_gamma_4_times": Mistake("the factor for each step is γ = 0.8, not 1 − γ.", 0.2**4),
        "gamma_of_a_half": Mistake("0.125 would be right for γ = 0.5. Here γ is 0.8.", 0.125),
        "gamma_of_0_9": Mistake("0.729 would be right for γ = 0.9. Here γ is 0.8.", 0.729),
        "grows": Mistake("γ makes what comes later count less. Multiply by its power, do not divide.", 0.8**-3),
        "two_of_them": Mistake("only the last of the four rewards is 1. This counts two of them.", 0.8**3 + 0.8**4),
        "root": Mistake("this is the third root of γ. The reward counts γ to the power of 3 times.", 0.8 ** (1 / 3)),
        "what_is_lost": Mistake("this is what is lost, 1 − γ³. What remains is the value.", 1 - 0.8**3),
        "all_but_the_first": Mistake(
            "only the step into the goal pays 1; the steps before it pay 0.", 0.8 + 0.8**2 + 0.8**3
        ),
        "product_of_powers": Mistake(
            "the powers of γ are multiplied here. One power is enough: γ³, for the one reward.", 0.8**6
        ),
    },
    hints=(
        "Four steps, four rewards: which are they? Only the step that enters the goal pays.",
        "The rewards are 0, 0, 0, 1, numbered from 0. Which power of γ has the last one?",
        "The last one has number 3: V = 0.8 · 0.8 · 0.8 · 1.",
    ),
    gained="This is how a goal far away makes itself felt: a little fainter with every step.",
    witnesses={
        "one_too_many": [0.4096],
        "one_too_few": [0.64],
        "no_gamma": [1],
        "gamma_once": [0.8],
        "next_reward_alone": [0],
        "all_pay": [2.952],
        "form": [0.51, "0.512", [0.512]],
        "gamma_times_4": [3.2],
        "divides_by_4": [0.2],
        "grows": [1 / 0.512],
        "root": [0.8 ** (1 / 3)],
        "two_of_them": [0.8**4 + 0.8**3],
    },
)
