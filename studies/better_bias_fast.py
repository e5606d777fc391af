"""Wandering for new ground on the kinematic base, the whole loop of learning compiled: the same numbers, far sooner.

`rl.learn` compiles the loop of a task by itself, but not of one whose reward remembers where the robot has been.
tests/studies/test_better_bias.py holds this one against the loop in Python, reward for reward.
"""

from __future__ import annotations

import math
from collections import namedtuple
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import gymnasium
import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.jit.dispatcher import borrowed, compiled
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.learning.transitions import Transitions
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
# cell, memory: of new ground
Fast = namedtuple(
    "Fast",
    "walls hull radius moment rays inset axle start twists sensors cuts bins front step_time cell memory",
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


@cache
def make_run(method: Method) -> Callable[..., Any]:
    """The loop for this method."""
    select, learn_step = make_step(method)[1:]

    @compiled
    def run(w, m, place, near, touch, seen, last, u, log):
        """Learn until the log is full. u: the agent's uniform numbers, one a step and one for the first."""
        w, m, log = borrowed(w), borrowed(m), borrowed(log)
        place[:] = w.start
        s = sense(w, place, seen)
        is_new(w, seen[X], seen[Y], 0, last)
        begin_episode(m)
        a = select(m, s, u[0])
        for t in range(log.r.shape[0]):
            v, omega = w.twists[a, 0], w.twists[a, 1]
            drive(
                place,
                v,
                omega,
                w.step_time,
                w.hull,
                w.radius,
                w.moment,
                w.walls,
                near,
                touch,
            )
            s_next = sense(w, place, seen)
            r = reward(w, seen, t + 1, last)
            a_next, _ = learn_step(m, s, a, r, s_next, False, u[t + 1])
            log.s[t], log.a[t], log.r[t], log.s_next[t] = s, a, r, s_next
            s, a = s_next, a_next

    return run


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
        self._w = Fast(
            walls_of(arena), *Body.of(PIONEER), PIONEER.inset, PIONEER.axle, np.array(start), np.array(twists),
            np.array(sensors), cuts, bins, np.array(front), task.step_time, cell, memory,
        )  # fmt: skip

    def learn_compiled(
        self, agent: rl.Agent, log: Transitions, episodes: int | None
    ) -> Iterator[int]:
        """Run the loop compiled."""
        n, w = len(log.r), self._w
        room = (
            np.empty(3),
            np.empty(len(w.walls), np.int64),
            np.empty(7),
            np.empty(len(LASERS) + 3),
        )
        last = np.full((64, 64), -w.memory - 1)
        make_run(agent.method)(
            w, agent.memory, *room, last, agent.rng.random(n + 1), log
        )
        yield n
