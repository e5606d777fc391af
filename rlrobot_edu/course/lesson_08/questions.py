"""Questions of lesson 08, which are answered by hand."""

from __future__ import annotations

from itertools import chain, combinations

from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_08 import solutions

steps_to_the_cap = Question(
    task="the number of steps after which the temperature is at its cap",
    right=solutions.steps_to_the_cap,
    because="Each step adds 0.25 · 21 / 2 = 2.625. From 1 to 50 it is 49 / 2.625 = 18.7, so the 19th step gets there.",
    mistakes=[
        Mistake("after 18 steps the temperature is 48.25, not quite 50.", 18),
        Mistake("steps are whole: after how many of them is it there?", 49 / 2.625),
        Mistake("steps are whole, and the robot starts at T = 1: it has only 49 to climb.", 50 / 2.625),
        Mistake("the robot starts at T = 1, not at 0. Count once more.", 20),
        Mistake("that would be without the factor 0.25: each step adds a quarter of the redundancy.", 5),
        Mistake("each step adds a quarter of the redundancy, and steps are whole.", 49 / 10.5),
        Mistake("each step adds a quarter of the redundancy, which is 10.5.", 4),
        Mistake("this is the way from 1 to 50. How much of it is one step?", 49),
        Mistake("that would be 0.25 a step. Each step adds 0.25 times the redundancy.", 196),
        Mistake("that would be 0.25 a step, and from 0 on. Each step adds 0.25 times the redundancy.", 200),
        Mistake("that would be with a single state in the queue. Here there are two different ones.", 10),
        Mistake("that would be with a single state in the queue. Here there are two different ones.", 49 / 5.25),
        Mistake(
            "that would be with a single state in the queue, and from 0 on. Here there are two different ones.",
            50 / 5.25,
        ),
        Mistake("the redundancy is 21 / 2 = 10.5: the queue holds 21 states, not 2 or 4.", 98),
        Mistake("its queue is full already: the first step with LRLE heats.", 40),
        Mistake("this is how much one step adds. How many of them does it take from 1 to 50?", 2.625),
        Mistake("this is the redundancy. A quarter of it is added in each step.", 10.5),
        Mistake("this is the size of the queue, which is full already.", 21),
    ],
    hints=(
        "How much does one step add? How far is it from the default to the cap?",
        "One step adds 0.25 · 21 / 2, and the way is 50 − 1 long.",
        "49 / 2.625 is not whole: the step in which it gets there is the next whole number.",
    ),
    gained="So a rut of two states is at full heat in 19 steps. A wider one takes longer: 94 at a redundancy of 2.1.",
)

# what to look at again where a letter is missing, or too many
LOOK = {
    "A": "look at A again: two states among 21 make a redundancy of 10.5.",
    "B": "look at B again: 15 different states among 21 make a redundancy of 21 / 15 = 1.4.",
    "C": "look at C again: one state over and over is a loop, too. Its redundancy is 21.",
    "D": "look at D again: the mean of +10 and −2 is above 0.",
    "E": "look at E again: a mean reward of 0 is not below 0.",
    "F": "and F? The rule sees states and rewards only. It cannot know that waiting is wise.",
}


def _about(letters: str) -> str:
    """The hint for an answer: its first wrong letter, and how many more there are."""
    wrong = [letter for letter in LOOK if (letter in letters) != (letter in solutions.heats)]
    more = ("", " (And one more is not right.)", f" (And {len(wrong) - 1} more are not right.)")
    return LOOK[wrong[0]] + more[min(len(wrong) - 1, 2)]


EVERY = ("".join(letters) for letters in chain(*(combinations(LOOK, n) for n in range(1, 7))))

heats = Question(
    task='the letters of the situations in which the temperature rises, such as "BD"',
    right=solutions.heats,
    because="In A and C it should. In F it does so, too, although the robot can do nothing better than wait.",
    mistakes=[Mistake(_about(letters), letters) for letters in EVERY if letters != solutions.heats],
    hints=(
        "Two questions for each letter: is the redundancy above 2, and is the mean reward below 0?",
        "Redundancies: A 10.5, B 1.4, C 21, D 10.5, E 10.5, F 21. And the means?",
        "B fails by its redundancy, and two others by their mean. What is left?",
    ),
    gained="You can now tell, before you run it, where this rule will help and where it will not.",
)
