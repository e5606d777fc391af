"""A queue that forgets its oldest item."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def push(queue, item, length):
    queue.append(item)
    if len(queue) > length:
        queue.pop(0)


PUSHED = [(28, 4), (0, 4), (12, 4), (28, 4), (0, 4), (7, 4), (-0.02, 6), (10.0, 6), (0, 6), (7, 6)]

CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="append item to the queue, and drop the oldest item if there are now more than length",
    right=push,
    memory={"queue": [15, 12]},
    tape=[{"item": item, "length": length} for item, length in PUSHED],
    another=lambda rng, step: {**step, "item": int(rng.integers(100, 1000))},
    mistakes={
        "drops_nothing": Mistake(
            "nothing is dropped here. First append the item, then look whether there are more than length. And is "
            "the list itself shortened? queue = … makes a new one, and pop needs its brackets: pop(0).",
            {"if len(queue) > length:": "if False:"},
        ),
        "drops_the_new": Mistake(
            "a full queue still takes the new item. It is the oldest that goes.", {"pop(0)": "pop()"}
        ),
        "drops_the_newest": Mistake(
            "the newest item went. It stands last, where pop() takes it, too; the oldest stands first.",
            {"pop(0)": "pop(-2)"},
        ),
        "drops_the_second": Mistake(
            "the second oldest went: the places of a list are counted from 0.", {"pop(0)": "pop(1)"}
        ),
        "joins_at_the_front": Mistake(
            "new items join at the end of the queue, so that the oldest stands first.",
            {"append(item)": "insert(0, item)", "pop(0)": "pop()"},
        ),
        "drops_always": Mistake(
            "an item is dropped at every call. Drop one only if there are more than length.",
            {"if len(queue) > length:": "if True:"},
        ),
        "full_too_early": Mistake(
            "nothing is dropped until the queue is full, and it is full with exactly length items. Here it never "
            "gets full.",
            {"> length": ">= length"},
        ),
        "one_too_few": Mistake(
            "this leaves one item too few: with exactly length items in it, the queue is full, and that is well.",
            {"if len(queue) > length:": "while len(queue) >= length:"},
        ),
        "new_list": Mistake(
            "the list that was handed over has not changed. Is the item appended to it? (queue = … would make a "
            "new list.)",
            {"queue.append(item)": "queue = [*queue, item]"},
        ),
        "only_when_full": Mistake(
            "a queue of exactly length items is full, and may stay so. When there are more, the oldest goes.",
            {"> length": "== length"},
        ),
        "inverted": Mistake(
            "the if is turned round: the oldest goes when there are more items than length.", {"> length": "< length"}
        ),
        "replaces_the_oldest": Mistake(
            "the new item took the place of the oldest. It joins at the end, and all others move up.",
            {"queue.append(item)": "queue.__setitem__(0, item) if len(queue) == length else queue.append(item)"},
        ),
        "own_length": Mistake(
            "a queue need not hold 4 items: how many it may hold is the argument length.", {"length": "4"}
        ),
        "drops_by_value": Mistake(
            "remove(item) looks for that value, wherever it stands. The oldest item is to go, whatever it is.",
            {"pop(0)": "remove(item)"},
        ),
        "no_repeats": Mistake(
            "a state that is in the queue already joins it once more: it is by repeats that a loop is seen.",
            {"queue.append(item)": "queue += [item] * (item not in queue)"},
        ),
        "no_zeros": Mistake(
            "0 is an item like any other (state 0, or a reward of 0).",
            {"queue.append(item)": "queue += [item] if item else []"},
        ),
        "drops_all": Mistake("only the oldest item goes, and here all go.", {"queue.pop(0)": "queue.clear()"}),
        "list_in_a_list": Mistake(
            "[item] is a list with the item in it. Append the item itself.", {"append(item)": "append([item])"}
        ),
        "not_joined_when_full": Mistake(
            "where the oldest has gone, the new item must still join. Append it in any case, so before the if.",
            CHANGED["not_joined_when_full"],
        ),
        "appends_length": Mistake("length is appended here. What joins is item.", {"append(item)": "append(length)"}),
        "drops_zeros": Mistake(
            "remove(0) looks for the value 0. The first item, whatever it is, goes with pop(0).",
            {"pop(0)": "remove(0)"},
        ),
        "joins_twice": Mistake(
            "the item joins twice.", {"queue.append(item)": "queue.append(item); queue.append(item)"}
        ),
        "sorts": Mistake(
            "a queue is not sorted: its items stand in the order in which they came.",
            {"queue.append(item)": "queue.append(item); queue.sort()"},
        ),
        "drops_the_smallest": Mistake(
            "the smallest item went. It is the oldest that goes, which stands first.",
            {"queue.pop(0)": "queue.remove(min(queue))"},
        ),
    },
    hints=(
        "Two things happen, one after the other: the item joins at the end, and if there are too many now, the first "
        "leaves.",
        "append(…) puts something at the end, len(queue) counts, and pop(0) takes the first one out.",
        "queue.append(…) stands first; then: if len(queue) > …: queue.pop(…).",
    ),
    gained="Your robot has a memory for the latest moments of its life. LRLE reads in it from here on.",
    witnesses=WITNESSES,
)
