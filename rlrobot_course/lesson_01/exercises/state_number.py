"""The number of a state from the bins of its inputs."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def state_number(bins, shape):
    s = 0
    for b, n in zip(bins, shape, strict=True):
        s = s * n + b
    return s


ROBOT = [2, 2, 3, 2]  # bins of the inputs of worked_example


def another_state(rng: np.random.Generator, case: Case) -> Case:
    """A state of a robot with as many inputs, of which each has more bins."""
    shape = [n + int(rng.integers(1, 3)) for n in case["shape"]]
    return {"bins": rng.integers(shape).tolist(), "shape": shape}


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the number of the state that has these bins",
    right=state_number,
    returns="state",
    tape=[{"bins": bins, "shape": ROBOT} for bins in ([1, 0, 1, 1], [0, 1, 2, 0], [0, 0, 0, 1], [1, 1, 2, 1])]
    + [
        {"bins": [2, 1], "shape": [3, 4]},
        {"bins": [1, 3, 0, 2], "shape": [2, 5, 3, 4]},
        {"bins": [4], "shape": [6]},
        {"bins": [0, 1, 3, 3, 1], "shape": [4, 4, 4, 4, 4]},
        {"bins": [2, 6, 11], "shape": [3, 7, 12]},
        {"bins": [0, 0, 0], "shape": [3, 2, 5]},
    ],
    another=another_state,
    mistakes={
        "first_fastest": Mistake(
            "here the first input varies fastest. It should vary slowest: begin with the first bin.",
            {"zip(bins, shape": "zip(bins[::-1], shape[::-1]"},
        ),
        "adds_before_multiplying": Mistake(
            "each bin is multiplied by the size of its own input, too. Multiply first, then add the bin.",
            {"s * n + b": "(s + b) * n"},
        ),
        "sum_of_bins": Mistake(
            "this is the sum of the bins, which different states share. Each input needs its own weight.",
            {"s * n + b": "s + b"},
        ),
        "size_of_the_first": Mistake(
            "all inputs were taken to have as many bins as the first one. Each has its own number in shape.",
            {"s * n": "s * shape[0]"},
        ),
        "two_bins_each": Mistake(
            "all inputs were taken to have two bins. Each has its own number in shape.", {"s * n": "s * 2"}
        ),
        "size_of_the_last": Mistake(
            "all inputs were taken to have as many bins as the last one. Each has its own number in shape.",
            {"s * n": "s * shape[-1]"},
        ),
        "size_of_the_largest": Mistake(
            "all inputs were taken to have as many bins as the largest. Each has its own number in shape.",
            {"s * n": "s * max(shape)"},
        ),
        "number_of_inputs": Mistake(
            "what you have is multiplied by how many inputs there are. Multiply it by how many bins the input has.",
            {"s * n": "s * len(shape)"},
        ),
        "tens": Mistake(
            "these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
            "combinations.",
            {"s * n": "s * 10"},
        ),
        "as_text": Mistake(
            "these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
            "combinations.",
            {"return s": "return int(''.join(map(str, bins)))"},
        ),
        "counts_from_1": Mistake("states are counted from 0, and yours from 1.", {"return s": "return s + 1"}),
        "bin_of_the_one_before": Mistake(
            "size and bin belong to different inputs here: what is multiplied by n₂ gets b₂ added, not b₁.",
            CHANGED["bin_of_the_one_before"],
        ),
        "own_size_alone": Mistake(
            "each bin is multiplied by the size of its own input alone. What has been added up so far is to be "
            "multiplied.",
            {"s * n + b": "s + b * n"},
        ),
        "last_left_out": Mistake("the last input is left out.", {"zip(bins, shape": "zip(bins[:-1], shape[:-1]"}),
        "first_left_out": Mistake(
            "the first input is left out. Begin with s = 0 and go through all the inputs.",
            {"zip(bins, shape": "zip(bins[1:], shape[1:]"},
        ),
        "first_twice": Mistake(
            "the first bin is counted twice: it is in s already when the loop begins. Begin with s = 0.",
            {"s = 0": "s = bins[0]"},
        ),
        "begins_with_1": Mistake(
            "counting begins at 0: with s = 1 at the start, every state has a number too large.", {"s = 0": "s = 1"}
        ),
        "skips_0": Mistake(
            "a bin of 0 adds nothing, but what has been added up so far is still to be multiplied.",
            {"s * n + b": "s * n + b if b else s"},
        ),
        "size_of_the_one_before": Mistake(
            "you multiply by the size of the input before this one. Take the input's own: b₂ goes with n₂.",
            {"s * n + b": "s * m + b; m = n", "s = 0": "s, m = 0, 1"},
        ),
        "sizes_reversed": Mistake(
            "the bins come in their order and the sizes in reverse. Go through both from first to last.",
            {"zip(bins, shape": "zip(bins, shape[::-1]"},
        ),
        "bins_reversed": Mistake(
            "the bins come in reverse. Go through bins and shape together, from first to last.",
            {"zip(bins, shape": "zip(bins[::-1], shape"},
        ),
        "bin_and_size_swapped": Mistake(
            "bin and size have changed places: multiply by the number of bins n, and add the bin b.",
            {"s * n + b": "s * b + n"},
        ),
        "return_in_the_loop": Mistake(
            "only the first input counts. Is return inside the loop? Then move it to the left.",
            {"s = s * n + b": "return s * n + b"},
        ),
        "forgets_s": Mistake(
            "what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
            {"s * n + b": "b"},
        ),
        "forgets_s_and_multiplies": Mistake(
            "what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
            {"s * n + b": "b * n"},
        ),
        "adds_s_again": Mistake(
            "what has been added up is to be multiplied by n, and the bin is to be added. Here s is "
            "added once more: is there a += ? Write s = .",
            {"s = s * n + b": "s += s * n + b"},
        ),
        "last_not_added": Mistake(
            "the last bin is still to be added, when all the others have been multiplied.",
            {"zip(bins, shape": "zip(bins[:-1], shape[1:]", "s * n + b": "(s + b) * n"},
        ),
        "size_of_the_next": Mistake(
            "each bin is multiplied by the size of the next input alone. It counts as much as all the inputs after "
            "it have combinations.",
            {"zip(bins, shape": "zip(bins, [*shape[1:], 1]", "s * n + b": "s + b * n"},
        ),
        "one_bin_less": Mistake(
            "multiply by the number of bins. You took one less, the largest bin.", {"s * n": "s * (n - 1)"}
        ),
        "one_more": Mistake(
            "nothing is to be added but the bin: bins and states are counted from 0.", {"s * n + b": "s * n + b + 1"}
        ),
        "adds_sizes": Mistake(
            "you add the number of bins to what you have. Multiply by it: s * n + b.", {"s * n + b": "s + n + b"}
        ),
        "product_of_bins": Mistake(
            "this multiplies all bins together, and a single 0 makes it 0. It is s · n + b for each input.",
            {"return s": "import math; return math.prod(bins)"},
        ),
        "number_of_states": Mistake(
            "this is how many states there are, for any bins. The bins say which of them it is.",
            {"return s": "import math; return math.prod(shape)"},
        ),
        "powers_of_one_size": Mistake(
            "the weight of a bin is the product of the sizes of all inputs after it. A power of one size would do "
            "only if all inputs had as many bins.",
            {"return s": "return sum(b * n ** (len(bins) - 1 - i) for i, (b, n) in enumerate(zip(bins, shape)))"},
        ),
        "bins_as_inputs": Mistake(
            "for i in bins runs over the bins themselves, and as numbers of inputs they make no sense. "
            "range(len(bins)) gives these numbers; zip(bins, shape) gives bin and size together.",
            CHANGED["bins_as_inputs"],
        ),
        "sizes_before": Mistake(
            "here the size of every input before it is the weight of a bin. Its weight is the product of the sizes "
            "after it.",
            CHANGED["sizes_before"],
        ),
    },
    hints=(
        "A mileage counter: when the next wheel comes in, all that you have so far counts n times as much.",
        "Begin with s = 0. For each input, with its bin b and its number of bins n, make s · n + b of s.",
        "for b, n in zip(bins, shape): s = s * n + b. After the loop: return s.",
    ),
    gained="Any robot of this course, whatever it senses, is now one number to you. Lesson 07 will use this function "
    "to find states that are alike.",
    witnesses=WITNESSES,
)
