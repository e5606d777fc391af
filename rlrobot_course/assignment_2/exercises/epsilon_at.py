"""An ε that fades to an end."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case


def epsilon_at(t, start, end, half_life):
    return end + (start - end) * 0.5 ** (t / half_life)


def other_moment(rng: np.random.Generator, case: Case) -> Case:
    """A case of `epsilon_at` with another beginning and end, and at another moment unless it is the first."""
    start, end = sorted(rng.uniform(0.01, 0.99, 2), reverse=True)
    t = case["t"] and case["t"] + int(rng.integers(1, 9))
    return {"t": t, "start": float(start), "end": float(end), "half_life": case["half_life"] + int(rng.integers(5))}


WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return ε at step t: it begins at start, and its distance to end is halved every half_life steps",
    right=epsilon_at,
    returns="epsilon",
    tape=[
        {"t": 0, "start": 0.9, "end": 0.1, "half_life": 10},
        {"t": 10, "start": 0.9, "end": 0.1, "half_life": 10},
        {"t": 20, "start": 0.5, "end": 0.25, "half_life": 10},
        {"t": 7, "start": 1.0, "end": 0.05, "half_life": 20},
        {"t": 301, "start": 0.75, "end": 0.5, "half_life": 4},
        {"t": 5, "start": 0.625, "end": 0.0, "half_life": 2},
    ],
    mistakes={
        "ends_at_0": Mistake(
            "this goes to 0 in the end. What is halved is the part above end.", {"end + (start - end)": "start"}
        ),
        "no_end": Mistake(
            "end is forgotten: what is halved is the part above end, and end comes on top.", {"end + ": ""}
        ),
        "begins_above_start": Mistake(
            "start - end comes to nothing in the end, and end is added: so at t = 0 it must be start. Yours is more.",
            {"(start - end)": "start"},
        ),
        "halves_each_step": Mistake(
            "this falls by one half in each step. It should take half_life steps for that: t / half_life.",
            {"t / half_life": "t"},
        ),
        "swapped": Mistake("t and half_life have changed places.", {"t / half_life": "half_life / (t + 1e-9)"}),
        "base_e": Mistake(
            "e instead of 2: after half_life steps exactly one half must be left, not 37 %.",
            {"0.5 **": "float(np.exp(-1)) **"},
        ),
        "whole_half_lives": Mistake(
            "whole half-lives alone are counted. Halving goes on in between, too: / instead of //.",
            {"t / half_life": "t // half_life"},
        ),
        "straight_line": Mistake(
            "this falls along a straight line. Halving is a power: 0.5 ** (t / half_life).",
            {"0.5 ** (t / half_life)": "max(0.0, 1 - 0.5 * t / half_life)"},
        ),
    },
    another=other_moment,
    hints=(
        "What is halved again and again is the distance to end. How large is it at the start, and how often is it "
        "halved until t?",
        "The distance is start - end, and it is halved t / half_life times: 0.5 ** (t / half_life).",
        "end + (start - end) * …: only the power is missing.",
    ),
    gained="It never gets below end: a robot that must go on learning keeps an open mind.",
    witnesses=WITNESSES,
)
