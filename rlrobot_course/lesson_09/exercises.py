"""Right answers and tapes of lesson 09; the pages of this folder have the tasks, hints and mistakes."""

from itertools import chain, combinations

import numpy as np

from rlrobot_course.exercises.parts import (
    Case,
    Exercise,
    Mistake,
    Question,
    with_pages,
)


def redundancy(states):
    return len(states) / len(set(states))


def new_temperature(temperature, states, rewards, s, default):
    visited_before = states.count(s) > 1
    low = sum(rewards) / len(rewards) < 0
    if visited_before and low and redundancy(states) > 2:
        return min(50, temperature + 0.25 * redundancy(states))
    return default


IDLE = [-0.02] * 8
LOOP = [4, 6, 4, 6, 4, 6, 4, 6]
HITS = [-0.02, -2.0, -0.02, -2.0, -0.02, -0.02, -0.02, -0.02]
# (temperature, states, rewards, default); s is the last of the states
SITUATIONS = (
    (
        3.0,
        LOOP,
        HITS,
        0.5,
    ),  # a loop; from here on all classic mistakes differ
    (1.0, [0, 1, 2, 3, 4, 5, 6, 7], [10.0] * 8, 1.0),  # on its way
    (1.0, LOOP, IDLE, 1.0),
    (
        2.0,
        [4, 6, 9, 4, 6, 9, 4],
        IDLE[:7],
        1.0,
    ),  # three states, and a redundancy of little more than 2
    (5.0, [0, 1, 2, 3, 4, 5, 6, 0], IDLE, 1.0),  # once round a large circle
    (5.0, [6, 4, 6, 4, 6, 1, 2, 1], IDLE, 1.0),  # redundancy of exactly 2
    (
        2.0,
        [4, 4, 4, 6, 6, 6, 9, 9],
        IDLE,
        0.5,
    ),  # s twice in it, and a redundancy that is no whole number
    (
        3.0,
        LOOP,
        [10.0, -2.0, -2.0, 10.0, -2.0, 10.0, -2.0, -2.0],
        1.0,
    ),  # a loop that pays
    (
        3.0,
        LOOP,
        [-2.0] * 7 + [10.0],
        1.0,
    ),  # a loop that does not, though the last one is positive
    (3.0, [3, 3, 3, 5, 5, 5, 3, 9], IDLE, 1.0),  # it has just left
    (
        3.0,
        LOOP,
        [10.0] + [-2.0] * 7,
        1.0,
    ),  # a loop that pays no more
    (
        3.0,
        LOOP,
        [15.0] + [-2.0] * 7,
        1.0,
    ),  # it pays by its first step
    (
        3.0,
        LOOP,
        [-1.0] * 7 + [10.0],
        1.0,
    ),  # it pays by its last one
    (2.0, [1, 0, 1, 0, 1, 0, 1, 0], IDLE, 1.0),  # states of small numbers
    (3.0, LOOP, [-0.001] * 8, 1.0),  # it costs hardly anything
    (
        2.0,
        [*range(30), *range(30), 0],
        [-0.02] * 61,
        1.0,
    ),  # a longer queue, and a redundancy of hardly more than 2
    (7.0, [3, 5, 3, 5, 3, 5, 3, 5], [0.0] * 8, 1.0),  # zero is not negative
    (9.0, [0, 1, 2, 3, 4, 5, 6, 7], IDLE, 0.1),  # another default
    (0.1, [3, 3, 3, 3, 3, 3], IDLE[:6], 0.1),  # a shorter queue
    (0.37, [7, 8] * 10 + [7], [-0.02] * 21, 0.37),  # a longer one
    (49.5, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),  # near the cap
    (50.0, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),
    (1.23456, LOOP, [-0.0004] * 8, 1.0),  # numbers with many digits
    (2.0, LOOP, [0.0004] * 8, 0.54321),
)


def another_situation(rng: np.random.Generator, case: Case) -> Case:
    """The same signs in other states, with other temperatures and rewards. A robot near the cap stays there."""
    heat, size, shift = (
        *rng.uniform(0.5, 2.0, size=2).tolist(),
        int(rng.integers(1, 50)),
    )
    states = [s + shift for s in case["states"]]
    return {
        "temperature": case["temperature"]
        * (heat if case["temperature"] < 40 else 1.0),
        "states": states,
        "rewards": [r * size for r in case["rewards"]],
        "s": states[-1],
        "default": case["default"] * heat,
    }


heats = "ACF"
# what to look at again where a letter is missing, or too many: what to work out, and not for which letter
LOOP_MISSING = (
    "at least one is missing: where the redundancy is above 2 and the mean reward below 0 the temperature rises. Work "
    "out both for each; the redundancy is the number of states in the queue by that of the different ones."
)
MEAN_FORGOTTEN = (
    "in at least one of yours the mean reward is not below 0. To be 0 is not enough."
)
LOOK = {
    "A": LOOP_MISSING,
    "C": LOOP_MISSING,
    "B": "in at least one of yours the redundancy is not above 2: too many of its states are different.",
    "D": MEAN_FORGOTTEN,
    "E": MEAN_FORGOTTEN,
    "F": "and F? The rule sees states and rewards only. It cannot know that waiting is wise.",
}


def _about(letters: str) -> str:
    """The hint for an answer: what to look at again for its first wrong letter."""
    return next(
        told
        for letter, told in LOOK.items()
        if (letter in letters) != (letter in heats)
    )


EVERY = (
    "".join(letters)
    for letters in chain(*(combinations("ABCDEF", n) for n in range(1, 7)))
)

check = with_pages(
    globals(),
    new_temperature=Exercise(
        new_temperature,
        returns="temperature",
        tape=[
            {
                "temperature": temperature,
                "states": states,
                "rewards": rewards,
                "s": states[-1],
                "default": default,
            }
            for temperature, states, rewards, default in SITUATIONS
        ],
        another=another_situation,
    ),
    heats=Question(
        heats,
        mistakes={
            letters: Mistake(_about(letters), letters)
            for letters in EVERY
            if letters != heats
        },
    ),
)
