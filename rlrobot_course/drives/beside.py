"""A drive by a learner's function and one by the right one: two films, and what differs in a sentence."""

from functools import cache
from typing import NamedTuple

import numpy as np

from rlrobot_course.drives.by_your_code import Drive, Driven, Reel, driven
from rlrobot_edu.show.describe import loss_of, path_of
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.numerals import with_minus
from rlrobot_grading.answers.values import Function

FEWEST = 5  # steps of which a film is made
NOTHING = "That is too early for a film."
SO_FAR = "The film shows its last {} steps until then."
ALIKE = (
    "Here both drive alike; the check also tries cases that this drive does not meet."
)


class Beside(NamedTuple):
    """Both drives. films: by the names "yours" and "right", empty where yours has hardly a step; said: in words"""

    films: dict[str, Film]
    said: str


def beside(drive: Drive, right: Function, answer: Function) -> Beside:
    """Let a robot drive by the learner's function, and one by the right function, with the same luck."""
    yours = driven(drive, answer)
    if len(yours.shots) < FEWEST:
        return Beside({}, f"{yours.note} {NOTHING}".strip())
    rights = by_right(drive, right)
    films = {"yours": Film.of(yours.shots), "right": Film.of(rights.shots)}
    said = SO_FAR.format(len(yours.shots))
    if yours.is_whole:
        said = what_differs(**films)
    return Beside(films, f"{yours.note} {said}".strip())


@cache
def by_right(drive: Drive, right: Function) -> Driven:
    """The drive by the right function."""
    reel = Reel()
    drive(right, reel)
    return Driven(list(reel.shots), reel.note, True)


def what_differs(yours: Film, right: Film) -> str:
    """What the robot earns and how often it loses much, by either code."""
    if are_alike(yours, right):
        return ALIKE
    mean, rights = (with_minus(np.mean(f.rewards), 2) for f in (yours, right))
    text = f"By your code the robot earns {mean} a step, by the right code {rights}."
    # what counts as much depends on what was paid to both
    limit = loss_of([*yours.rewards, *right.rewards])
    if limit is None:
        return text
    losses, its = (sum(r <= limit for r in f.rewards) for f in (yours, right))
    if losses != its:
        text = f"{text} It loses much in {losses} of its {len(yours.rewards)} steps, by the right code in {its}."
    return text


def are_alike(yours: Film, right: Film) -> bool:
    """Whether both robots go the same way."""
    ways = path_of(yours.frames), path_of(right.frames)
    return np.array_equal(*ways) and yours.rewards == right.rewards
