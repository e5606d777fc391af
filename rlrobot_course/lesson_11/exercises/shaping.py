"""A reward shaped by a potential."""

from __future__ import annotations

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.shared_hints import OWN_GAMMA


def shaping(phi, phi_next, terminated, gamma):
    if terminated:
        phi_next = 0.0
    return gamma * phi_next - phi


STEPS = [
    (-3.0, -2.0, False, 0.9),
    (-2.0, -3.0, False, 0.9),
    (-1.0, -7.0, True, 0.9),
    (-4.0, -4.0, False, 0.9),
    (2.5, 4.0, False, 0.5),
    (0.0, -1.5, False, 1.0),
    (6.0, 3.0, True, 0.8),
    (-5.0, 0.0, False, 0.99),
]

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return what shaping adds to the reward of a step",
    right=shaping,
    returns="addition",
    tape=[dict(zip(("phi", "phi_next", "terminated", "gamma"), step, strict=True)) for step in STEPS],
    mistakes={
        "past_the_end": Mistake("past the end φ counts as 0: look at terminated.", {"if terminated:": "if False:"}),
        "no_gamma": Mistake(
            "γ is missing: γ times the potential after the step, less the one before it.",
            {"gamma * phi_next": "phi_next"},
        ),
        "gamma_at_the_first": Mistake(
            "γ belongs to the potential after the step, not to the one before it.",
            {"gamma * phi_next - phi": "phi_next - gamma * phi"},
        ),
        "gamma_for_both": Mistake(
            "γ multiplies the later potential alone, not the whole difference.",
            {"gamma * phi_next - phi": "gamma * (phi_next - phi)"},
        ),
        "swapped": Mistake(
            "the sign: what comes after, less what was before.", {"gamma * phi_next - phi": "phi - gamma * phi_next"}
        ),
        "no_first": Mistake("the potential before the step is missing.", {" - phi": ""}),
        "adds": Mistake("the potential before the step is taken off, not added.", {"- phi": "+ phi"}),
        "inverted": Mistake(
            "turned round: φ counts as 0 where the episode terminates.", {"if terminated": "if not terminated"}
        ),
        "nothing_at_the_end": Mistake(
            "at the end it is the potential after the step that counts as 0. The one before it is still taken off.",
            {"phi_next = 0.0": "return 0.0"},
        ),
        "gains_alone": Mistake(
            "only a gain is paid by yours. A retreat must cost what the approach has paid, or to and fro pays.",
            {"gamma * phi_next - phi": "max(0.0, gamma * phi_next - phi)"},
        ),
        "own_gamma": Mistake(OWN_GAMMA, {"gamma * phi_next": "0.9 * phi_next"}),
        "abs": Mistake(
            "a positive number for every move will not do: leave abs out.",
            {"gamma * phi_next - phi": "abs(gamma * phi_next - phi)"},
        ),
    },
    hints=(
        "Two numbers: the potential after the step, which comes a step later, and the one before it.",
        "gamma * phi_next - phi, and phi_next counts as 0 where the episode has terminated.",
        "return gamma * (0 if terminated else …) - …",
    ),
    gained="With this you may lead any learner by any hint that you like, and it cannot be milked.",
    witnesses=WITNESSES,
)
