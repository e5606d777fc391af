"""What share of its bias a state has said itself."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import WHOLE_DIVISION


def own_share(shape):
    return np.mean([1 / n for n in shape])


CHANGED, WITNESSES = read_answers(__file__, {})

exercise = Exercise(
    task="return the share with which Q(s) itself enters bias(s)",
    right=own_share,
    returns="share",
    tape=[{"shape": shape} for shape in ((2, 2, 3, 2), (4, 4, 4, 4, 4), (2, 2), (3, 8), (7,), (5, 1))],
    another=lambda rng, case: {"shape": tuple((np.array(case["shape"]) + rng.integers(1, 4)).tolist())},
    mistakes={
        "sum_of_shares": Mistake(
            "this adds the shares up. The bias is the mean of the means: divide by the number of inputs.",
            {"np.mean": "sum"},
        ),
        "share_of_all_states": Mistake(
            "this is the share of one state among all states. Q(s) enters through its sets, which are much smaller.",
            {"np.mean([1 / n for n in shape])": "1 / np.prod(shape)"},
        ),
        "one_large_set": Mistake(
            "this treats all members as one large set. In the set of input i the share is 1 / shape[i]; take the "
            "mean of these.",
            {"np.mean([1 / n for n in shape])": "len(shape) / sum(shape)"},
        ),
        "one_of_the_union": Mistake(
            "this is one in all the different states that have a say. In the set of input i the share is 1 / "
            "shape[i]; take the mean of these.",
            {"np.mean([1 / n for n in shape])": "1 / (1 + sum(n - 1 for n in shape))"},
        ),
        "one_of_the_inputs": Mistake(
            "s is in every set, but it is not the only member: in the set of input i it is one of shape[i].",
            {"np.mean([1 / n for n in shape])": "1 / len(shape)"},
        ),
        "whole": Mistake(
            "s is in every set, but it is not the only member: its share is below 1.",
            {"np.mean([1 / n for n in shape])": "1.0"},
        ),
        "product": Mistake(
            "a product would fit a set inside a set. Here there is a set for each input: take a mean.",
            {"np.mean([1 / n for n in shape])": "np.prod([1 / n for n in shape]) / len(shape)"},
        ),
        "share_of_the_others": Mistake(
            "this is the share of the others. What is left, 1 minus this, is the share of Q(s).",
            {"np.mean": "1 - np.mean"},
        ),
        "whole_division": Mistake(WHOLE_DIVISION, {"1 / n": "1 // n"}),
        "one_plus_the_share": Mistake(
            "this is 1 + the share: how much Q(s) + bias(s) grows. Asked is bias(s) alone.",
            {"return np.mean": "return 1 + np.mean"},
        ),
        "share_of_the_sum": Mistake(
            "this is the echo's part of Q(s) + bias(s). Asked is by how much bias(s) alone grows "
            "where Q(s) grows by 1.",
            {
                "return np.mean([1 / n for n in shape])": (
                    "share = np.mean([1 / n for n in shape]); return share / (1 + share)"
                )
            },
        ),
        "mean_number_of_bins": Mistake(
            "this is the mean number of bins. The share in a set of n members is 1 / n.", {"1 / n": "n"}
        ),
        "first_alone": Mistake(
            "only the first input counts here. Take the mean over all of them.",
            {"[1 / n for n in shape]": "[1 / shape[0]]"},
        ),
        "last_alone": Mistake(
            "only the last input counts here. Take the mean over all of them.",
            {"[1 / n for n in shape]": "[1 / shape[-1]]"},
        ),
        "largest_set": Mistake(
            "only the largest set counts here. Take the mean over all of them.",
            {"[1 / n for n in shape]": "[1 / max(shape)]"},
        ),
        "smallest_set": Mistake(
            "only the smallest set counts here. Take the mean over all of them.",
            {"[1 / n for n in shape]": "[1 / min(shape)]"},
        ),
        "four_inputs": Mistake(
            "there need not be four inputs: divide by len(shape).",
            {"np.mean([1 / n for n in shape])": "sum(1 / n for n in shape) / 4"},
        ),
        "list_of_shares": Mistake(
            "these are the shares in each set. Asked is one number, their mean.",
            {"np.mean([1 / n for n in shape])": "[1 / n for n in shape]"},
        ),
        "return_in_the_loop": Mistake(
            "only the first input is counted. Does return stand inside a loop?",
            {"np.mean([1 / n for n in shape])": "1 / shape[0] / len(shape)"},
        ),
        "sets_over_states": Mistake(
            "this is the number of sets among that of all states. In the set of input i the share is 1 / "
            "shape[i]; take the mean of these.",
            {"np.mean([1 / n for n in shape])": "len(shape) / np.prod(shape)"},
        ),
        "inputs_over_the_union": Mistake(
            "this is the number of inputs among all the different states that have a say. In the set of input i "
            "the share is 1 / shape[i]; take the mean of these.",
            {"np.mean([1 / n for n in shape])": "len(shape) / (1 + sum(n - 1 for n in shape))"},
        ),
        "median": Mistake("the plain mean is meant, not the median.", {"np.mean": "np.median"}),
        "counts_s_twice": Mistake(
            "the share in a set of n members is 1 / n: s is one of them, and n counts it already.",
            {"1 / n": "1 / (n + 1)"},
        ),
        "last_share_divided": Mistake(
            "only the last share is left, and it is divided by the number of inputs. Add the shares up: share += "
            "1 / n.",
            {"np.mean([1 / n for n in shape])": "1 / shape[-1] / len(shape)"},
        ),
        "bins_as_places": Mistake(
            "for n in shape gives the numbers of bins themselves, not places: 1 / n, not 1 / shape[n].",
            {"1 / n": "1 / shape[n]"},
        ),
        "members_over_states": Mistake(
            "this is the number of members of all sets among that of all states. In the set of input i the share "
            "is 1 / shape[i]; take the mean of these.",
            {"np.mean([1 / n for n in shape])": "sum(shape) / np.prod(shape)"},
        ),
        "divides_in_the_loop": Mistake(
            "here the division stands in the loop and is done again and again. First the sum, then divide once.",
            CHANGED["divides_in_the_loop"],
        ),
        "one_of_all_members": Mistake(
            "this is one in all the members of all sets. In the set of input i the share is 1 / shape[i]; take the "
            "mean of these.",
            {"np.mean([1 / n for n in shape])": "1 / sum(shape)"},
        ),
    },
    hints=(
        "In each set s is one of several members. What is its share there? The bias is the mean of the sets.",
        "In the set of input i the share is 1 / shape[i].",
        "The mean of 1 / n over all n in shape.",
    ),
    gained="One short line, and it says how much of what looks like advice is only an echo.",
    witnesses=WITNESSES,
)
