"""Exercises of lesson 11: what the end of an episode does, what to and fro pays, and a reward that cannot be milked."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_11 import solutions

__all__ = ["shaping", "targets", "to_and_fro"]

targets = Question(
    task="two numbers as a tuple: the target of the step that terminates, and of the one that is cut off",
    right=solutions.targets,
    because="After the goal there is nothing more to come: 10. The clock ends the film, not the world: 10 + 0.9 · 50.",
    mistakes=[
        Mistake("the other way round: it is the goal that ends all rewards, not the clock.", (55.0, 10.0)),
        Mistake("only one of the two episodes is really over. Which?", (10.0, 10.0)),
        Mistake("at the goal the world ends: what Q promises past it does not count.", (55.0, 55.0)),
        Mistake("after the cut there is more to come: 0.9 · 50 on top of the reward.", (10.0, 45.0)),
        Mistake("what comes a step later counts 0.9 times.", (10.0, 60.0)),
        Mistake("the reward of the step counts in full; it is the value after it that is discounted.", (10.0, 54.0)),
        Mistake("a target has the reward of the step in it, also at the end.", (0.0, 55.0)),
        Mistake("the second one is the value alone. The reward of the step belongs to it.", (10.0, 50.0)),
    ],
    hints=(
        "The target is r + γ · (the value after the step). Is there anything after the step?",
        "At the goal there is nothing: r alone. At the cut the robot could go on from s′, which is worth 50.",
        "(10, 10 + 0.9 · …)",
    ),
    gained="This is why an environment returns two words, terminated and truncated, and not one.",
)

to_and_fro = Question(
    task="the return of +5, −1, +5, −1 … for ever, with γ = 0.9",
    right=solutions.to_and_fro,
    because="One round is worth 5 − 0.9 · 1 = 4.1, and each round counts 0.81 times the one before: 4.1 / 0.19 = 21.6.",
    mistakes=[
        Mistake("a round has two steps, so the next round counts 0.9² = 0.81 times: divide by 1 − 0.81.", 41.0),
        Mistake("within a round the −1 comes one step later: it counts 0.9 times.", 4 / 0.19),
        Mistake("this is one round only, and it goes on for ever.", 4.1),
        Mistake("this is one round without discount. It goes on for ever, with γ = 0.9.", 4),
        Mistake("this is the mean reward of a step. What is asked is the return.", 2),
        Mistake("that is 2 a step, for ever: nearly. But the 5 comes first, and counts more.", 20),
        Mistake("that would be 5 in every step.", 50),
        Mistake("the 5 comes first. Yours begins with the −1.", (-1 + 0.9 * 5) / 0.19),
        Mistake("the −1 is a cost: take it off.", 5.9 / 0.19),
        Mistake("this is 10 for ever, the most that can be earned. To and fro pays less.", 100),
        Mistake("a round is worth 4.1 and the next one 0.81 times that: divide by 1 − 0.81, do not multiply.",
                4.1 * 0.19),
    ],
    hints=(
        "Take two steps together as a round. What is a round worth, and how much less does the next one count?",
        "A round is worth 5 + 0.9 · (−1) = 4.1. Each next one counts 0.9 · 0.9 times as much.",
        "4.1 / (1 − 0.9 ** 2)",
    ),
    gained="A loop of rewards is worth its round over 1 − γ to the length of the round. Set that against the goal.",
)  # fmt: skip

STEPS = [(-3.0, -2.0, False, 0.9), (-2.0, -3.0, False, 0.9), (-1.0, -7.0, True, 0.9), (-4.0, -4.0, False, 0.9),
         (2.5, 4.0, False, 0.5), (0.0, -1.5, False, 1.0), (6.0, 3.0, True, 0.8), (-5.0, 0.0, False, 0.99)]  # fmt: skip

shaping = Exercise(
    task="return what shaping adds to the reward of a step",
    right=solutions.shaping,
    returns="addition",
    tape=[dict(zip(("phi", "phi_next", "terminated", "gamma"), step, strict=True)) for step in STEPS],
    mistakes=[
        Mistake("past the end φ counts as 0: look at terminated.", {"if terminated:": "if False:"}),
        Mistake("γ is missing: γ times the potential after the step, less the one before it.",
                {"gamma * phi_next": "phi_next"}),
        Mistake("γ belongs to the potential after the step, not to the one before it.",
                {"gamma * phi_next - phi": "phi_next - gamma * phi"}),
        Mistake("γ multiplies the later potential alone, not the whole difference.",
                {"gamma * phi_next - phi": "gamma * (phi_next - phi)"}),
        Mistake("the sign: what comes after, less what was before.",
                {"gamma * phi_next - phi": "phi - gamma * phi_next"}),
        Mistake("the potential before the step is missing.", {" - phi": ""}),
        Mistake("the potential before the step is taken off, not added.", {"- phi": "+ phi"}),
        Mistake("turned round: φ counts as 0 where the episode terminates.", {"if terminated": "if not terminated"}),
        Mistake("at the end it is the potential after the step that counts as 0. The one before it is still taken off.",
                {"phi_next = 0.0": "return 0.0"}),
        Mistake("only a gain is paid by yours. A retreat must cost what the approach has paid, or to and fro pays.",
                {"gamma * phi_next - phi": "max(0.0, gamma * phi_next - phi)"}),
        Mistake("γ is the argument gamma, not always 0.9.", {"gamma * phi_next": "0.9 * phi_next"}),
        Mistake("a positive number for every move will not do: leave abs out.",
                {"gamma * phi_next - phi": "abs(gamma * phi_next - phi)"}),
    ],
    hints=(
        "Two numbers: the potential after the step, which comes a step later, and the one before it.",
        "gamma * phi_next - phi, and phi_next counts as 0 where the episode has terminated.",
        "return gamma * (0 if terminated else …) - …",
    ),
    gained="With this you may lead any learner by any hint that you like, and it cannot be milked.",
)  # fmt: skip
