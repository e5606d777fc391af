"""Exercises of lesson 07: QBIASSR. That on the bias itself stands in `bias_check`."""

from __future__ import annotations

import numpy as np

from rlrobot_edu.course.grading.exercise import Exercise
from rlrobot_edu.course.grading.mistake import Mistake
from rlrobot_edu.course.grading.question import Question
from rlrobot_edu.course.grading.replay import Case
from rlrobot_edu.course.lesson_07 import solutions
from rlrobot_edu.course.lesson_07.bias_check import bias

__all__ = ["bias", "by_hand", "own_share", "siblings"]


def another_set(rng: np.random.Generator, case: Case) -> Case:
    """A case with as many inputs, of which each has more bins."""
    shape = tuple(n + int(rng.integers(1, 3)) for n in case["shape"])
    return {"shape": shape, "s": int(rng.integers(np.prod(shape))), "i": case["i"]}


siblings = Exercise(
    task="return the numbers of the states that share all inputs with s but input i, from small to large",
    right=solutions.siblings,
    returns="siblings",
    tape=[
        {"shape": shape, "s": s, "i": i}
        for shape, s, i in (
            ((2, 2, 3, 2), 21, 2), ((2, 2, 3, 2), 21, 0), ((2, 2, 3, 2), 4, 3), ((2, 2, 3, 2), 13, 1),
            ((2, 5, 3), 17, 1), ((4, 3), 7, 0), ((4, 3), 7, 1), ((5,), 2, 0),
        )
    ],
    another=another_set,
    mistakes=[
        Mistake("s itself belongs to the set, too: it shares all other inputs with itself.",
                {"return numbers": "return [k for k in numbers if k != s]"}),
        Mistake("this is s alone. Input i may take any of its bins; all others stay as they are in s.",
                {"return numbers": "return [s]"}),
        Mistake("you have turned it round: these states share input i and differ in the others. They should share all "
                "others.",
                {"return numbers":
                 "return [k for k in range(np.prod(shape)) if np.unravel_index(k, shape)[i] == numbers.index(s)]"}),
        Mistake("these are the sets of all inputs in one. Only input i may differ.",
                {"return numbers": "return sorted({k for j in range(len(shape)) for k in siblings(shape, s, j)})"}),
        Mistake("here the first input counts fastest. In this course the last one does (lesson 01).",
                {"index(s, shape)": "index(s, shape, order='F')",
                 "index(bins, shape)": "index(bins, shape, order='F')"}),
        Mistake("this counts upward from s. The set begins where input i is in bin 0, which may lie below s.",
                {"return numbers": "return [s + k - numbers[0] for k in numbers]"}),
        Mistake("these are neighbours in number. To change input i by one bin, the number changes by the product of "
                "the bins of all inputs after i.",
                {"return numbers": "return [s - s % shape[i] + k for k in range(shape[i])]"}),
        Mistake("these are the bins of the right states. Turn each back into a number, with your state_number.",
                {"int(np.ravel_multi_index(bins, shape))": "[int(b) for b in bins]"}),
        Mistake("the right states, but not in order: from small to large, please, as a list.",
                {"return numbers": "return [s, *(k for k in numbers if k != s)]"}),
        Mistake("the right states, but a set has no order. Return a sorted list.",
                {"return numbers": "return set(numbers)"}),
        Mistake("the last bin is missing: input i has shape[i] of them, 0 to shape[i] − 1, and range(n) ends there by "
                "itself.", {"range(shape[i])": "range(shape[i] - 1)"}),
        Mistake("bins are counted from 0. The state in which input i is in bin 0 is missing.",
                {"range(shape[i])": "range(1, shape[i])"}),
        Mistake("input 0 is the first one. Here the one before input i is changed.",
                {"shape[i]": "shape[i - 1]", "bins[i]": "bins[i - 1]"}),
        Mistake("input i may take any of its bins, not only the next to its own.",
                {"range(shape[i])": "range(max(0, bins[i] - 1), min(shape[i], bins[i] + 2))"}),
        Mistake("return stands inside the loop: it ends the function with the first state.",
                {"numbers.append(int(np.ravel_multi_index(bins, shape)))":
                 "return [int(np.ravel_multi_index(bins, shape))]"}),
        Mistake("these are all the states there are.", {"return numbers": "return list(range(np.prod(shape)))"}),
        Mistake("the distance of two members is the product of the bins of the inputs *after* i; here that of input i "
                "is in it, too.",
                {"return numbers": "return [numbers[0] + k * int(np.prod(shape[i:])) for k in range(shape[i])]"}),
        Mistake("these are bins, and the same list again and again. Turn the bins into a number each time.",
                {"int(np.ravel_multi_index(bins, shape))": "bins"}),
        Mistake("these are not numbers of states: bins are counted from 0 to shape[i] − 1.",
                {"return numbers": "return [n + numbers[1] - numbers[0] for n in numbers]"}),
        Mistake("this is how many there are. Return the list of them.", {"return numbers": "return len(numbers)"}),
        Mistake("two members are not shape[i] apart: it is the product of the bins of all inputs after i.",
                {"return numbers": "return [numbers[0] + k * shape[i] for k in range(shape[i])]"}),
        Mistake("two members are as far apart as the product of the bins of all inputs *after* i, not before it.",
                {"return numbers": "return [numbers[0] + k * int(np.prod(shape[:i])) for k in range(shape[i])]"}),
        Mistake("this counts downward from s. The set may go on above s.",
                {"return numbers": "return [s - n + numbers[0] for n in numbers[::-1]]"}),
        Mistake("one state is not to be added several times.", {"return numbers": "return numbers + [s]"}),
        Mistake("two members are 1 apart only for the last input: it is the product of the bins of all inputs after "
                "i.", {"return numbers": "return [s - numbers.index(s) + k for k in range(shape[i])]"}),
        Mistake("there are not always 24 states, but as many as the bins of all inputs multiplied: np.prod(shape).",
                {"return numbers":
                 "return [k for k in range(24) if np.ravel_multi_index(np.unravel_index(k, shape), shape) in "
                 "numbers]"}),
        Mistake("in these states input i differs from that in s, whatever the others are. It is the others that "
                "count: they should be as in s.",
                {"return numbers": "return [k for k in range(np.prod(shape)) if np.unravel_index(k, shape)[i] != "
                 "np.unravel_index(s, shape)[i]]"}),
        Mistake("one shared input is not enough: all but input i should be as in s. So all(…), where you have any(…).",
                {"return numbers": "return [k for k in range(np.prod(shape)) if any(np.unravel_index(k, shape)[j] == "
                 "np.unravel_index(s, shape)[j] for j in range(len(shape)) if j != i)]"}),
        Mistake("the members are as many as the bins of input i, not always s and one on each side.",
                {"return numbers": "step = int(np.prod(shape[i + 1 :]))\n    return [s - step, s, s + step]"}),
        Mistake("append stands after the loop: only the last member is in the list.",
                {"        numbers.append(": "    numbers.append("}),
        Mistake("the same remainder is not enough: the inputs before i must be as in s, too.",
                {"return numbers": "step = np.prod(shape[i + 1 :])\n"
                 "    return [k for k in range(np.prod(shape)) if k % step == s % step]"}),
        Mistake("inputs are counted from 0: input i stands at place i of the bins. Here the one after it is changed.",
                {"shape[i]": "shape[(i + 1) % len(shape)]", "bins[i]": "bins[(i + 1) % len(bins)]"}),
        Mistake("bins[i] += k adds to the bin of the pass before. Input i takes the bins 0, 1, 2 …: bins[i] = k.",
                {"bins[i] = k": "bins[i] = (bins[i] + k) % shape[i]"}),
    ],
    lenders={"state_number": "your function of lesson 01; np.ravel_multi_index(bins, shape) does the same"},
    hints=(
        "Take the bins of s, let number i be anything it can be, and turn each result back into a number.",
        "for k in range(shape[i]): put k into place i of the bins, and append the number of these bins to a list.",
        "bins = list(np.unravel_index(s, shape)); in the loop bins[i] = k and numbers.append(int(np.ravel_multi_index("
        "bins, shape))); at the end return numbers.",
    ),
    gained="To a table 21 and 9 are just numbers. Now you can tell which states have something to say to each other.",
)  # fmt: skip

by_hand = Question(
    task="the bias for spin right in state 21, computed by hand",
    right=solutions.by_hand,
    because="The means are 7.5 (X), 3.5 (Y), 6 (theta) and −1.5 (d), and the mean of these four is 15.5 / 4 = 3.875.",
    mistakes=[
        Mistake("this is the sum of the four means. The bias is their mean: divide by the number of inputs.", 15.5),
        Mistake("you left the state itself out of its sets. It is a member of each of the four.", 2.625),
        Mistake("this is one mean over all six states. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 22 / 6),
        Mistake("this is one mean over all nine members. Take a mean for each input first, and then the mean of the "
                "four: theta has three members, the others two.", 37 / 9),
        Mistake("this is Q(s) + bias(s). Asked is the bias alone.", 8.875),
        Mistake("this is the mean over the five other states, all at once. Take a mean for each input first, the "
                "state itself included.", 3.4),
        Mistake("the set of theta has three members, so its mean is 18 / 3 = 6.", 4.625),
        Mistake("each set's values are to be divided by the number of its members: a mean, not a sum.", 9.25),
        Mistake("the set of d has −8 in it, not 8.", (7.5 + 3.5 + 6 + 6.5) / 4),
        Mistake("the set of theta has −1 in it, not 1.", (7.5 + 3.5 + 20 / 3 - 1.5) / 4),
        Mistake("this is Q(s) itself. What do the sets say?", 5),
        Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 5),
        Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 6),
        Mistake("there are four inputs, so four means: divide their sum by four.", 15.5 / 3),
        Mistake("take a mean for each input first: of two members, or of three.", 22 / 4),
        Mistake("the state itself is a member of every set, and the set of theta gives a mean, not a sum.", 17 / 4),
        Mistake("the state itself belongs to its sets; and take a mean for each input first.", 17 / 6),
        Mistake("the set of theta is missing: there are four inputs.", 9.5 / 3),
        Mistake("of the set of theta the mean is asked, 18 / 3, not the median.", 14.5 / 4),
        Mistake("the set of d is missing: there are four inputs.", 17 / 3),
        Mistake("two values are negative: −1 in the set of theta, −8 in that of d.", (7.5 + 3.5 + 20 / 3 + 6.5) / 4),
    ],
    hints=(
        "Four means, one for each input, then the mean of these four. The state itself is in every set.",
        "X: (5 + 10) / 2. theta has three members: (5 + 14 − 1) / 3.",
        "((5 + 10) / 2 + (5 + 2) / 2 + (5 + 14 − 1) / 3 + (5 − 8) / 2) / 4",
    ),
    gained="Four opinions have become one. Next you let the computer ask them.",
)  # fmt: skip

own_share = Exercise(
    task="return the share with which Q(s) itself enters bias(s)",
    right=solutions.own_share,
    returns="share",
    tape=[{"shape": shape} for shape in ((2, 2, 3, 2), (4, 4, 4, 4, 4), (2, 2), (3, 8), (7,), (5, 1))],
    another=lambda rng, case: {"shape": tuple((np.array(case["shape"]) + rng.integers(1, 4)).tolist())},
    mistakes=[
        Mistake("this adds the shares up. The bias is the mean of the means: divide by the number of inputs.",
                {"np.mean": "sum"}),
        Mistake("this is the share of one state among all states. Q(s) enters through its sets, which are much "
                "smaller.", {"np.mean([1 / n for n in shape])": "1 / np.prod(shape)"}),
        Mistake("this treats all members as one large set. In the set of input i the share is 1 / shape[i]; take the "
                "mean of these.", {"np.mean([1 / n for n in shape])": "len(shape) / sum(shape)"}),
        Mistake("this is one in all the different states that have a say. In the set of input i the share is 1 / "
                "shape[i]; take the mean of these.",
                {"np.mean([1 / n for n in shape])": "1 / (1 + sum(n - 1 for n in shape))"}),
        Mistake("s is in every set, but it is not the only member: in the set of input i it is one of shape[i].",
                {"np.mean([1 / n for n in shape])": "1 / len(shape)"}),
        Mistake("s is in every set, but it is not the only member: its share is below 1.",
                {"np.mean([1 / n for n in shape])": "1.0"}),
        Mistake("a product would fit a set inside a set. Here there is a set for each input: take a mean.",
                {"np.mean([1 / n for n in shape])": "np.prod([1 / n for n in shape]) / len(shape)"}),
        Mistake("this is the share of the others. What is left, 1 minus this, is the share of Q(s).",
                {"np.mean": "1 - np.mean"}),
        Mistake("// cuts off what comes after the point; divide with /.", {"1 / n": "1 // n"}),
        Mistake("this is 1 + the share: how much Q(s) + bias(s) grows. Asked is bias(s) alone.",
                {"return np.mean": "return 1 + np.mean"}),
        Mistake("this is the mean number of bins. The share in a set of n members is 1 / n.", {"1 / n": "n"}),
        Mistake("only the first input counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / shape[0]]"}),
        Mistake("only the last input counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / shape[-1]]"}),
        Mistake("only the largest set counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / max(shape)]"}),
        Mistake("only the smallest set counts here. Take the mean over all of them.",
                {"[1 / n for n in shape]": "[1 / min(shape)]"}),
        Mistake("there need not be four inputs: divide by len(shape).",
                {"np.mean([1 / n for n in shape])": "sum(1 / n for n in shape) / 4"}),
        Mistake("these are the shares in each set. Asked is one number, their mean.",
                {"np.mean([1 / n for n in shape])": "[1 / n for n in shape]"}),
        Mistake("return stands inside the loop: only the first input is counted.",
                {"np.mean([1 / n for n in shape])": "1 / shape[0] / len(shape)"}),
        Mistake("this is the number of sets among that of all states. In the set of input i the share is 1 / "
                "shape[i]; take the mean of these.",
                {"np.mean([1 / n for n in shape])": "len(shape) / np.prod(shape)"}),
        Mistake("this is the number of inputs among all the different states that have a say. In the set of input i "
                "the share is 1 / shape[i]; take the mean of these.",
                {"np.mean([1 / n for n in shape])": "len(shape) / (1 + sum(n - 1 for n in shape))"}),
        Mistake("the plain mean is meant, not the median.", {"np.mean": "np.median"}),
        Mistake("the share in a set of n members is 1 / n: s is one of them, and n counts it already.",
                {"1 / n": "1 / (n + 1)"}),
        Mistake("only the last share is left, and it is divided by the number of inputs. Add the shares up: share += "
                "1 / n.", {"np.mean([1 / n for n in shape])": "1 / shape[-1] / len(shape)"}),
        Mistake("for n in shape gives the numbers of bins themselves, not places: 1 / n, not 1 / shape[n].",
                {"1 / n": "1 / shape[n]"}),
        Mistake("this is the number of members of all sets among that of all states. In the set of input i the share "
                "is 1 / shape[i]; take the mean of these.",
                {"np.mean([1 / n for n in shape])": "sum(shape) / np.prod(shape)"}),
        Mistake("here the division stands in the loop and is done again and again. First the sum, then divide once.",
                {"return np.mean([1 / n for n in shape])":
                 "share = 0\n    for n in shape:\n        share = (share + 1 / n) / len(shape)\n    return share"}),
        Mistake("this is one in all the members of all sets. In the set of input i the share is 1 / shape[i]; take the "
                "mean of these.", {"np.mean([1 / n for n in shape])": "1 / sum(shape)"}),
    ],
    hints=(
        "In each set s is one of several members. What is its share there? The bias is the mean of the sets.",
        "In the set of input i the share is 1 / shape[i].",
        "The mean of 1 / n over all n in shape.",
    ),
    gained="One short line, and it says how much of what looks like advice is only an echo.",
)  # fmt: skip
