"""The motion that two wheels give a robot, as one sign."""

from __future__ import annotations

import numpy as np

# By the signs of the robot's speed ahead and of its turn to the left
_ICONS = {
    (1, 0): "↑",
    (1, 1): "↖",
    (1, -1): "↗",
    (0, 1): "↺",
    (0, -1): "↻",
    (0, 0): "■",
    (-1, 0): "↓",
    (-1, -1): "↙",
    (-1, 1): "↘",
}


def motion(left: float, right: float) -> tuple[int, int]:
    """Signs of the speed ahead and of the turn to the left of wheels with these speeds [rad/s]."""
    ahead = int(np.sign(left + right))
    turn = int(np.sign(right - left))
    return ahead, turn


def wheel_icon(left: float, right: float) -> str:
    """The direction in which wheels with these speeds [rad/s] move a robot."""
    return _ICONS[motion(left, right)]
