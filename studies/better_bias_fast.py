"""Wandering for new ground on the kinematic base, the whole loop of learning compiled: the same numbers, far sooner.

`rl.learn` compiles the loop of a task by itself, but not of one whose reward remembers where the robot has been.
tests/studies/test_better_bias.py holds this one against the loop in Python, reward for reward.
"""

from __future__ import annotations

import math
from collections import namedtuple
from typing import Any

import gymnasium
import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.learning.kernel_world import NEVER, KernelWorld
from rlrobot_edu.robots.arenas import Arena
from rlrobot_edu.robots.chassis import PIONEER
from rlrobot_edu.robots.engines.kinematic.base import Body, walls_of
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.task.robot_cards import FRONT_LASERS, LASER_RANGE, LASERS

COLLISION = 0.05  # of wander_1k, 4k and 12k [m]
X, Y, THETA = (
    len(LASERS),
    len(LASERS) + 1,
    len(LASERS) + 2,
)  # after the lasers, in an array of readings

# walls, hull, radius, moment, rays: as kinematic/base.py has them; inset, axle: of the chassis [m]; start: of the axle
# twists: array (actions, 2), v and omega; sensors, cuts, bins: of the inputs, lasers; front: which lasers touch
# cell, memory: of new ground; episode_steps: none end
# place, near, touch: what the kernels change, as kinematic/motion.py has them; seen: array (11,), the readings
# clock: array (1,), steps so far; last: array (64, 64), when the robot was in a cell
Fast = namedtuple(
    "Fast",
    "walls hull radius moment rays inset axle start twists sensors cuts bins front step_time cell memory"
    " episode_steps place near touch seen clock last",
)


@compiled
def sense(w, place, seen):
    """Write the readings, array (11,), lasers [m], x, y [m] and theta [rad]; return the number of the state."""
    look(place, w.rays, w.inset + LASER_RANGE, w.walls, seen)
    for i in range(w.rays.shape[0]):
        seen[i] = min(max(seen[i] - w.inset, 0.0), LASER_RANGE)
    seen[X] = place[0] - w.axle * math.cos(place[2])
    seen[Y] = place[1] - w.axle * math.sin(place[2])
    seen[THETA] = place[2]
    s = 0
    for i in range(w.sensors.shape[0]):
        k, reading = 0, seen[w.sensors[i]]
        while k < w.bins[i] - 1 and reading > w.cuts[i, k]:
            k += 1
        s = s * w.bins[i] + k
    return s


@compiled
def is_new(w, x, y, now, last):
    """Whether the robot has not been in this cell lately; from now on it has."""
    i, j = (
        math.floor(x / w.cell) + last.shape[0] // 2,
        math.floor(y / w.cell) + last.shape[1] // 2,
    )
    new = now - last[i, j] > w.memory
    last[i, j] = now
    return new


@compiled
def reward(w, seen, now, last):
    """The reward of new ground."""
    pays, touching = is_new(w, seen[X], seen[Y], now, last), 0
    for i in range(w.front.shape[0]):
        touching += seen[w.front[i]] < COLLISION
    return -10.0 if touching > 1 else -2.0 if touching == 1 else 10.0 if pays else -0.02


@compiled
def begin(w, rng):
    """Put the robot at its start, on a floor where it has not been; the state there."""
    w.place[:] = w.start
    w.clock[0] = 0
    w.last[:] = -w.memory - 1
    s = sense(w, w.place, w.seen)
    is_new(w, w.seen[X], w.seen[Y], 0, w.last)
    return s


@compiled
def outcome(w, s, a, rng):
    """What happens after (s, a): (s', r, terminated)."""
    body = w.hull, w.radius, w.moment
    v, omega = w.twists[a, 0], w.twists[a, 1]
    drive(w.place, v, omega, w.step_time, *body, w.walls, w.near, w.touch)
    w.clock[0] += 1
    s_next = sense(w, w.place, w.seen)
    return s_next, reward(w, w.seen, w.clock[0], w.last), False


class FastBase(gymnasium.Env[Any, Any]):
    """The base in a wandering task that pays for new ground; it always begins anew.

    task: with lasers as inputs, and without end; arena: its walls
    cell, memory: see better_bias_worlds.NewGround
    """

    def __init__(self, task: rl.Task, arena: Arena, cell: float, memory: int) -> None:
        self.r_max, self.episode_steps = max(task.rewards), None
        self.observation_space: gymnasium.Space[Any] = gymnasium.spaces.MultiDiscrete(
            list(task.states.shape)
        )
        self.action_space = gymnasium.spaces.Discrete(task.actions.n)
        bins = np.array(task.states.shape)
        cuts = np.full((len(bins), bins.max() - 1), np.inf)
        for i, variable in enumerate(task.inputs):
            cuts[i, : len(variable.cuts)] = variable.cuts
        x, y, theta = arena.start
        start = [
            x + PIONEER.axle * math.cos(theta),
            y + PIONEER.axle * math.sin(theta),
            theta,
        ]
        twists = [PIONEER.twist(task.command_for(a)) for a in range(task.actions.n)]
        sensors = [LASERS.index(variable.name) for variable in task.inputs]
        front = [LASERS.index(name) for name in FRONT_LASERS]
        self.episode_step, self.np_random = 0, np.random.default_rng(0)
        walls = walls_of(arena)
        self._w = Fast(
            walls, *Body.of(PIONEER), PIONEER.inset, PIONEER.axle, np.array(start), np.array(twists),
            np.array(sensors), cuts, bins, np.array(front), task.step_time, cell, memory,
            NEVER, np.empty(3), np.empty(len(walls), np.int64), np.empty(7), np.empty(len(LASERS) + 3),
            np.zeros(1, np.int64), np.zeros((64, 64), np.int64),
        )  # fmt: skip

    def kernel_world(self, steps: int) -> KernelWorld:
        """This world as kernels."""
        w = self._w
        return KernelWorld(begin, outcome, w, (w.place, w.seen, w.clock, w.last))

    def arrive(self, s: int) -> None:
        """Be in state `s`: the arrays are there already."""
