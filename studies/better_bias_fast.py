"""Wandering and navigation on the kinematic base, the whole loop of learning compiled: the same numbers, far sooner.

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
from rlrobot_edu.learning.jit import borrowed, compiled
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.robots.arenas import Arena
from rlrobot_edu.robots.engines.kinematic.base import Body, walls_of
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.robots.mobile_base import PIONEER
from rlrobot_edu.task.robot_cards import FRONT_LASERS, LASER_RANGE, LASERS

COLLISION, MOVED = 0.05, 0.07  # of wander_1k, 4k and 12k [m]
GOAL_X, GOAL_Y, GOAL_RADIUS, GOAL_STEPS, NEAR = 1.65, 1.575, 0.5, 6, 0.08  # of navigation_1k [m]
X, Y, THETA = len(LASERS), len(LASERS) + 1, len(LASERS) + 2  # after the lasers, in an array of readings

# walls, hull, radius, moment, rays: as kinematic/base.py has them; inset, axle: of the chassis [m]; start: of the axle
# twists: array (actions, 2), v and omega; sensors, cuts, sectors, bins: of the inputs; front: which lasers touch
# cell, memory: of new ground, or 0; episode_steps: 0 where the reward is that of wandering, else navigation's
Fast = namedtuple(
    "Fast",
    "walls hull radius moment rays inset axle start twists sensors cuts sectors bins front step_time cell memory "
    "episode_steps",
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
        if w.sectors[i] > 0:
            k = round(reading * w.sectors[i] / (2 * math.pi)) % w.sectors[i]
        else:
            while k < w.bins[i] - 1 and reading > w.cuts[i, k]:
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


@compiled
def wander_reward(w, x, y, seen, now, last):
    """The reward of wander_1k, or that of new ground; x, y: before the step."""
    pays = math.hypot(seen[X] - x, seen[Y] - y) > MOVED
    if w.memory > 0:
        pays = is_new(w, seen[X], seen[Y], now, last)
    touching = 0
    for i in range(w.front.shape[0]):
        touching += seen[w.front[i]] < COLLISION
    return -10.0 if touching > 1 else -2.0 if touching == 1 else 10.0 if pays else -0.02


@compiled
def navigation_reward(w, x, y, seen):
    """The reward of navigation_1k, and whether the robot is at the goal; x, y: before the step."""
    before, after = math.hypot(x - GOAL_X, y - GOAL_Y), math.hypot(seen[X] - GOAL_X, seen[Y] - GOAL_Y)
    if after < GOAL_RADIUS:
        return 10.0, True
    touching = 0
    for i in range(w.front.shape[0]):
        touching += seen[w.front[i]] < NEAR
    if touching > 0:
        return (-10.0 if touching > 1 else -2.0), False
    if after - before > MOVED:
        return -1.0, False
    return (float(min(5, round(1 + 4 / after))) if before - after > MOVED else -0.1), False


@cache
def make_run(method: Method) -> Callable[..., Any]:
    """The loop for this method."""
    select, learn_step = make_step(method)[1:]

    @compiled
    def run(w, m, place, near, touch, seen, last, u, log, episodes):
        """Learn until the log is full or so many episodes have ended; returns the steps.

        u: the agent's uniform numbers, one a step and one an episode
        """
        w, m, log = borrowed(w), borrowed(m), borrowed(log)
        s, a, k, episode_step, at_goal = 0, -1, 0, 0, 0
        for t in range(log.r.shape[0]):
            if a < 0:
                place[:] = w.start
                s = sense(w, place, seen)
                if w.memory > 0:
                    is_new(w, seen[X], seen[Y], t, last)
                begin_episode(m)
                a = select(m, s, u[k])
                k, episode_step, at_goal = k + 1, 0, 0
            x, y = seen[X], seen[Y]
            v, omega = w.twists[a, 0], w.twists[a, 1]
            drive(place, v, omega, w.step_time, w.hull, w.radius, w.moment, w.walls, near, touch)
            s_next = sense(w, place, seen)
            episode_step += 1
            if w.episode_steps > 0:
                r, arrived = navigation_reward(w, x, y, seen)
                at_goal = at_goal + 1 if arrived else 0
            else:
                r = wander_reward(w, x, y, seen, t + 1, last)
            end = at_goal >= GOAL_STEPS
            cut = not end and w.episode_steps > 0 and episode_step >= w.episode_steps
            a_next, _ = learn_step(m, s, a, r, s_next, end, u[k])
            k += 1
            log.s[t], log.a[t], log.r[t], log.s_next[t], log.terminated[t], log.truncated[t] = s, a, r, s_next, end, cut
            s, a = s_next, a_next
            if end or cut:
                a = -1
                episodes -= 1
                if episodes == 0:
                    return t + 1
        return log.r.shape[0]

    return run


class FastBase(gymnasium.Env[Any, Any]):
    """The base in a wandering task with the reward of wander_1k, or in navigation_1k; it always begins anew.

    task: with lasers, x, y and theta as inputs; arena: its walls
    cell, memory: 0, or see better_bias_worlds.NewGround
    """

    def __init__(self, task: rl.Task, arena: Arena, cell: float = 0.0, memory: int = 0) -> None:
        self.r_max, self.episode_steps = max(task.rewards), task.episode_steps
        self.observation_space: gymnasium.Space[Any] = gymnasium.spaces.MultiDiscrete(list(task.states.shape))
        self.action_space = gymnasium.spaces.Discrete(task.actions.n)
        bins, names = np.array(task.states.shape), [*LASERS, "x", "y", "theta"]
        cuts = np.full((len(bins), bins.max() - 1), np.inf)
        for i, variable in enumerate(task.inputs):
            cuts[i, : len(variable.cuts or ())] = variable.cuts or ()
        x, y, theta = arena.start
        start = [x + PIONEER.axle * math.cos(theta), y + PIONEER.axle * math.sin(theta), theta]
        twists = [PIONEER.twist(task.command_for(a)) for a in range(task.actions.n)]
        sensors = [names.index(variable.name) for variable in task.inputs]
        sectors = [variable.sectors or 0 for variable in task.inputs]
        front = [LASERS.index(name) for name in FRONT_LASERS]
        self._w = Fast(
            walls_of(arena), *Body.of(PIONEER), PIONEER.inset, PIONEER.axle, np.array(start), np.array(twists),
            np.array(sensors), cuts, np.array(sectors), bins, np.array(front), task.step_time, cell, memory,
            task.episode_steps or 0,
        )  # fmt: skip

    def learn_compiled(self, agent: rl.Agent, log: Transitions, episodes: int | None) -> Iterator[int]:
        """Run the loop compiled."""
        n, w = len(log.r), self._w
        room = np.empty(3), np.empty(len(w.walls), np.int64), np.empty(7), np.empty(len(LASERS) + 3)
        last = np.full((64, 64), -w.memory - 1) if w.memory else np.zeros((1, 1), np.int64)
        numbers = agent.rng.random(n + (episodes or 1))
        yield int(make_run(agent.method)(w, agent.memory, *room, last, numbers, log, episodes or 0))
