"""Exercises of lesson 08: loop evasion."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.lesson_08 import solutions

push = Exercise(
    task="append item to the queue, and drop the oldest item if there are now more than length",
    right=solutions.push,
    memory={"queue": [15, 12]},
    tape=[{"item": item, "length": 4} for item in (28, 48, 28, 12, 15, 28)],
    mistakes=[
        Mistake("the queue grows without end: nothing is dropped when it is longer than length.",
                {"if len(queue) > length:": "if False:"}),
        Mistake("a full queue still takes the new item. It is the oldest that goes.", {"pop(0)": "pop()"}),
        Mistake("the newest item went: pop() takes the last of a list, and the oldest stands first.",
                {"pop(0)": "pop(-2)"}),
        Mistake("new items join at the end of the queue, so that the oldest stands first.",
                {"append(item)": "insert(0, item)", "pop(0)": "pop()"}),
        Mistake("an item is dropped at every call. Drop one only if there are more than length.",
                {"if len(queue) > length:": "if True:"}),
        Mistake("the queue never gets full: with exactly length items in it, nothing is dropped yet.",
                {"> length": ">= length"}),
        Mistake("the list that was handed over has not changed: queue = … makes a new one. Change it with append and "
                "pop.", {"queue.append(item)": "queue = [*queue, item]"}),
    ],
)  # fmt: skip

QUEUES = ([5, 7, 9, 2], [5, 7, 5, 7], [3, 3, 3, 3], [1, 2, 2, 1, 3, 1, 2], [8, 6, 8, 8, 6, 8, 8, 4])

redundancy = Exercise(
    task="return how many states are in the queue for each different one among them",
    right=solutions.redundancy,
    returns="redundancy",
    tape=[{"states": states} for states in QUEUES],
    mistakes=[
        Mistake("this is upside down: size over different states, so that a loop gives a large number.",
                {"len(states) / len(set(states))": "len(set(states)) / len(states)"}),
        Mistake("this is the number of different states. The size of the queue is to be divided by it.",
                {"len(states) / ": ""}),
        Mistake("this counts the repeats. What is asked is a quotient: size over different states.", {"/": "-"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"/": "//"}),
        Mistake("a queue is not always 21 long: divide its own length, len(states).", {"len(states)": "21"}),
        Mistake("this is how often one state is there, the most frequent one. All of them count.",
                {"len(states) / len(set(states))": "max(states.count(s) for s in states)"}),
        Mistake("this is how often the last state is there. All of them count.",
                {"len(states) / len(set(states))": "states.count(states[-1])"}),
        Mistake("this is the size of the queue. Divide it by the number of different states.",
                {" / len(set(states))": ""}),
    ],
)  # fmt: skip

IDLE = [-0.02] * 8

# (temperature, states, rewards, default); s is the last of the states
SITUATIONS = (
    (1.0, [0, 1, 2, 3, 4, 5, 6, 7], IDLE, 1.0),  # on its way
    (1.0, [4, 6, 4, 6, 4, 6, 4, 6], IDLE, 1.0),  # a loop
    (2.0, [6, 4, 6, 4, 6, 4, 6, 4], IDLE, 1.0),  # goes on
    (5.0, [0, 1, 2, 3, 4, 5, 6, 0], IDLE, 1.0),  # once round a large circle
    (5.0, [6, 4, 6, 4, 6, 1, 2, 1], IDLE, 1.0),  # redundancy of exactly 2
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [10.0, -2.0] * 4, 1.0),  # a loop that pays, though the last reward is negative
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [-2.0] * 7 + [10.0], 1.0),  # a loop that does not, though the last one is positive
    (3.0, [3, 3, 3, 5, 5, 5, 3, 9], IDLE, 1.0),  # it has just left
    (7.0, [3, 5, 3, 5, 3, 5, 3, 5], [0.0] * 8, 1.0),  # zero is not negative
    (9.0, [0, 1, 2, 3, 4, 5, 6, 7], IDLE, 0.1),  # another default
    (0.1, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),
    (49.5, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),  # near the cap
    (50.0, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),
)

new_temperature = Exercise(
    task="return the temperature that LRLE sets",
    right=solutions.new_temperature,
    returns="temperature",
    tape=[
        {"temperature": temperature, "states": states, "rewards": rewards, "s": states[-1], "default": default}
        for temperature, states, rewards, default in SITUATIONS
    ],
    mistakes=[
        Mistake("outside a loop the temperature falls back to the default; here it stays as it is.",
                {"return default": "return temperature"}),
        Mistake("the temperature outside loops is the argument default, not always 1.",
                {"return default": "return 1.0"}),
        Mistake("the temperature never rises here. Is the redundancy upside down (it is size / different)? Or did you "
                "take the sizes of the rewards, without their signs?", {"if visited_before": "if False"}),
        Mistake("the temperature has a cap: it never rises above 50.",
                {"min(50, temperature + 0.25 * redundancy(states))": "temperature + 0.25 * redundancy(states)"}),
        Mistake("a redundancy of exactly 2 is not enough: it must be above 2, so > and not ≥.", {"> 2": ">= 2"}),
        Mistake("the third sign is missing: act only if the redundancy is above 2.",
                {" and redundancy(states) > 2": ""}),
        Mistake("this loop pays: its mean reward is not below 0. Such a loop is left in peace.", {" and low": ""}),
        Mistake("a mean reward of exactly 0 is not below 0: < and not ≤.", {"< 0": "<= 0"}),
        Mistake("you look at the last reward only. It is the mean over the queue that must be below 0.",
                {"sum(rewards) / len(rewards)": "rewards[-1]"}),
        Mistake("s is always in the queue, for it has just been pushed. It was there before if it is in it more than "
                "once.", {"> 1": "> 0"}),
        Mistake("the temperature rises from where it is, not from the default. So it climbs while the loop lasts.",
                {"temperature + ": "default + "}),
        Mistake("a quarter of the redundancy is added, not a quarter alone.", {"0.25 * redundancy(states)": "0.25"}),
    ],
)  # fmt: skip

steps_to_the_cap = Question(
    task="the number of steps after which the temperature is at its cap",
    right=solutions.steps_to_the_cap,
    because="Each step adds 0.25 · 21 / 2 = 2.625. From 1 to 50 it is 49 / 2.625 = 18.7, so the 19th step gets there.",
    mistakes=[
        Mistake("after 18 steps the temperature is 48.25, not quite 50.", 18),
        Mistake("steps are whole: after how many of them is it there?", 49 / 2.625),
        Mistake("the robot starts at T = 1, not at 0. Count once more.", 20),
        Mistake("that would be without the factor 0.25: each step adds a quarter of the redundancy.", 5),
        Mistake("that would be 0.25 a step. Each step adds 0.25 times the redundancy.", 196),
        Mistake("that would be with a single state in the queue. Here there are two different ones.", 10),
        Mistake("the redundancy is 21 / 2 = 10.5: the queue holds 21 states, not 2 or 4.", 98),
    ],
)

heats = Question(
    task='the letters of the situations in which the temperature rises, such as "BD"',
    right=solutions.heats,
    because="In A and C it should. In F it does so, too, although the robot can do nothing better than wait.",
    mistakes=[
        Mistake("and F? The rule sees states and rewards only. It cannot know that waiting is wise.", "AC"),
        Mistake("one state over and over is a loop, too: its redundancy is 21. That makes two more.", "A"),
        Mistake("one state over and over is a loop, too: its redundancy is 21. Look at C again.", "AF"),
        Mistake("look at B again: 15 different states among 21 make a redundancy of 1.4.", "ABCF"),
        Mistake("look at B again, where the redundancy is 21 / 15, and at F, where waiting looks like a loop.", "ABC"),
        Mistake("look at E again: a mean reward of 0 is not below 0.", "ACEF"),
        Mistake("look at D again: the mean of +10 and −2 is above 0.", "ACDF"),
        Mistake("these are the others: in which does it rise?", "BDE"),
        Mistake("not every loop counts: the mean reward must be below 0, and the redundancy above 2.", "ABCDEF"),
    ],
)
