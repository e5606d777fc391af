"""Exercises of lesson 08: loop evasion. That on the temperature stands in `temperature_check`, those in numbers and
letters in `questions`.
"""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.lesson_08 import solutions
from rlrobot_edu.course.lesson_08.questions import heats, steps_to_the_cap
from rlrobot_edu.course.lesson_08.temperature_check import new_temperature

__all__ = ["heats", "new_temperature", "push", "redundancy", "steps_to_the_cap"]


def another_queue(rng: np.random.Generator, case: Case) -> Case:
    """A queue of the same length, or one longer, of other states."""
    states = (np.array(case["states"]) + rng.integers(1, 50)).tolist()
    return {"states": [*states, int(rng.choice(states))] if states and rng.random() < 0.5 else states}


PUSHED = [(28, 4), (0, 4), (12, 4), (28, 4), (0, 4), (7, 4), (-0.02, 6), (10.0, 6), (0, 6), (7, 6)]

push = Exercise(
    task="append item to the queue, and drop the oldest item if there are now more than length",
    right=solutions.push,
    memory={"queue": [15, 12]},
    tape=[{"item": item, "length": length} for item, length in PUSHED],
    another=lambda rng, step: {**step, "item": int(rng.integers(100, 1000))},
    mistakes=[
        Mistake("nothing is dropped here. First append the item, then look whether there are more than length. And is "
                "the list itself shortened? queue = … makes a new one, and pop needs its brackets: pop(0).",
                {"if len(queue) > length:": "if False:"}),
        Mistake("a full queue still takes the new item. It is the oldest that goes.", {"pop(0)": "pop()"}),
        Mistake("the newest item went. It stands last, where pop() takes it, too; the oldest stands first.",
                {"pop(0)": "pop(-2)"}),
        Mistake("the second oldest went: the places of a list are counted from 0.", {"pop(0)": "pop(1)"}),
        Mistake("new items join at the end of the queue, so that the oldest stands first.",
                {"append(item)": "insert(0, item)", "pop(0)": "pop()"}),
        Mistake("an item is dropped at every call. Drop one only if there are more than length.",
                {"if len(queue) > length:": "if True:"}),
        Mistake("nothing is dropped until the queue is full, and it is full with exactly length items. Here it never "
                "gets full.", {"> length": ">= length"}),
        Mistake("this leaves one item too few: with exactly length items in it, the queue is full, and that is well.",
                {"if len(queue) > length:": "while len(queue) >= length:"}),
        Mistake("the list that was handed over has not changed. Is the item appended to it? (queue = … would make a "
                "new list.)", {"queue.append(item)": "queue = [*queue, item]"}),
        Mistake("a queue of exactly length items is full, and may stay so. When there are more, the oldest goes.",
                {"> length": "== length"}),
        Mistake("the if is turned round: the oldest goes when there are more items than length.",
                {"> length": "< length"}),
        Mistake("the new item took the place of the oldest. It joins at the end, and all others move up.",
                {"queue.append(item)": "queue.__setitem__(0, item) if len(queue) == length else queue.append(item)"}),
        Mistake("a queue need not hold 4 items: how many it may hold is the argument length.", {"length": "4"}),
        Mistake("remove(item) looks for that value, wherever it stands. The oldest item is to go, whatever it is.",
                {"pop(0)": "remove(item)"}),
        Mistake("a state that is in the queue already joins it once more: it is by repeats that a loop is seen.",
                {"queue.append(item)": "queue += [item] * (item not in queue)"}),
        Mistake("0 is an item like any other (state 0, or a reward of 0).",
                {"queue.append(item)": "queue += [item] if item else []"}),
        Mistake("only the oldest item goes, and here all go.", {"queue.pop(0)": "queue.clear()"}),
        Mistake("[item] is a list with the item in it. Append the item itself.", {"append(item)": "append([item])"}),
        Mistake("where the oldest has gone, the new item must still join. Append it in any case, so before the if.",
                {"queue.append(item)": "pass",
                 "if len(queue) > length:": "if len(queue) < length:\n        queue.append(item)\n    else:"}),
        Mistake("length is appended here. What joins is item.", {"append(item)": "append(length)"}),
        Mistake("remove(0) looks for the value 0. The first item, whatever it is, goes with pop(0).",
                {"pop(0)": "remove(0)"}),
        Mistake("the item joins twice.", {"queue.append(item)": "queue.append(item); queue.append(item)"}),
        Mistake("a queue is not sorted: its items stand in the order in which they came.",
                {"queue.append(item)": "queue.append(item); queue.sort()"}),
        Mistake("the smallest item went. It is the oldest that goes, which stands first.",
                {"queue.pop(0)": "queue.remove(min(queue))"}),
    ],
    hints=(
        "Two things happen, one after the other: the item joins at the end, and if there are too many now, the first "
        "leaves.",
        "append(…) puts something at the end, len(queue) counts, and pop(0) takes the first one out.",
        "queue.append(…) stands first; then: if len(queue) > …: queue.pop(…).",
    ),
    gained="Your robot has a memory for the latest moments of its life. LRLE reads in it from here on.",
)  # fmt: skip

QUEUES = ([2, 4, 2, 9, 2, 4, 2, 5, 2, 9, 4], [5, 7, 9, 2], [5, 7, 5, 7], [3, 3, 3, 3, 3, 3], [1, 2, 2, 1, 3, 1, 2],
          [6, 8, 8, 6, 8, 8, 4, 8])  # fmt: skip

redundancy = Exercise(
    task="return how many states are in the queue for each different one among them",
    right=solutions.redundancy,
    returns="redundancy",
    tape=[{"states": states} for states in QUEUES],
    another=another_queue,
    mistakes=[
        Mistake("this is upside down: size over different states, so that a loop gives a large number.",
                {"len(states) / len(set(states))": "len(set(states)) / len(states)"}),
        Mistake("this is the number of different states. The size of the queue is to be divided by it.",
                {"len(states) / ": ""}),
        Mistake("this counts the repeats. What is asked is a quotient: size over different states.", {"/": "-"}),
        Mistake("all states of the queue count: divide len(states), with nothing taken off.",
                {"len(states) / ": "(len(states) - 1) / "}),
        Mistake("this is how many states come more than once. What is asked is size over different states.",
                {"len(states) / len(set(states))": "sum(states.count(s) > 1 for s in set(states))"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"/": "//"}),
        Mistake("a queue is not always 21 long: divide its own length, len(states).", {"len(states)": "21"}),
        Mistake("this is how often one state is there, the most frequent one. All of them count.",
                {"len(states) / len(set(states))": "max(states.count(s) for s in states)"}),
        Mistake("this is how often the last state is there. All of them count.",
                {"len(states) / len(set(states))": "states.count(states[-1])"}),
        Mistake("this is how often the first state is there. All of them count.",
                {"len(states) / len(set(states))": "states.count(states[0])"}),
        Mistake("this is the size of the queue. Divide it by the number of different states.",
                {" / len(set(states))": ""}),
        Mistake("the states are added up here. But their numbers are only names: count them, with len.",
                {"len(states) / len": "sum(states) / len"}),
        Mistake("this is the share of repeats among all. What is asked is size over different states.",
                {"len(states) / len(set(states))": "1 - len(set(states)) / len(states)"}),
        Mistake("the size is divided by the repeats. Divide it by the number of different states, len(set(states)).",
                {"len(set(states))": "max(1, len(states) - len(set(states)))"}),
        Mistake("you divide by the states that are there only once. Every different state counts, as often as it may "
                "be there.", {"len(set(states))": "max(1, sum(states.count(s) == 1 for s in states))"}),
        Mistake("you divide by how often the state changes. A state that comes back is no new one.",
                {"len(set(states))": "(1 + sum(x != y for x, y in zip(states, states[1:])))"}),
        Mistake("you divide by one too many.", {"len(set(states))": "(1 + len(set(states)))"}),
        Mistake("% is what remains of a division; / divides.", {"/": "%"}),
        Mistake("this is size times different states. What is asked is a quotient.", {"/": "*"}),
        Mistake("this says whether it is above 2, yes or no. Return the redundancy itself.",
                {"len(states) / len(set(states))": "len(states) / len(set(states)) > 2"}),
        Mistake("the number of a state is only its name. How many different ones are there? len(set(states)).",
                {"len(set(states))": "max(states)"}),
        Mistake("without set(…) nothing is different: every queue gives 1.", {"set(states)": "states"}),
        Mistake("this is how often a state is there on average, when asked of each place in the queue: frequent ones "
                "count again and again. Ask each different state once: size / different.",
                {"len(states) / len(set(states))": "sum(states.count(s) for s in states) / len(states)"}),
        Mistake("you divide by the states that come more than once. Those that come once are different ones, too.",
                {"len(set(states))": "max(1, sum(states.count(s) > 1 for s in set(states)))"}),
        Mistake("this is the share of the last state among all. What is asked is size over different states.",
                {"len(states) / len(set(states))": "states.count(states[-1]) / len(states)"}),
        Mistake("this is the most frequent state's share. What is asked is size over different states.",
                {"len(states) / len(set(states))": "max(states.count(s) for s in states) / len(states)"}),
        Mistake("all states count, the first and the last one, too: len(set(states)).",
                {"set(states)": "set(states[1:])"}),
        Mistake("this compares the most frequent state with the rarest. Asked is size over different states.",
                {"len(states) / len(set(states))":
                 "max(states.count(s) for s in states) / min(states.count(s) for s in states)"}),
    ],
    hints=(
        "Two numbers are needed: how many states are in the queue, and how many different ones.",
        "len(states) is the first, len(set(states)) the second.",
        "return len(…) / len(set(…))",
    ),
    gained="One number now tells a robot on its way (1) from one that goes round in circles.",
)  # fmt: skip
