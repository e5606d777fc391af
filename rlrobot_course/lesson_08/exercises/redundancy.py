"""The redundancy of a queue of states."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def redundancy(states):
    return len(states) / len(set(states))


def another_queue(rng: np.random.Generator, case: Case) -> Case:
    """A queue of the same length, or one longer, of other states."""
    states = (np.array(case["states"]) + rng.integers(1, 50)).tolist()
    return {"states": [*states, int(rng.choice(states))] if states and rng.random() < 0.5 else states}


QUEUES = (
    [2, 4, 2, 9, 2, 4, 2, 5, 2, 9, 4],
    [5, 7, 9, 2],
    [5, 7, 5, 7],
    [3, 3, 3, 3, 3, 3],
    [1, 2, 2, 1, 3, 1, 2],
    [6, 8, 8, 6, 8, 8, 4, 8],
)

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return how many states are in the queue for each different one among them",
    right=redundancy,
    returns="redundancy",
    tape=[{"states": states} for states in QUEUES],
    another=another_queue,
    mistakes={
        "upside_down": Mistake(
            "this is upside down: size over different states, so that a loop gives a large number.",
            {"len(states) / len(set(states))": "len(set(states)) / len(states)"},
        ),
        "different_alone": Mistake(
            "this is the number of different states. The size of the queue is to be divided by it.",
            {"len(states) / ": ""},
        ),
        "repeats": Mistake(
            "this counts the repeats. What is asked is a quotient: size over different states.", {"/": "-"}
        ),
        "one_taken_off": Mistake(
            "all states of the queue count: divide len(states), with nothing taken off.",
            {"len(states) / ": "(len(states) - 1) / "},
        ),
        "states_that_repeat": Mistake(
            "this is how many states come more than once. What is asked is size over different states.",
            {"len(states) / len(set(states))": "sum(states.count(s) > 1 for s in set(states))"},
        ),
        "whole_division": Mistake(
            "what comes after the point is cut off: // and int(…) do that. Divide with / alone.", {"/": "//"}
        ),
        "own_length": Mistake(
            "a queue is not always 21 long: divide its own length, len(states).", {"len(states)": "21"}
        ),
        "most_frequent": Mistake(
            "this is how often one state is there, the most frequent one. All of them count.",
            {"len(states) / len(set(states))": "max(states.count(s) for s in states)"},
        ),
        "visits_of_the_last": Mistake(
            "this is how often the last state is there. All of them count.",
            {"len(states) / len(set(states))": "states.count(states[-1])"},
        ),
        "visits_of_the_first": Mistake(
            "this is how often the first state is there. All of them count.",
            {"len(states) / len(set(states))": "states.count(states[0])"},
        ),
        "size_alone": Mistake(
            "this is the size of the queue. Divide it by the number of different states.", {" / len(set(states))": ""}
        ),
        "sum_of_states": Mistake(
            "the states are added up here. But their numbers are only names: count them, with len.",
            {"len(states) / len": "sum(states) / len"},
        ),
        "share_of_repeats": Mistake(
            "this is the share of repeats among all. What is asked is size over different states.",
            {"len(states) / len(set(states))": "1 - len(set(states)) / len(states)"},
        ),
        "divides_by_repeats": Mistake(
            "the size is divided by the repeats. Divide it by the number of different states, len(set(states)).",
            {"len(set(states))": "max(1, len(states) - len(set(states)))"},
        ),
        "divides_by_the_single": Mistake(
            "you divide by the states that are there only once. Every different state counts, as often as it may "
            "be there.",
            {"len(set(states))": "max(1, sum(states.count(s) == 1 for s in states))"},
        ),
        "divides_by_changes": Mistake(
            "you divide by how often the state changes. A state that comes back is no new one.",
            {"len(set(states))": "(1 + sum(x != y for x, y in zip(states, states[1:])))"},
        ),
        "one_too_many": Mistake("you divide by one too many.", {"len(set(states))": "(1 + len(set(states)))"}),
        "remainder": Mistake("% is what remains of a division; / divides.", {"/": "%"}),
        "product": Mistake("this is size times different states. What is asked is a quotient.", {"/": "*"}),
        "above_2": Mistake(
            "this says whether it is above 2, yes or no. Return the redundancy itself.",
            {"len(states) / len(set(states))": "len(states) / len(set(states)) > 2"},
        ),
        "largest_number": Mistake(
            "the number of a state is only its name. How many different ones are there? len(set(states)).",
            {"len(set(states))": "max(states)"},
        ),
        "no_set": Mistake("without set(…) nothing is different: every queue gives 1.", {"set(states)": "states"}),
        "mean_of_visits": Mistake(
            "this is how often a state is there on average, when asked of each place in the queue: frequent ones "
            "count again and again. Ask each different state once: size / different.",
            {"len(states) / len(set(states))": "sum(states.count(s) for s in states) / len(states)"},
        ),
        "divides_by_the_repeated": Mistake(
            "you divide by the states that come more than once. Those that come once are different ones, too.",
            {"len(set(states))": "max(1, sum(states.count(s) > 1 for s in set(states)))"},
        ),
        "share_of_the_last": Mistake(
            "this is the share of the last state among all. What is asked is size over different states.",
            {"len(states) / len(set(states))": "states.count(states[-1]) / len(states)"},
        ),
        "share_of_the_most_frequent": Mistake(
            "this is the most frequent state's share. What is asked is size over different states.",
            {"len(states) / len(set(states))": "max(states.count(s) for s in states) / len(states)"},
        ),
        "not_all": Mistake(
            "all states count, the first and the last one, too: len(set(states)).", {"set(states)": "set(states[1:])"}
        ),
        "most_over_rarest": Mistake(
            "this compares the most frequent state with the rarest. Asked is size over different states.",
            {
                "len(states) / len(set(states))": (
                    "max(states.count(s) for s in states) / min(states.count(s) for s in states)"
                )
            },
        ),
    },
    hints=(
        "Two numbers are needed: how many states are in the queue, and how many different ones.",
        "len(states) is the first, len(set(states)) the second.",
        "return len(…) / len(set(…))",
    ),
    gained="One number now tells a robot on its way (1) from one that goes round in circles.",
    witnesses=WITNESSES,
)
