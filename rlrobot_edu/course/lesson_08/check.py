"""Exercises of lesson 08: loop evasion. Its questions stand in `questions`."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.lesson_08 import solutions
from rlrobot_edu.course.lesson_08.questions import heats, steps_to_the_cap

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
        Mistake("nothing is dropped here. First append the item, then look whether there are more than length.",
                {"if len(queue) > length:": "if False:"}),
        Mistake("a full queue still takes the new item. It is the oldest that goes.", {"pop(0)": "pop()"}),
        Mistake("the newest item went: pop() takes the last of a list, and the oldest stands first.",
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
    ],
    hints=(
        "Two numbers are needed: how many states are in the queue, and how many different ones.",
        "len(states) is the first, len(set(states)) the second.",
        "return len(…) / len(set(…))",
    ),
    gained="One number now tells a robot on its way (1) from one that goes round in circles.",
)  # fmt: skip

IDLE = [-0.02] * 8
HITS = [-0.02, -2.0, -0.02, -2.0, -0.02, -0.02, -0.02, -0.02]

# (temperature, states, rewards, default); s is the last of the states
SITUATIONS = (
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], HITS, 0.5),  # a loop; from here on all classic mistakes differ
    (1.0, [0, 1, 2, 3, 4, 5, 6, 7], [10.0] * 8, 1.0),  # on its way
    (1.0, [4, 6, 4, 6, 4, 6, 4, 6], IDLE, 1.0),
    (2.0, [4, 6, 9, 4, 6, 9, 4], IDLE[:7], 1.0),  # three states, and a redundancy of little more than 2
    (5.0, [0, 1, 2, 3, 4, 5, 6, 0], IDLE, 1.0),  # once round a large circle
    (5.0, [6, 4, 6, 4, 6, 1, 2, 1], IDLE, 1.0),  # redundancy of exactly 2
    (2.0, [4, 4, 4, 6, 6, 6, 9, 9], IDLE, 0.5),  # s twice in it, and a redundancy that is no whole number
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [10.0, -2.0, -2.0, 10.0, -2.0, 10.0, -2.0, -2.0], 1.0),  # a loop that pays
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [-2.0] * 7 + [10.0], 1.0),  # a loop that does not, though the last one is positive
    (3.0, [3, 3, 3, 5, 5, 5, 3, 9], IDLE, 1.0),  # it has just left
    (7.0, [3, 5, 3, 5, 3, 5, 3, 5], [0.0] * 8, 1.0),  # zero is not negative
    (9.0, [0, 1, 2, 3, 4, 5, 6, 7], IDLE, 0.1),  # another default
    (0.1, [3, 3, 3, 3, 3, 3], IDLE[:6], 0.1),  # a shorter queue
    (0.37, [7, 8] * 10 + [7], [-0.02] * 21, 0.37),  # a longer one
    (49.5, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),  # near the cap
    (50.0, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),
)

RISE = "min(50, temperature + 0.25 * redundancy(states))"

new_temperature = Exercise(
    task="return the temperature that LRLE sets",
    right=solutions.new_temperature,
    returns="temperature",
    lenders={name: "the function of the exercise above: write it, and run its cell" for name in ("redundancy", "push")},
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
        Mistake("all three signs must be there at once: and, where you have or.", {" and ": " or "}),
        Mistake("the temperature has a cap: it never rises above 50.", {RISE: RISE[8:-1]}),
        Mistake("max(50, …) is at least 50. The temperature may be at most 50: min.", {"min(50": "max(50"}),
        Mistake("at the cap the temperature stays at 50 while the loop lasts.",
                {"redundancy(states) > 2": "redundancy(states) > 2 and temperature < 50"}),
        Mistake("the temperature does not jump to 50 at once: it rises by a quarter of the redundancy.", {RISE: "50"}),
        Mistake("from 49.5, this steps over 50. It is the new temperature that may be at most 50.",
                {RISE: "temperature + (0.25 * redundancy(states) if temperature < 50 else 0)"}),
        Mistake("it heats where there is no loop, and not where there is one: the if is turned round.",
                {"if visited_before and low and redundancy(states) > 2:":
                 "if not (visited_before and low and redundancy(states) > 2):"}),
        Mistake("it heats always, whatever the signs say.", {"return default": f"return {RISE}"}),
        Mistake("the queues that come in here are full, and not always 21 long.",
                {"if visited_before": "if len(states) == 21 and visited_before"}),
        Mistake("a redundancy of exactly 2 is not enough: it must be above 2, so > and not ≥.", {"> 2": ">= 2"}),
        Mistake("the third sign is missing: act only if the redundancy is above 2.",
                {" and redundancy(states) > 2": ""}),
        Mistake("the third sign is the redundancy, size / different, above 2, not the number of different states.",
                {"redundancy(states) > 2": "len(set(states)) > 2"}),
        Mistake("the second sign is missing. This loop pays: its mean reward is not below 0. Such a loop is left in "
                "peace.", {" and low": ""}),
        Mistake("it is the other way round: the mean reward must be below 0.", {"< 0": "> 0"}),
        Mistake("a mean reward of exactly 0 is not below 0: < and not ≤.", {"< 0": "<= 0"}),
        Mistake("below 0 is enough, however little.", {"< 0": "< -0.1"}),
        Mistake("you look at the last reward only. It is the mean over the queue that must be below 0.",
                {"sum(rewards) / len(rewards)": "rewards[-1]"}),
        Mistake("one bad reward is not enough: it is the mean over the queue that must be below 0.",
                {"sum(rewards) / len(rewards)": "min(rewards)"}),
        Mistake("not every reward must be below 0, only their mean.", {"sum(rewards) / len(rewards)": "max(rewards)"}),
        Mistake("s is always in the queue, for it has just been pushed. It was there before if it is in it more than "
                "once.", {"> 1": "> 0"}),
        Mistake("twice is enough: s has just been pushed, and it was there once before.", {"> 1": "> 2"}),
        Mistake("you ask whether the robot stands still, s twice in a row. Any earlier place in the queue counts.",
                {"states.count(s) > 1": "states[-2] == s"}),
        Mistake("you ask whether s is the oldest in the queue. Any earlier place in it counts.",
                {"states.count(s) > 1": "states[0] == s"}),
        Mistake("the temperature rises from where it is, not from the default. So it climbs while the loop lasts.",
                {"temperature + ": "default + "}),
        Mistake("a quarter of the redundancy is added, not a quarter alone.", {"0.25 * redundancy(states)": "0.25"}),
        Mistake("a quarter of the redundancy is added: the factor 0.25 is missing.", {"0.25 * ": ""}),
        Mistake("the rise is added to the temperature, not multiplied with it.", {"temperature + ": "temperature * "}),
        Mistake("the rise alone is not the temperature: add it to the one up to now.", {"temperature + ": ""}),
        Mistake("the temperature falls here. In a loop it should rise.", {"temperature + ": "temperature - "}),
        Mistake("0.25 times the redundancy, not 0.25 divided by it: the tighter the loop, the more heat.",
                {"0.25 * redundancy(states)": "0.25 / redundancy(states)"}),
        Mistake("the redundancy is not always 10.5: work it out from states.", {"redundancy(states)": "10.5"}),
        Mistake("it is the redundancy that counts, not how often s alone is in the queue.",
                {"0.25 * redundancy(states)": "0.25 * states.count(s)"}),
        Mistake("0.25 times the redundancy, not 0.25 plus it.",
                {"0.25 * redundancy(states)": "0.25 + redundancy(states)"}),
        Mistake("s has been pushed already and counts in the redundancy like the others: take all of states.",
                {"redundancy(states)": "redundancy(states[:-1])"}),
        Mistake("// cuts off what comes after the point. The redundancy is size / different.",
                {"redundancy(states)": "(len(states) // len(set(states)))"}),
        Mistake("a queue is not always 21 long: take len(states).",
                {"redundancy(states)": "(21 / len(set(states)))"}),
    ],
    hints=(
        "Give each of the three signs a line of its own, with a name: it is True or False. Then one if.",
        "states.count(s) > 1 is the first sign; the mean of rewards below 0 the second; your redundancy above 2 the "
        "third.",
        "if first and second and third: return min(50, temperature + 0.25 * …), and after it: return default.",
    ),
    gained="This is the whole of LRLE, and it will free a robot in a minute. In lesson 09 it joins your learner.",
)  # fmt: skip
