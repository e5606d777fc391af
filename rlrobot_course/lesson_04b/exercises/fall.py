"""The probability of falling off the cliff."""

from __future__ import annotations

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

fall = 1 - (1 - 0.1 / 4) ** 11

exercise = Question(
    task="how probable at least one fall is on the way along the edge",
    right=fall,
    because="1 − 0.975¹¹ = 0.243: nearly every fourth walk along the edge ends in the cliff.",
    hints=(
        "ask for the opposite: how probable is it that nothing happens, eleven times in a row?",
        "one dangerous step goes wrong with probability 0.1 · 1/4. It goes well with 1 minus that; eleven of them with "
        "the 11th power.",
        "1 − (1 − 0.1 / 4) ** 11, with the ordinary minus sign",
    ),
    gained="A small risk, eleven times over, is no small risk. This is what SARSA has felt and Q-learning has not.",
    mistakes={
        "never_falls": Mistake(
            "this is the probability of not falling at all. Falling is the rest, up to 1.", 0.975**11
        ),
        "adds_up": Mistake(
            "probabilities of repeated chances do not add up: 50 steps would give more than 1. Compute the "
            "probability that no step falls, and take the rest.",
            11 * 0.025,
        ),
        "every_exploration": Mistake(
            "with ε = 0.1 one step in ten explores, but only one of the four actions leads over the edge.", 1 - 0.9**11
        ),
        "rounded": Mistake("nearly: this is rounded. Write the expression and let Python compute it.", 0.24),
        "per_cent": Mistake("a probability lies between 0 and 1: divide the per cent by 100.", 100 * (1 - 0.975**11)),
        "one_step": Mistake("this is the risk of one step. There are eleven such steps.", 0.025),
        "every_step": Mistake(
            "this is the probability of falling at every one of the eleven steps. Once is enough.", 0.025**11
        ),
        "one_of_three": Mistake(
            "exploring picks any of four actions, the best one included: down has the share 1/4, not 1/3.",
            1 - (1 - 0.1 / 3) ** 11,
        ),
        "three_of_four": Mistake(
            "three of the four actions are harmless here, and one leads into the cliff: its share of ε is 1/4.",
            1 - (1 - 0.1 * 3 / 4) ** 11,
        ),
        "ten_steps": Mistake(
            "there are eleven such steps: the first of them is at the start, then ten above the cliff.", 1 - 0.975**10
        ),
        "thirteen_steps": Mistake("not all 13 steps are dangerous, only eleven of them.", 1 - 0.975**13),
        "twelve_steps": Mistake("not 12: at the start one step, and ten above the cliff.", 1 - 0.975**12),
        "adds_explorations": Mistake(
            "this adds up to more than 1, and nothing is more probable than certain. Compute the probability that "
            "no step falls, and take the rest.",
            1.1,
        ),
        "no_exploration": Mistake(
            "this is the probability of not exploring in eleven steps. Exploring need not lead into the cliff.", 0.9**11
        ),
        "one_step_well": Mistake(
            "this is the probability that one step goes well. There are eleven, and falling is the opposite.", 0.975
        ),
        "one_of_two": Mistake(
            "here exploring leads into the cliff with probability 1/2. It is one action of four.", 1 - 0.95**11
        ),
        "no_epsilon": Mistake(
            "ε is 0.1, and the cliff is one action of four: one step goes wrong with 0.1 / 4, not with 1 / 4.",
            1 - 0.75**11,
        ),
        "explores_every_step": Mistake(
            "this is the probability of exploring at every one of the eleven steps. Once is enough.", 0.1**11
        ),
        "adds_up_thirteen": Mistake(
            "probabilities of repeated chances do not add up, and not all 13 steps are dangerous.", 13 * 0.025
        ),
        "factor_for_exponent": Mistake("11 is an exponent, not a factor: 1 − (1 − 0.025) ** 11.", 1 - 0.975 * 11),
        "any_number": Mistake(
            "this is the risk for any number of steps. It has the eleven in it already.", 11 * (1 - 0.975**11)
        ),
        "not_every_step": Mistake(
            "this is the probability of not falling at every one of the eleven steps, nearly 1. You want 1 "
            "minus the probability that all go well: 1 − (1 − 0.025) ** 11.",
            1 - 0.025**11,
        ),
        "one_of_four": Mistake(
            "this is how often exploring leads down. One step in ten explores, and there are eleven.", 0.25
        ),
        "no_exploration_in_one": Mistake(
            "this is the probability of not exploring in one step. Falling is another thing, and there are eleven.", 0.9
        ),
        "exploration_in_one": Mistake(
            "this is the risk of exploring in one step, and only a quarter of that leads into the cliff.", 0.1
        ),
        "exactly_once": Mistake(
            "this is the probability of falling at exactly one step. Two falls are also a fall at least once.",
            11 * 0.025 * 0.975**10,
        ),
    },
    witnesses={
        "never_falls": [0.975**11],
        "three_of_four": [1 - 0.925**11],
        "adds_up": [0.275],
        "every_exploration": [1 - (1 - 0.1) ** 11],
        "one_step": [0.1 / 4],
        "per_cent": [24.3],
        "one_of_three": [1 - (1 - 0.1 / 3) ** 11],
        "explores_every_step": [0.1**11],
        "any_number": [0.243 * 11],
        "adds_up_thirteen": [13 * 0.025],
        "not_every_step": [1 - 0.025**11],
        "no_exploration_in_one": [1 - 0.1],
    },
)
