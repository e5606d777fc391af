"""A wandering task on the kinematic base whose whole loop of learning is compiled: the same numbers, some times faster.

`rl.learn` runs an environment that can do so by itself. tests/studies/test_better_bias.py holds it against the loop in
Python, reward for reward.
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
from rlrobot_edu.kinematic.base import Body, walls_of
from rlrobot_edu.kinematic.motion import drive, look
from rlrobot_edu.learning.jit import borrowed, compiled
from rlrobot_edu.learning.loop import CompiledEnv
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.robots.arenas import Arena
from rlrobot_edu.robots.mobile_base import PIONEER
from rlrobot_edu.robots.wheels import twist
from rlrobot_edu.task.robot_cards import FRONT_LASERS, LASER_RANGE, LASERS

COLLISION, MOVED = 0.05, 0.07  # of wander_1k, 4k and 12k [m]

# walls, hull, radius, moment, rays: as kinematic/base.py has them; inset, axle: of the chassis [m]
# twists: array (actions, 2), v and omega; lasers, cuts, bins: of the inputs; front: which lasers touch
# cell, memory: of new ground, or 0
Wander = namedtuple(
    "Wander", "walls hull radius moment rays inset axle twists lasers cuts bins front step_time cell memory"
)


@compiled
def sense(w, place, lengths):
    """Write what the lasers see, array (8,) [m], and return the number of the state."""
    look(place, w.rays, w.inset + LASER_RANGE, w.walls, lengths)
    s = 0
    for i in range(lengths.shape[0]):
        lengths[i] = min(max(lengths[i] - w.inset, 0.0), LASER_RANGE)
    for i in range(w.lasers.shape[0]):
        k = 0
        while k < w.bins[i] - 1 and lengths[w.lasers[i]] > w.cuts[i, k]:
            k += 1
        s = s * w.bins[i] + k
    return s


@compiled
def is_new(w, x, y, now, last):
    """Whether the robot has not been in this cell lately; from now on it has."""
    i, j = math.floor(x / w.cell) + last.shape[0] // 2, math.floor(y / w.cell) + last.shape[1] // 2
    new = now - last[i, j] > w.memory
    last[i, j] = now
    return new


@cache
def make_run(method: Method) -> Callable[..., Any]:
    """The loop for this method."""
    select, learn_step = make_step(method)[1:]

    @compiled
    def run(w, m, place, near, touch, lengths, last, u, log):
        """Learn until the log is full; u: the agent's uniform numbers, one more than steps."""
        w, m, log = borrowed(w), borrowed(m), borrowed(log)
        x, y = place[0] - w.axle * math.cos(place[2]), place[1] - w.axle * math.sin(place[2])
        if w.memory > 0:
            is_new(w, x, y, 0, last)
        s = sense(w, place, lengths)
        begin_episode(m)
        a = select(m, s, u[0])
        for t in range(log.r.shape[0]):
            v, omega = w.twists[a, 0], w.twists[a, 1]
            drive(place, v, omega, w.step_time, w.hull, w.radius, w.moment, w.walls, near, touch)
            s_next = sense(w, place, lengths)
            new_x, new_y = place[0] - w.axle * math.cos(place[2]), place[1] - w.axle * math.sin(place[2])
            pays = math.hypot(new_x - x, new_y - y) > MOVED
            if w.memory > 0:
                pays = is_new(w, new_x, new_y, t + 1, last)
            touching = 0
            for i in range(w.front.shape[0]):
                touching += lengths[w.front[i]] < COLLISION
            r = -10.0 if touching > 1 else -2.0 if touching == 1 else 10.0 if pays else -0.02
            a_next, _ = learn_step(m, s, a, r, s_next, False, u[t + 1])
            log.s[t], log.a[t], log.r[t], log.s_next[t] = s, a, r, s_next
            x, y, s, a = new_x, new_y, s_next, a_next
        return a

    return run


class FastWander(CompiledEnv):
    """One hour, or as long as it is, in a wandering task; then it is over.

    task: with lasers as inputs, and the reward of wander_1k; arena: its walls
    cell, memory: 0, or see better_bias_worlds.NewGround
    """

    def __init__(self, task: rl.Task, arena: Arena, cell: float = 0.0, memory: int = 0) -> None:
        self.r_max, self.episode_steps = max(task.rewards), None
        self.observation_space: gymnasium.Space[Any] = gymnasium.spaces.MultiDiscrete(list(task.states.shape))
        self.action_space = gymnasium.spaces.Discrete(task.actions.n)
        body, bins = Body.of(PIONEER), np.array(task.states.shape)
        cuts = np.full((len(bins), bins.max() - 1), np.inf)
        for i, variable in enumerate(task.inputs):
            cuts[i, : bins[i] - 1] = variable.cuts
        twists = [twist(task.command_for(a), PIONEER) for a in range(task.actions.n)]
        self._w = Wander(
            walls_of(arena), *body, PIONEER.inset, PIONEER.axle, np.array(twists),
            np.array([LASERS.index(variable.name) for variable in task.inputs]), cuts, bins,
            np.array([LASERS.index(name) for name in FRONT_LASERS]), task.step_time, cell, memory,
        )  # fmt: skip
        x, y, theta = arena.start
        self._start = np.array([x + PIONEER.axle * math.cos(theta), y + PIONEER.axle * math.sin(theta), theta])

    def drive(self, agent: rl.Agent, log: Transitions, episodes: int | None) -> Iterator[int]:
        """Run the loop compiled."""
        n, w = len(log.r), self._w
        room = np.empty(len(w.walls), np.int64), np.empty(7), np.empty(len(LASERS))
        last = np.full((64, 64), -w.memory - 1) if w.memory else np.zeros((1, 1), np.int64)
        make_run(agent.made_of)(w, agent.memory, self._start.copy(), *room, last, agent.rng.random(n + 1), log)
        yield n
