"""Exercises of lesson 01: bins, states and rewards."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.lesson_01 import solutions
from rlrobot_edu.course.lesson_01.pay import reward as reward

LASER = [0.27, 0.53, 0.80]  # cut points [m]
ANGLE = [-45, 0, 45, 90]  # cut points [deg]

bin_of = Exercise(
    task="return the number of the bin that the reading x falls into",
    right=solutions.bin_of,
    returns="bin",
    tape=[{"x": x, "cuts": LASER} for x in (0.53, 0.70, 0.10, 0.30, 2.00, 0.27, 0.80)]
    + [{"x": x, "cuts": [0.20]} for x in (0.20, 0.21)]
    + [{"x": x, "cuts": ANGLE} for x in (-30, -90, 90, 180, 0, 20)]
    + [{"x": x, "cuts": [1.5, 1.6, 4.0, 4.5, 9.0]} for x in (4.2, 1.55, 5, 9.1)],
    mistakes=[
        Mistake("a reading exactly on a cut point belongs to the bin below it: x ≤ c₁ is bin 0.",
                {"x > cut": "x >= cut"}),
        Mistake("bins are counted from 0, and yours from 1.", {"number = 0": "number = 1"}),
        Mistake("these are the cut points above x. The number of the bin is how many lie below it.",
                {"x > cut": "x <= cut"}),
        Mistake("these are the cut points above x. The number of the bin is how many lie below it.",
                {"x > cut": "x < cut"}),
        Mistake("this counts three cut points at most. The list may be longer: go through all of it.",
                {"in cuts": "in cuts[:3]"}),
        Mistake("x is compared with the numbers 0, 1, 2 …, not with the cut points. Write for cut in cuts, or cuts[i].",
                {"in cuts": "in range(len(cuts))"}),
        Mistake("this says yes or no for each cut point. How often is it yes?",
                {"return number": "return [x > cut for cut in cuts]"}),
        Mistake("beyond the last cut point yours gives 0 (argmax does, where nothing is True). It is bin k there.",
                {"return number": "return number % len(cuts)"}),
        Mistake("a later cut point above x sets the number back to 0. Leave the else out: begin with 0, and only ever "
                "raise it.", {"number += 1": "number += 1\n        else:\n            number = 0"}),
        Mistake("the loop goes on after the bin is found, and a later cut point wins. Return at once.",
                {"number = 0": "number = len(cuts)", "if x > cut": "if x <= cut",
                 "number += 1": "number = cuts.index(cut)"}),
        Mistake("number = 0 stands inside the loop, so the counting begins anew with each cut point.",
                {"if x > cut": "number = 0\n        if x > cut"}),
        Mistake("this is the index of the last cut point below x; the bin's number is one more.",
                {"number = 0": "number = -1"}),
        Mistake("the first cut point does not count here. Is it left out, or is it its index that you return? The "
                "bin's number is how many cut points lie below x.", {"in cuts": "in cuts[1:]"}),
        Mistake("the last bin is missing: k cut points make k + 1 bins, and beyond the last cut is bin k. Do you go "
                "through all cut points?",
                {"return number": "return min(number, len(cuts) - 1)"}),
        Mistake("0 or 1: this tells only whether x lies above the first cut point. Compare x with every one of them, "
                "add 1 each time (number += 1), and return when the loop is over.", {"in cuts": "in cuts[:1]"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"if x > cut": "if x <= cut", "number += 1": "return cut", "return number": "return cut"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"number += 1": "number = cut"}),
        Mistake("this is a cut point, and what is asked is the number of the bin.",
                {"return number": "return cuts[number]"}),
        Mistake("this adds up the cut points below x. Count them: number += 1.", {"number += 1": "number += cut"}),
        Mistake("the bins are not equally wide, so dividing does not tell which it is. Compare with the cut points.",
                {"return number": "return int(x // cuts[0])"}),
        Mistake("this is the cut point nearest to x. Ask how many lie below it.",
                {"return number": "return min(range(len(cuts)), key=lambda i: abs(cuts[i] - x))"}),
        Mistake("a reading may be negative, as an angle is. Compare x itself, not abs(x).",
                {"x > cut": "abs(x) > cut"}),
        Mistake("every reading is cut at 0.27, 0.53 and 0.80 here. Use the list cuts that the function is given.",
                {"in cuts": "in [0.27, 0.53, 0.80]"}),
        Mistake("comparing rounded readings moves them into other bins. Compare x as it is.",
                {"x > cut": "round(x, 1) > cut"}),
        Mistake("comparing rounded readings moves them into other bins. Compare x as it is.",
                {"x > cut": "int(x) > cut"}),
        Mistake("comparing rounded readings moves them into other bins. Compare x as it is.",
                {"x > cut": "round(x, 1) > round(cut, 1)"}),
        Mistake("the last bin's number is len(cuts), 1 more than the index of the last cut point.",
                {"return number": "return number if number < len(cuts) else len(cuts) + 1"}),
    ],
    hints=(
        "For x = 0.30 and the cuts 0.27, 0.53, 0.80 only one cut point lies below x. So the bin is 1.",
        "Begin with number = 0, go through the cut points with a loop, and add 1 for each that is smaller than x.",
        "for cut in cuts: if x > cut: number += 1. After the loop: return number.",
    ),
    gained="You have given a robot its eyes: from now on, every reading in this course goes through these few lines.",
)  # fmt: skip

ROBOT = [2, 2, 3, 2]  # bins of the inputs of worked_example


def another_state(rng: np.random.Generator, case: Case) -> Case:
    """A state of a robot with as many inputs, of which each has more bins."""
    shape = [n + int(rng.integers(1, 3)) for n in case["shape"]]
    return {"bins": rng.integers(shape).tolist(), "shape": shape}


state_number = Exercise(
    task="return the number of the state that has these bins",
    right=solutions.state_number,
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
    mistakes=[
        Mistake("here the first input varies fastest. It should vary slowest: begin with the first bin.",
                {"zip(bins, shape": "zip(bins[::-1], shape[::-1]"}),
        Mistake("each bin is multiplied by the size of its own input, too. Multiply first, then add the bin.",
                {"s * n + b": "(s + b) * n"}),
        Mistake("this is the sum of the bins, which different states share. Each input needs its own weight.",
                {"s * n + b": "s + b"}),
        Mistake("all inputs were taken to have as many bins as the first one. Each has its own number in shape.",
                {"s * n": "s * shape[0]"}),
        Mistake("all inputs were taken to have two bins. Each has its own number in shape.", {"s * n": "s * 2"}),
        Mistake("all inputs were taken to have as many bins as the last one. Each has its own number in shape.",
                {"s * n": "s * shape[-1]"}),
        Mistake("all inputs were taken to have as many bins as the largest. Each has its own number in shape.",
                {"s * n": "s * max(shape)"}),
        Mistake("what you have is multiplied by how many inputs there are. Multiply it by how many bins the input has.",
                {"s * n": "s * len(shape)"}),
        Mistake("these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
                "combinations.", {"s * n": "s * 10"}),
        Mistake("these are the bins read as a decimal number. A place is worth as much as the inputs after it have "
                "combinations.", {"return s": "return int(''.join(map(str, bins)))"}),
        Mistake("states are counted from 0, and yours from 1.", {"return s": "return s + 1"}),
        Mistake("size and bin belong to different inputs here: what is multiplied by n₂ gets b₂ added, not b₁.",
                {"return s": "s = bins[0]\n    for i in range(1, len(bins)): s = s * shape[i] + bins[i - 1]\n"
                              "    return s"}),
        Mistake("each bin is multiplied by the size of its own input alone. What has been added up so far is to be "
                "multiplied.", {"s * n + b": "s + b * n"}),
        Mistake("the last input is left out.", {"zip(bins, shape": "zip(bins[:-1], shape[:-1]"}),
        Mistake("the first input is left out. Begin with s = 0 and go through all the inputs.",
                {"zip(bins, shape": "zip(bins[1:], shape[1:]"}),
        Mistake("the first bin is counted twice: it is in s already when the loop begins. Begin with s = 0.",
                {"s = 0": "s = bins[0]"}),
        Mistake("counting begins at 0: with s = 1 at the start, every state has a number too large.",
                {"s = 0": "s = 1"}),
        Mistake("a bin of 0 adds nothing, but what has been added up so far is still to be multiplied.",
                {"s * n + b": "s * n + b if b else s"}),
        Mistake("you multiply by the size of the input before this one. Take the input's own: b₂ goes with n₂.",
                {"s * n + b": "s * m + b; m = n", "s = 0": "s, m = 0, 1"}),
        Mistake("the bins come in their order and the sizes in reverse. Go through both from first to last.",
                {"zip(bins, shape": "zip(bins, shape[::-1]"}),
        Mistake("the bins come in reverse. Go through bins and shape together, from first to last.",
                {"zip(bins, shape": "zip(bins[::-1], shape"}),
        Mistake("bin and size have changed places: multiply by the number of bins n, and add the bin b.",
                {"s * n + b": "s * b + n"}),
        Mistake("the return is inside the loop, so the function ends after the first input. Move it to the left.",
                {"s = s * n + b": "return s * n + b"}),
        Mistake("what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
                {"s * n + b": "b"}),
        Mistake("what has been added up so far is lost in each round. It is s · n + b, with s from the round before.",
                {"s * n + b": "b * n"}),
        Mistake("what has been added up is to be multiplied by n, and the bin is to be added. Here s is "
                "added once more: is there a += ? Write s = .", {"s = s * n + b": "s += s * n + b"}),
        Mistake("the last bin is still to be added, when all the others have been multiplied.",
                {"zip(bins, shape": "zip(bins[:-1], shape[1:]", "s * n + b": "(s + b) * n"}),
        Mistake("each bin is multiplied by the size of the next input alone. It counts as much as all the inputs after "
                "it have combinations.",
                {"zip(bins, shape": "zip(bins, [*shape[1:], 1]", "s * n + b": "s + b * n"}),
        Mistake("multiply by the number of bins. You took one less, the largest bin.", {"s * n": "s * (n - 1)"}),
        Mistake("nothing is to be added but the bin: bins and states are counted from 0.",
                {"s * n + b": "s * n + b + 1"}),
        Mistake("you add the number of bins to what you have. Multiply by it: s * n + b.", {"s * n + b": "s + n + b"}),
        Mistake("this multiplies all bins together, and a single 0 makes it 0. It is s · n + b for each input.",
                {"return s": "import math; return math.prod(bins)"}),
        Mistake("this is how many states there are, for any bins. The bins say which of them it is.",
                {"return s": "import math; return math.prod(shape)"}),
        Mistake("the weight of a bin is the product of the sizes of all inputs after it. A power of one size would do "
                "only if all inputs had as many bins.",
                {"return s": "return sum(b * n ** (len(bins) - 1 - i) for i, (b, n) in enumerate(zip(bins, shape)))"}),
        Mistake("for i in bins runs over the bins themselves, and as numbers of inputs they make no sense. "
                "range(len(bins)) gives these numbers; zip(bins, shape) gives bin and size together.",
                {"s = s * n + b": "pass", "return s": "for i in bins: s = s * shape[i] + bins[i]\n    return s"}),
        Mistake("here the size of every input before it is the weight of a bin. Its weight is the product of the sizes "
                "after it.", {"return s": "w = 1; t = 0\n    for b, n in zip(bins, shape): w *= n; t += b * w\n"
                              "    return t"}),
    ],
    hints=(
        "A mileage counter: when the next wheel comes in, all that you have so far counts n times as much.",
        "Begin with s = 0. For each input, with its bin b and its number of bins n, make s · n + b of s.",
        "for b, n in zip(bins, shape): s = s * n + b. After the loop: return s.",
    ),
    gained="Any robot of this course, whatever it senses, is now one number to you. Lesson 07 will use this function "
    "to find states that are alike.",
)  # fmt: skip
