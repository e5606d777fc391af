"""Right answers and tapes of lesson 12; the pages of this folder have the tasks, hints and mistakes."""

import numpy as np

from rlrobot_course.exercises.parts import Exercise, Formula, Question, with_pages
from rlrobot_course.worlds.tapes import rows

TO_AND_FRO = Formula(
    "a_round / (1 - γ**2)", γ=0.9, there=5, back=-1, a_round="there + γ * back"
)


def shaping(phi, phi_next, terminated, gamma):
    if terminated:
        phi_next = 0.0
    return gamma * phi_next - phi


check = with_pages(
    globals(),
    targets=Question(Formula("(r, r + γ * Q)", r=10.0, γ=0.9, Q=50)),
    to_and_fro=Question(TO_AND_FRO),
    shaping=Exercise(
        shaping,
        returns="addition",
        tape=rows(
            "phi phi_next terminated gamma",
            (-3.0, -2.0, False, 0.9),
            (-2.0, -3.0, False, 0.9),
            (-1.0, -7.0, True, 0.9),
            (-4.0, -4.0, False, 0.9),
            (2.5, 4.0, False, 0.5),
            (0.0, -1.5, False, 1.0),
            (6.0, 3.0, np.True_, 0.8),  # as a comparison in numpy has it
            (-5.0, 0.0, False, 0.99),
            (-1.23456, 2.34567, False, 0.87654),
            (-2.0, -3.0, False, 0.0),
        ),
    ),
)
