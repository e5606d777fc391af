"""The probabilities of softmax, for values of any size."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_edu.widgets.kernels import probabilities


def softmax(x, temperature):
    powers = np.exp((x - x.max()) / temperature)
    return powers / powers.sum()


SUM = "these do not sum to 1. Divide them by their sum."

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the probability of each action, e^(x/T) divided by the sum of all e^(x/T)",
    right=softmax,
    library=probabilities,
    returns="p",
    tape=[
        {"x": np.array(x), "temperature": temperature}
        for x, temperature in (
            ([1.0, 2.5, 0.5], 2.0),
            ([1.0, 2.5, 0.5], 0.5),
            ([3.0, 2.0, 0.0, -1.5], 1.0),
            ([0.0, 0.0, 0.0, 0.0], 1.0),
            ([-30.0, 40.0, 10.0], 25.0),
            ([1000.0, 999.0, 0.0], 1.0),
            ([-999.0, -1000.0], 1.0),
            ([60.0, 59.9], 0.05),
            ([3000.0, 0.0, 0.0], 1.0),
            ([2.0, 20000.0, 19999.5, 0.0], 1.0),
            ([7.0, 8.0, 6.5, 9.0, 3.0], 3.0),
            ([-5.0, 3.0], 0.001),
        )
    ],
    mistakes={
        "overflows": Mistake(
            "nan means not a number. e to the power of 1000 is too large for the computer; it becomes infinity, "
            "and infinity divided by infinity is nan. Subtract the largest x from all x first: no probability "
            "changes.",
            {"(x - x.max())": "x"},
        ),
        "less_the_mean": Mistake(
            "subtract the largest x, nothing smaller, not the mean or the like: whatever is far above it is still too "
            "large for the computer.",
            {"x.max()": "x.mean()"},
        ),
        "less_the_smallest": Mistake(
            "subtract the largest x, not the smallest: what is left must not be above 0.", {"x.max()": "x.min()"}
        ),
        "less_the_abs": Mistake(
            "subtract the largest x as it is, without abs: for (−999, −1000) both powers become 0, and 0 / 0 is nan.",
            {"x.max()": "abs(x).max()"},
        ),
        "less_the_sum": Mistake("subtract the largest x, not the sum.", {"x.max()": "x.sum()"}),
        "less_the_first": Mistake(
            "subtract the largest x, not the first: it need not be the largest.", {"x.max()": "x[0]"}
        ),
        "clips": Mistake(
            "to cut large exponents off makes different x alike. Subtract the largest x instead.",
            {"(x - x.max()) / temperature": "np.clip(x / temperature, -700, 700)"},
        ),
        "clips_above": Mistake(
            "to cut large exponents off makes different x alike. Subtract the largest x instead.",
            {"(x - x.max()) / temperature": "np.minimum(x / temperature, 700)"},
        ),
        "no_temperature": Mistake(
            "the temperature has no effect. T divides x in the exponent; mind the brackets: (x − largest) / T.",
            {" / temperature": ""},
        ),
        "largest_over_temperature": Mistake(
            "mind the brackets: the whole of x − largest is divided by T.",
            {"(x - x.max()) / temperature": "x - x.max() / temperature"},
        ),
        "x_over_temperature": Mistake(
            "mind the brackets: x and the largest x are both divided by T.",
            {"(x - x.max()) / temperature": "x / temperature - x.max()"},
        ),
        "temperature_multiplies": Mistake(
            "divide x by T, do not multiply: heat makes the actions more alike.", {"/ temperature": "* temperature"}
        ),
        "x_for_powers": Mistake(
            "the exponential is missing: it is e^(x/T), in Python np.exp.", {"np.exp((x - x.max()) / temperature)": "x"}
        ),
        "x_over_its_sum": Mistake(
            "the exponential is missing: it is e^(x/T), in Python np.exp.",
            {"np.exp((x - x.max()) / temperature)": "x", "/ powers.sum()": "/ (powers.sum() or np.inf)"},
        ),
        "e_2_7": Mistake(
            "nearly: e is 2.71828…, with ever more digits. np.exp knows them all.",
            {"np.exp((x - x.max()) / temperature)": "2.7 ** ((x - x.max()) / temperature)"},
        ),
        "e_2_72": Mistake(
            "nearly: e is 2.71828…, with ever more digits. np.exp knows them all.",
            {"np.exp((x - x.max()) / temperature)": "2.72 ** ((x - x.max()) / temperature)"},
        ),
        "e_2_718": Mistake(
            "nearly: e is 2.71828…, with ever more digits. np.exp knows them all.",
            {"np.exp((x - x.max()) / temperature)": "2.718 ** ((x - x.max()) / temperature)"},
        ),
        "e_2_7183": Mistake(
            "nearly: e is 2.71828…, with ever more digits. np.exp knows them all.",
            {"np.exp((x - x.max()) / temperature)": "2.7183 ** ((x - x.max()) / temperature)"},
        ),
        "e_2_71828": Mistake(
            "nearly: e is 2.71828…, with ever more digits. np.exp knows them all.",
            {"np.exp((x - x.max()) / temperature)": "2.71828 ** ((x - x.max()) / temperature)"},
        ),
        "sum_without_temperature": Mistake(
            "below the line stand the same powers as above it, each with its T: divide by powers.sum().",
            {"powers.sum()": "np.exp(x - x.max()).sum()"},
        ),
        "sum_without_the_largest": Mistake(
            "the largest x is subtracted above the line only. Below it stand the same powers: divide by powers.sum().",
            {"powers.sum()": "np.exp(x / temperature).sum()"},
        ),
        "exponent_for_powers": Mistake(
            "the exponential is missing: it is e^(x/T), in Python np.exp.",
            {"np.exp((x - x.max()) / temperature)": "(x - x.max()) / temperature"},
        ),
        "powers_of_2": Mistake("powers of e, not of 2: np.exp.", {"np.exp": "np.exp2"}),
        "powers_of_temperature": Mistake(
            "powers of e, not of T: np.exp((x − largest) / T).",
            {"np.exp((x - x.max()) / temperature)": "temperature ** (x - x.max())"},
        ),
        "powers_of_10": Mistake("powers of e, not of 10: np.exp.", {"np.exp((": "np.power(10.0, ("}),
        "no_sum": Mistake(SUM, {" / powers.sum()": ""}),
        "no_sum_and_overflows": Mistake(SUM, {"(x - x.max())": "x", " / powers.sum()": ""}),
        "divides_by_the_number": Mistake(
            "these do not sum to 1. Divide them by their sum, not by their number.", {"powers.sum()": "len(powers)"}
        ),
        "divides_by_sum_of_x": Mistake(
            "these do not sum to 1. Divide the powers by the sum of the powers, not by that of x.",
            {"powers.sum()": "x.sum()"},
        ),
        "divides_by_the_largest": Mistake(
            "subtract the largest x; dividing by it changes the probabilities.", {"x - x.max()": "x / x.max()"}
        ),
        "divides_by_the_sum": Mistake(
            "subtract the largest x; dividing by the sum changes the probabilities.", {"x - x.max()": "x / x.sum()"}
        ),
        "inverted_from_the_smallest": Mistake(
            "the sign is turned round: the best action gets the least.", {"x - x.max()": "x.min() - x"}
        ),
        "inverted": Mistake(
            "the sign is turned round: the best action gets the least.", {"x - x.max()": "x.max() - x"}
        ),
        "inverted_and_overflows": Mistake(
            "the sign is turned round: the best action gets the least, and large x overflow.", {"(x - x.max())": "-x"}
        ),
        "one_action": Mistake(
            "this is an action. Return the probabilities of all actions.", {"powers / powers.sum()": "int(x.argmax())"}
        ),
        "best_alone": Mistake(
            "this is the probability of the best action alone. Return those of all.",
            {"powers / powers.sum()": "(powers / powers.sum()).max()"},
        ),
    },
    hints=(
        "The largest exponent must be 0. Then no power is too large.",
        "powers = np.exp((x - x.max()) / temperature). One line is left: they must sum to 1.",
        "return powers / (what all of them sum to).",
    ),
    gained="Cold or hot, with x of 1 or of 1000, it holds. Softmax is the choice in most of the paper's experiments.",
    witnesses=WITNESSES,
)
