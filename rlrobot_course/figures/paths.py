"""Where a robot drives: its places, and how long its path is."""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from rlrobot_edu.learning.size import Env
from rlrobot_edu.show.describe import robot_of


def drive(env: Env, actions: Sequence[int]) -> np.ndarray:
    """The positions of a robot that does these actions from its start; array (n + 1, 2) [m], the start first."""
    env.reset()
    places = [robot_of(env).readings]
    for a in actions:
        env.step(a)
        places.append(robot_of(env).readings)
    return np.array([(place["x"], place["y"]) for place in places])


def length_of(path: np.ndarray) -> float:
    """Length of a path, array (n, 2) [m]."""
    return sum(math.dist(a, b) for a, b in pairwise(path))
