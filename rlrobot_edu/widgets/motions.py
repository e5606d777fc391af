"""The names and signs of what two wheels make a robot do: the one list for all pages and pictures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Motion(NamedTuple):
    """A motion as a sign, as a name, and as what the robot did: it "stood still"."""

    icon: str
    name: str
    told: str


# By the signs of the robot's speed ahead and of its turn to the left
_MOTIONS = {
    (1, 0): Motion("↑", "ahead", "drove ahead"),
    (1, 1): Motion("↖", "arc left", "drove an arc to the left"),
    (1, -1): Motion("↗", "arc right", "drove an arc to the right"),
    (0, 1): Motion("↺", "spin left", "spun to the left"),
    (0, -1): Motion("↻", "spin right", "spun to the right"),
    (0, 0): Motion("■", "stand still", "stood still"),
    (-1, 0): Motion("↓", "back", "drove back"),
    (-1, -1): Motion("↙", "back, to the left", "drove back to the left"),
    (-1, 1): Motion("↘", "back, to the right", "drove back to the right"),
}
SPIN_LEFT, SPIN_RIGHT, AHEAD, STILL = (
    _MOTIONS[signs] for signs in ((0, 1), (0, -1), (1, 0), (0, 0))
)


def signs(left: float, right: float) -> tuple[int, int]:
    """Signs of the speed ahead and of the turn to the left of wheels with these speeds [rad/s]."""
    ahead = int(np.sign(left + right))
    turn = int(np.sign(right - left))
    return ahead, turn


def motion_of(left: float, right: float) -> Motion:
    """How wheels with these speeds [rad/s] move a robot."""
    return _MOTIONS[signs(left, right)]


def name_of(v: float, omega: float) -> str:
    """The name of the motion at v [m/s] and omega [rad/s]; straight on also its speed."""
    ahead = int(np.sign(v))
    turn = int(np.sign(omega))
    name = _MOTIONS[ahead, turn].name
    return f"{name}, {abs(v):.1f} m/s" if ahead and not turn else name
