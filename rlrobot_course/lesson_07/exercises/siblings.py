"""The states that differ from a state in one input at most."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def siblings(shape, s, i):
    bins = list(np.unravel_index(s, shape))
    numbers = []
    for k in range(shape[i]):
        bins[i] = k
        numbers.append(int(np.ravel_multi_index(bins, shape)))
    return numbers


def another_set(rng: np.random.Generator, case: Case) -> Case:
    """A case with as many inputs, of which each has more bins."""
    shape = tuple(n + int(rng.integers(1, 3)) for n in case["shape"])
    return {"shape": shape, "s": int(rng.integers(np.prod(shape))), "i": case["i"]}


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the numbers of the states that share all inputs with s but input i, from small to large",
    right=siblings,
    returns="siblings",
    tape=[
        {"shape": shape, "s": s, "i": i}
        for shape, s, i in (
            ((2, 2, 3, 2), 21, 2),
            ((2, 2, 3, 2), 21, 0),
            ((2, 2, 3, 2), 4, 3),
            ((2, 2, 3, 2), 13, 1),
            ((2, 5, 3), 17, 1),
            ((4, 3), 7, 0),
            ((4, 3), 7, 1),
            ((5,), 2, 0),
        )
    ],
    another=another_set,
    mistakes={
        "without_s": Mistake(
            "s itself belongs to the set, too: it shares all other inputs with itself.",
            {"return numbers": "return [k for k in numbers if k != s]"},
        ),
        "s_alone": Mistake(
            "this is s alone. Input i may take any of its bins; all others stay as they are in s.",
            {"return numbers": "return [s]"},
        ),
        "turned_round": Mistake(
            "you have turned it round: these states share input i and differ in the others. They should share all "
            "others.",
            {
                "return numbers": (
                    "return [k for k in range(np.prod(shape)) if np.unravel_index(k, shape)[i] == numbers.index(s)]"
                )
            },
        ),
        "all_inputs": Mistake(
            "these are the sets of all inputs in one. Only input i may differ.",
            {"return numbers": "return sorted({k for j in range(len(shape)) for k in siblings(shape, s, j)})"},
        ),
        "first_fastest": Mistake(
            "here the first input counts fastest. In this course the last one does (lesson 01).",
            {"index(s, shape)": "index(s, shape, order='F')", "index(bins, shape)": "index(bins, shape, order='F')"},
        ),
        "upward_from_s": Mistake(
            "this counts upward from s. The set begins where input i is in bin 0, which may lie below s.",
            {"return numbers": "return [s + k - numbers[0] for k in numbers]"},
        ),
        "neighbours_in_number": Mistake(
            "these are neighbours in number. To change input i by one bin, the number changes by the product of "
            "the bins of all inputs after i.",
            {"return numbers": "return [s - s % shape[i] + k for k in range(shape[i])]"},
        ),
        "bins_for_numbers": Mistake(
            "these are the bins of the right states. Turn each back into a number, with your state_number.",
            {"int(np.ravel_multi_index(bins, shape))": "[int(b) for b in bins]"},
        ),
        "unsorted": Mistake(
            "the right states, but not in order: from small to large, please, as a list.",
            {"return numbers": "return [s, *(k for k in numbers if k != s)]"},
        ),
        "a_set": Mistake(
            "the right states, but a set has no order. Return a sorted list.", {"return numbers": "return set(numbers)"}
        ),
        "not_the_last_bin": Mistake(
            "the last bin is missing: input i has shape[i] of them, 0 to shape[i] − 1, and range(n) ends there by "
            "itself.",
            {"range(shape[i])": "range(shape[i] - 1)"},
        ),
        "not_bin_0": Mistake(
            "bins are counted from 0. The state in which input i is in bin 0 is missing.",
            {"range(shape[i])": "range(1, shape[i])"},
        ),
        "input_before": Mistake(
            "input 0 is the first one. Here the one before input i is changed.",
            {"shape[i]": "shape[i - 1]", "bins[i]": "bins[i - 1]"},
        ),
        "neighbours_alone": Mistake(
            "input i may take any of its bins, not only the next to its own.",
            {"range(shape[i])": "range(max(0, bins[i] - 1), min(shape[i], bins[i] + 2))"},
        ),
        "return_in_the_loop": Mistake(
            "it ends with the first state. Does return stand inside a loop?",
            {
                "numbers.append(int(np.ravel_multi_index(bins, shape)))": (
                    "return [int(np.ravel_multi_index(bins, shape))]"
                )
            },
        ),
        "all_states": Mistake(
            "these are all the states there are.", {"return numbers": "return list(range(np.prod(shape)))"}
        ),
        "distance_with_own_bins": Mistake(
            "the distance of two members is the product of the bins of the inputs *after* i; here that of input i "
            "is in it, too.",
            {"return numbers": "return [numbers[0] + k * int(np.prod(shape[i:])) for k in range(shape[i])]"},
        ),
        "same_bins": Mistake(
            "these are bins, and the same list again and again. Turn the bins into a number each time.",
            {"int(np.ravel_multi_index(bins, shape))": "bins"},
        ),
        "counts_from_1": Mistake(
            "these are not numbers of states: bins are counted from 0 to shape[i] − 1.",
            {"return numbers": "return [n + numbers[1] - numbers[0] for n in numbers]"},
        ),
        "how_many": Mistake(
            "this is how many there are. Return the list of them.", {"return numbers": "return len(numbers)"}
        ),
        "distance_of_own_bins": Mistake(
            "two members are not shape[i] apart: it is the product of the bins of all inputs after i.",
            {"return numbers": "return [numbers[0] + k * shape[i] for k in range(shape[i])]"},
        ),
        "distance_of_bins_before": Mistake(
            "two members are as far apart as the product of the bins of all inputs *after* i, not before it.",
            {"return numbers": "return [numbers[0] + k * int(np.prod(shape[:i])) for k in range(shape[i])]"},
        ),
        "downward_from_s": Mistake(
            "this counts downward from s. The set may go on above s.",
            {"return numbers": "return [s - n + numbers[0] for n in numbers[::-1]]"},
        ),
        "one_list_again_and_again": Mistake(
            "this is one state, again and again. A list of bins that is appended several times is the same list each "
            "time, as it is at the end: turn it into a number at once, or append a copy, list(bins).",
            {"return numbers": "return [numbers[-1]] * len(numbers)"},
        ),
        "s_twice": Mistake("one state is not to be added several times.", {"return numbers": "return numbers + [s]"}),
        "distance_of_1": Mistake(
            "two members are 1 apart only for the last input: it is the product of the bins of all inputs after i.",
            {"return numbers": "return [s - numbers.index(s) + k for k in range(shape[i])]"},
        ),
        "own_24_states": Mistake(
            "there are not always 24 states, but as many as the bins of all inputs multiplied: np.prod(shape).",
            {
                "return numbers": (
                    "return [k for k in range(24) if np.ravel_multi_index(np.unravel_index(k, shape), shape) in "
                    "numbers]"
                )
            },
        ),
        "differs_in_i": Mistake(
            "in these states input i differs from that in s, whatever the others are. It is the others that "
            "count: they should be as in s.",
            {
                "return numbers": "return [k for k in range(np.prod(shape)) if np.unravel_index(k, shape)[i] != "
                "np.unravel_index(s, shape)[i]]"
            },
        ),
        "any_for_all": Mistake(
            "one shared input is not enough: all but input i should be as in s. So all(…), where you have any(…).",
            {
                "return numbers": "return [k for k in range(np.prod(shape)) if any(np.unravel_index(k, shape)[j] == "
                "np.unravel_index(s, shape)[j] for j in range(len(shape)) if j != i)]"
            },
        ),
        "three_members": Mistake(
            "the members are as many as the bins of input i, not always s and one on each side.",
            CHANGED["three_members"],
        ),
        "append_after_the_loop": Mistake(
            "append stands after the loop: only the last member is in the list.",
            {"        numbers.append(": "    numbers.append("},
        ),
        "remainder_alone": Mistake(
            "the same remainder is not enough: the inputs before i must be as in s, too.", CHANGED["remainder_alone"]
        ),
        "input_after": Mistake(
            "inputs are counted from 0: input i stands at place i of the bins. Here the one after it is changed.",
            {"shape[i]": "shape[(i + 1) % len(shape)]", "bins[i]": "bins[(i + 1) % len(bins)]"},
        ),
        "adds_to_the_bin": Mistake(
            "bins[i] += k adds to the bin of the pass before. Input i takes the bins 0, 1, 2 …: bins[i] = k.",
            {"bins[i] = k": "bins[i] = (bins[i] + k) % shape[i]"},
        ),
    },
    lenders={"state_number": "your function of lesson 01; np.ravel_multi_index(bins, shape) does the same"},
    hints=(
        "Take the bins of s, let number i be anything it can be, and turn each result back into a number.",
        "for k in range(shape[i]): put k into place i of the bins, and append the number of these bins to a list.",
        "bins = list(np.unravel_index(s, shape)); in the loop bins[i] = k and numbers.append(int(np.ravel_multi_index("
        "bins, shape))); at the end return numbers.",
    ),
    gained="To a table 21 and 9 are just numbers. Now you can tell which states have something to say to each other.",
    witnesses=WITNESSES,
)
