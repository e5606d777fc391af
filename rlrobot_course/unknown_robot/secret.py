"""What only the instructor knows: the weaknesses and the wall that a secret stands for."""

import hashlib
import os
from math import hypot, pi
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.arenas import Arena, Wall
from rlrobot_edu.robots.realism import Realism

ROUNDS = 300_000  # of hashing: whoever tries secrets one by one waits a part of a second for each
LENGTH, ROOM = (
    0.25,
    0.12,
)  # of the wall, as part of the arena's shorter side; between it and the robot's start [m]


class Secret(NamedTuple):
    """What a secret stands for.

    key: the secret, hashed; it also signs the log
    """

    key: bytes

    @property
    def realism(self) -> Realism:
        """The robot's weaknesses, in control steps of a tenth of a second."""
        rng = np.random.default_rng([0, *self.key])
        laser_noise, _ = rng.uniform([0.005, 0.0], [0.02, 0.004])
        return Realism(
            laser_noise=laser_noise,
            wheel_slip=rng.uniform(0.1, 0.5),
            delay=int(rng.integers(1, 5)),
            lag=rng.uniform(0.0, 0.08),
            wall_friction=rng.uniform(0.2, 1.0),
        )

    def with_wall(self, arena: Arena, radius: float) -> Arena:
        """The arena with one wall more, away from the start of a robot of this radius [m]."""
        rng = np.random.default_rng([1, *self.key])
        low_x, low_y, high_x, high_y = arena.bounds
        length = LENGTH * min(high_x - low_x, high_y - low_y)
        while True:
            x, y = rng.uniform((low_x, low_y), (high_x, high_y)).tolist()
            wall = Wall(x, y, length, angle=rng.uniform(0.0, pi))
            if (
                hypot(x - arena.start[0], y - arena.start[1])
                > radius + length / 2 + ROOM
            ):
                return arena._replace(walls=(*arena.walls, wall))


def unlock(where: str) -> Secret:
    """The secret in a file (``file:secret.txt``), in a variable of the environment (``env:NAME``), or `where` itself.

    Raises ValueError for an empty one, OSError if there is no such file.
    """
    kind, _, name = where.partition(":")
    said = os.environ.get(name, "") if kind == "env" else where
    plain = Path(name).read_bytes() if kind == "file" else said.encode()
    if not plain.strip():
        raise ValueError(
            f"{where}: no secret is there; write one of 16 letters or more that nobody can guess"
        )
    return Secret(hashlib.pbkdf2_hmac("sha256", plain.strip(), b"rlrobot_edu", ROUNDS))
