"""The discount rate that looks ten steps ahead."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.question import Question

look_ahead = 0.5**0.1

exercise = Question(
    task="the discount rate γ with which a reward ten steps ahead counts one half",
    right=look_ahead,
    because="0.933 to the power of 10 is one half. A rule of thumb: γ looks about 1 / (1 − γ) steps ahead, here 15.",
    mistakes={
        "half": Mistake("with γ = 0.5 a reward halves at every step: ten steps ahead it counts 0.001 times.", 0.5),
        "a_tenth_of_half": Mistake(
            "this is 0.5 / 10. Is it written as 0.5 ** 1 / 10? Brackets, for ** comes before /. "
            "Discounting multiplies, and what you want is a root.",
            0.05,
        ),
        "takes_off": Mistake(
            "this takes 0.05 off at each step. Discounting multiplies: 0.95 to the power of 10 is 0.6.", 0.95
        ),
        "to_the_power_of_10": Mistake(
            "this is 0.5 to the power of 10. You want the opposite, the tenth root of 0.5.", 0.5**10
        ),
        "nine_tenths": Mistake("with γ = 0.9 it counts 0.35 times: too little.", 0.9),
        "power_of_nine_tenths": Mistake(
            "this is how much the reward counts with γ = 0.9. Which γ makes it count 0.5 times?", 0.9**10
        ),
        "two_digits": Mistake("nearly: 0.93 to the power of 10 is 0.48. Give three digits.", 0.93),
        "fourth_root": Mistake(
            "this is the fourth root of 0.5, as in the hint's example. You need the tenth.", 0.5**0.25
        ),
        "square_root": Mistake("this is the square root of 0.5. You need the tenth root.", 0.5**0.5),
        "ninth_root": Mistake(
            "this is the ninth root. The reward lies ten steps ahead: γ to the power of 10.", 0.5 ** (1 / 9)
        ),
        "eleventh_root": Mistake(
            "this is the eleventh root. The reward lies ten steps ahead: γ to the power of 10.", 0.5 ** (1 / 11)
        ),
        "logarithm": Mistake("this is the logarithm of γ. Take e to the power of it.", float(np.log(0.5) / 10)),
        "root_of_2": Mistake(
            "a γ above 1 would make later rewards count more. This is the tenth root of 2; take that of 0.5.", 2**0.1
        ),
        "root_of_10": Mistake(
            "this is 10 to the power of 0.5, the square root of 10. You have swapped base and exponent.", 10**0.5
        ),
        "swapped_with_a_tenth": Mistake(
            "this is 0.1 to the power of 0.5. You have swapped base and exponent.", 0.1**0.5
        ),
        "times_10": Mistake("this is 0.5 · 10. Discounting multiplies γ by itself, ten times.", 5.0),
        "too_large": Mistake("nearly: 0.94 to the power of 10 is 0.54. Give three digits, or the formula.", 0.94),
        "too_small": Mistake("nearly: 0.92 to the power of 10 is 0.43. Give three digits, or the formula.", 0.92),
        "half_by_root_of_10": Mistake(
            "this is 0.5 divided by the root of 10. What you want is the tenth root of 0.5.", 0.5 / 10**0.5
        ),
        "ten_times_root": Mistake("the root alone is γ. You multiplied it by 10.", 10 * 0.5**0.1),
        "one_minus_gamma": Mistake("this is 1 − γ. γ itself is the tenth root of 0.5.", 1 - 0.5**0.1),
    },
    hints=(
        "γ multiplied by itself ten times is to be 0.5. What undoes “to the power of 10”?",
        "The tenth root of 0.5, and a root is a power, too: the fourth root of x is x ** 0.25.",
        "0.5 ** (1 / …): which root is it?",
    ),
    gained="Now you can say how far ahead a robot looks, and choose γ by it.",
    witnesses={
        "half": [0.5],
        "a_tenth_of_half": [0.05],
        "takes_off": [0.95],
        "to_the_power_of_10": [1 / 1024],
        "two_digits": [0.93],
        "too_large": [0.94],
        "ten_times_root": [10 * 0.5**0.1],
        "half_by_root_of_10": [0.5 / 10**0.5],
    },
)
