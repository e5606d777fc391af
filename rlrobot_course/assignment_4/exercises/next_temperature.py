"""A temperature that rises in circles that do not pay."""

from __future__ import annotations

from rlrobot_course.assignment_4.exercises.period import period
from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake


def next_temperature(temperature, states, rewards, default):
    p = period(states)
    if p > 0 and sum(rewards[-p:]) < 0:
        return min(50, temperature + len(states) / (4 * p))
    return default


WITNESSES = read_answers(__file__, {"period": period})[1]

exercise = Exercise(
    task="return the temperature of the next step: hotter in a circle that does not pay, default otherwise",
    right=next_temperature,
    returns="temperature",
    lenders={"period": "your function of exercise 3"},
    tape=[
        {"temperature": 1.5, "states": [4, 7, 4, 7], "rewards": [-0.5, -0.25, -0.5, -0.25], "default": 1.5},
        {"temperature": 9.5, "states": [3, 1, 2, 5], "rewards": [-0.5, -0.5, -2.5, -0.5], "default": 1.25},
        {"temperature": 3.5, "states": [6, 6, 6, 6, 6, 6], "rewards": [-0.5] * 6, "default": 0.5},
        {"temperature": 3.5, "states": [6, 2, 6, 2], "rewards": [-20.5, -0.5, 9.5, -0.25], "default": 0.75},
        {"temperature": 4.5, "states": [6, 2, 6, 2], "rewards": [9.5, 9.25, -0.5, -0.25], "default": 1.5},
        {
            "temperature": 6.5,
            "states": [3, 6, 8, 1, 2, 1, 2],
            "rewards": [9.5, 9.25, 9.5, 9.25, 9.5, -0.5, -0.25],
            "default": 1.5,
        },
        {"temperature": 62.5, "states": [8, 8, 8], "rewards": [-0.5, -0.5, -0.5], "default": 1.5},
        {"temperature": 7.5, "states": [1, 2, 1, 2], "rewards": [-3.5, 1.5, 0.0, 0.0], "default": 1.5},
        {"temperature": 5.5, "states": [9], "rewards": [-0.5], "default": 2.5},
        {"temperature": 2.5, "states": [0, 1, 2, 3, 1, 2, 3], "rewards": [-0.25] * 7, "default": 0.5},
    ],
    mistakes={
        "heats_where_it_pays": Mistake(
            "a circle that pays is no trap: it heats up only where the rewards of the last round sum to less than 0.",
            {" and sum(rewards[-p:]) < 0": ""},
        ),
        "heats_at_0": Mistake("a round that earns exactly 0 is not below 0.", {"< 0": "<= 0"}),
        "all_rewards": Mistake("only the rewards of the last round count, the last p.", {"rewards[-p:]": "rewards"}),
        "no_cap": Mistake(
            "it never gets hotter than 50: take the smaller one.",
            {"min(50, temperature + len(states) / (4 * p))": "temperature + len(states) / (4 * p)"},
        ),
        "from_the_default": Mistake(
            "what is added stands on top of the temperature there is.",
            {"temperature + len(states)": "default + len(states)"},
        ),
        "stays_hot": Mistake(
            "outside a circle the temperature goes back to default at once.", {"return default": "return temperature"}
        ),
        "no_4": Mistake("n / (4 p): the 4 is missing.", {"(4 * p)": "p"}),
        "multiplies_by_p": Mistake(
            "brackets: n / (4 p) divides by p, and yours multiplies by it.", {"(4 * p)": "4 * p"}
        ),
        "upside_down": Mistake(
            "the shorter the circle the hotter: p stands below the line.", {"len(states) / (4 * p)": "p / 4"}
        ),
        "heats_without_a_circle": Mistake(
            "without a circle nothing heats up, however little is earned.",
            {"p > 0 and sum(rewards[-p:]) < 0": "sum(rewards[-p:]) < 0", "(4 * p)": "max(4 * p, 4)"},
        ),
    },
    hints=(
        "Two questions: does it go in a circle, and did the last round of it earn less than nothing?",
        "p = period(states); the rewards of the last round are rewards[-p:], and they only mean something if p > 0.",
        "if p > 0 and sum(rewards[-p:]) < 0: return min(50, temperature + …); else default.",
    ),
    gained="The smaller the circle, the more it heats up: a robot that stands still gets hot at once.",
    witnesses=WITNESSES,
)
