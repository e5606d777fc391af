"""The two questions of lesson 04: an update by hand, and how dangerous the edge is."""

from __future__ import annotations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_04 import solutions

by_hand = Question(
    task="the new Q(s, a) after SARSA's update, computed by hand",
    right=solutions.by_hand,
    because="−6 + 0.25 · (−2 + 0.5 · (−40) + 6) = −10: the careless action that follows counts.",
    hints=(
        "SARSA asks what the action that comes next is worth, not the best one. Which of the four values is that?",
        "The target is r + γ · Q(s', a'), with a' = down. Then Q goes a quarter of the way from −6 to it.",
        "−6 + 0.25 · (−2 + 0.5 · (−40) − (−6))",
    ),
    gained="This is what makes SARSA careful: one careless action follows, and the way to it looks worse.",
    mistakes=[
        Mistake("this is Q-learning's answer: it took the best value in s'. SARSA takes that of a', −40.", -5.375),
        Mistake("this is the target itself. With α = 0.25, Q goes only a quarter of the way towards it.", -22.0),
        Mistake("you forgot γ: the value of a' in s' counts half.", -15.0),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", -11.5),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", -16.0),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", -4.0),
        Mistake("this counts the mean over the actions of s'. SARSA looks at one action only, at a'.", -6.6875),
        Mistake("the reward is missing: the target is r + γ · Q(s', a').", -9.5),
        Mistake("watch the signs: taking off a negative number adds it.", -13.0),
        Mistake("γ discounts what comes later; the reward of this step counts in full.", -9.75),
        Mistake("this takes the value of right, −5. The action that follows is down.", -5.625),
        Mistake("this takes the value of left, −6. The action that follows is down.", -5.75),
        Mistake("α · δ was taken off. It is added, whatever its sign.", -2.0),
        Mistake("α and 1 − α have changed places: Q goes a quarter of the way, not three quarters.", -18.0),
        Mistake("this is α times the target; what remains of the old value, three quarters of −6, is missing.", -5.5),
        Mistake(
            "two slips lead here. Either the reward has lost its sign, it is −2; or α and γ have changed places, and "
            "it is γ that multiplies the value of a'.",
            -9.0,
        ),
        Mistake("γ multiplies Q(s', a') alone. The old Q(s, a) is taken off in full: mind the brackets.", -10.75),
        Mistake("this adds up all four values of s'. Only that of a' counts.", -11.75),
        Mistake("γ = 0.5 multiplies Q(s', a'), and α = 0.25 the whole gap. You took 0.25 for both, or γ twice.", -7.5),
        Mistake("γ · Q(s', a') is added, and is negative already: −2 + 0.5 · (−40).", 0.0),
        Mistake(
            "α multiplies the whole gap, 0.25 · (target − Q(s, a)), not the reward alone: mind the brackets.",
            -6 + 0.25 * -2 + 0.5 * -40 + 6,
        ),
        Mistake("the target has the weight α, as the old value has 1 − α.", 0.75 * -6 - 22),
        Mistake(
            "the gap is multiplied by γ, and α is missing. α is the share to go, γ belongs to the value of a'.",
            -6 + 0.5 * -16,
        ),
        Mistake(
            "the target is r + γ · Q(s', a'). What follows counts here, but not the old value: δ is the target minus "
            "Q(s, a).",
            -6 - 22.0,
        ),
    ],
)

fall = Question(
    task="how probable at least one fall is on the way along the edge",
    right=solutions.fall,
    because="1 − 0.975¹¹ = 0.243: nearly every fourth walk along the edge ends in the cliff.",
    hints=(
        "ask for the opposite: how probable is it that nothing happens, eleven times in a row?",
        "one dangerous step goes wrong with probability 0.1 · 1/4. It goes well with 1 minus that; eleven of them with "
        "the 11th power.",
        "1 − (1 − 0.1 / 4) ** 11, with the ordinary minus sign",
    ),
    gained="A small risk, eleven times over, is no small risk. This is what SARSA has felt and Q-learning has not.",
    mistakes=[
        Mistake("this is the probability of not falling at all. Falling is the rest, up to 1.", 0.975**11),
        Mistake("probabilities of repeated chances do not add up: 50 steps would give more than 1. Compute the "
                "probability that no step falls, and take the rest.", 11 * 0.025),
        Mistake("with ε = 0.1 one step in ten explores, but only one of the four actions leads over the edge.",
                1 - 0.9**11),
        Mistake("nearly: this is rounded. Write the expression and let Python compute it.", 0.24),
        Mistake("a probability lies between 0 and 1: divide the per cent by 100.", 100 * (1 - 0.975**11)),
        Mistake("this is the risk of one step. There are eleven such steps.", 0.025),
        Mistake("this is the probability of falling at every one of the eleven steps. Once is enough.", 0.025**11),
        Mistake("exploring picks any of four actions, the best one included: down has the share 1/4, not 1/3.",
                1 - (1 - 0.1 / 3) ** 11),
        Mistake("there are eleven such steps: the first of them is at the start, then ten above the cliff.",
                1 - 0.975**10),
        Mistake("not all 13 steps are dangerous, only eleven of them.", 1 - 0.975**13),
        Mistake("not 12: at the start one step, and ten above the cliff.", 1 - 0.975**12),
        Mistake("this adds up to more than 1, and nothing is more probable than certain. Compute the probability that "
                "no step falls, and take the rest.", 1.1),
        Mistake("this is the probability of not exploring in eleven steps. Exploring need not lead into the cliff.",
                0.9**11),
        Mistake("this is the probability that one step goes well. There are eleven, and falling is the opposite.",
                0.975),
        Mistake("here exploring leads into the cliff with probability 1/2. It is one action of four.",
                1 - 0.95**11),
        Mistake("ε is 0.1, and the cliff is one action of four: one step goes wrong with 0.1 / 4, not with 1 / 4.",
                1 - 0.75**11),
        Mistake("this is the probability of exploring at every one of the eleven steps. Once is enough.", 0.1**11),
        Mistake("probabilities of repeated chances do not add up, and not all 13 steps are dangerous.", 13 * 0.025),
        Mistake("11 is an exponent, not a factor: 1 − (1 − 0.025) ** 11.", 1 - 0.975 * 11),
        Mistake("this is the risk for any number of steps. It has the eleven in it already.", 11 * (1 - 0.975**11)),
        Mistake("this is the probability of not falling at every one of the eleven steps, nearly 1. You want 1 "
                "minus the probability that all go well: 1 − (1 − 0.025) ** 11.", 1 - 0.025**11),
        Mistake("this is how often exploring leads down. One step in ten explores, and there are eleven.", 0.25),
        Mistake("this is the probability of not exploring in one step. Falling is another thing, and there are eleven.",
                0.9),
        Mistake("this is the risk of exploring in one step, and only a quarter of that leads into the cliff.", 0.1),
        Mistake("this is the probability of falling at exactly one step. Two falls are also a fall at least once.",
                11 * 0.025 * 0.975**10),
    ],
)  # fmt: skip
