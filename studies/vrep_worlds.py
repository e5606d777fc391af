"""The worlds that studies/vrep_comparison.py compares with V-REP's: robots and mazes, as found and as they are
now, and what is done in them."""

from __future__ import annotations

import math
from typing import NamedTuple
from unittest.mock import patch

import numpy as np

import rlrobot_edu as rl
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.robots.arenas import ARENAS, Arena, Wall
from rlrobot_edu.robots.chassis import PIONEER, Chassis
from rlrobot_edu.robots.robot_env import RobotEnv

TASK, SCENE = "wander_1k", "maze_6x6"
STEPS = 18_000
Rows = Transitions | rl.Recording

# What we had before we knew the paper's scene: a disc with its lasers on a ring, in a maze drawn after the figure.
_TURN = math.pi / 2
_RING = tuple(
    (0.22 * math.cos(angle), 0.22 * math.sin(angle), angle)
    for angle in np.arange(8) * math.pi / 4
)
DISC = PIONEER._replace(
    wheel_separation=0.33, axle=0.0, lasers=_RING, inset=0.22, hull=(), radius=0.267
)
DRAWN = Arena(
    tuple(
        Wall(x, y, length, thickness, angle)
        for x, y, length, thickness, angle in [
            *(
                (0, -3.05, 6.2, 0.1, 0),
                (3.05, 0, 6.2, 0.1, _TURN),
                (0, 3.05, 6.2, 0.1, 0),
                (-3.05, 0, 6.2, 0.1, _TURN),
            ),
            *(
                (2.45, 1.7, 1.1, 0.1, 0),
                (1.95, 2.8, 0.4, 0.1, _TURN),
                (-1.7, 2.45, 1.1, 0.1, _TURN),
            ),
            *(
                (-2.8, 1.95, 0.4, 0.1, 0),
                (-2.45, -1.7, 1.1, 0.1, 0),
                (-1.95, -2.8, 0.4, 0.1, _TURN),
            ),
            *(
                (1.7, -2.45, 1.1, 0.1, _TURN),
                (2.8, -1.95, 0.4, 0.1, 0),
                (1.55, 0.7, 0.8, 0.05, math.radians(75)),
            ),
            *(
                (0.1, 1.6, 0.8, 0.05, math.radians(15)),
                (-1.45, 0.85, 0.8, 0.05, math.radians(45)),
            ),
            *(
                (-0.95, -1.35, 0.8, 0.05, math.radians(135)),
                (1, -1.3, 0.8, 0.05, 0),
                (-2.6, -0.2, 0.8, 0.1, 0),
            ),
        ]
    ),
    (-3, -3, 3, 3),
    (0.0, 0.0, 0.0),
)


class World(NamedTuple):
    """A robot, its maze, how far it is from ideal and who simulates it."""

    maze: Arena = ARENAS[SCENE]
    chassis: Chassis = PIONEER
    realism: rl.Realism = rl.Realism()
    engine: str = "pymunk"


FOUND, NOW, PRESET = World(DRAWN, DISC), World(), World(realism=rl.Realism.vrep())
WORLDS = {
    "as found: a disc in a maze drawn after the figure": FOUND,
    "the scene's maze alone": World(chassis=DISC),
    "the scene's laser places alone": World(
        DRAWN, DISC._replace(lasers=PIONEER.lasers)
    ),
    "the scene's robot alone: hull, axle, lasers": World(DRAWN),
    "**maze and robot: the default now**": NOW,
    "and a lag of 0.1 s": World(realism=rl.Realism(lag=0.1)),
    "and friction of 0.72 instead": World(realism=rl.Realism(wall_friction=0.72)),
    "**and both: `Realism.vrep()`**": PRESET,
    'the default\'s maze and robot without a physics engine: `engine="kinematic"`': World(
        engine="kinematic"
    ),
}


def environment(world: World, seed: int) -> RobotEnv:
    """The task in this world, its robot built."""
    with patch.dict(
        ARENAS, {SCENE: world.maze}
    ):  # the robot keeps the one that it was built in
        env = rl.make_env(
            TASK,
            seed=seed,
            engine=world.engine,
            chassis=world.chassis,
            realism=world.realism,
        )
        env.reset()
    return env


def learning(world: World, seed: int, steps: int = STEPS) -> np.ndarray:
    """Rewards of an agent that learns with TOSL+SR, as V-REP's did; array (steps,)."""
    return rl.learn(
        rl.Agent(TASK, "TOSL+SR", seed=seed),
        environment(world, seed),
        steps,
        progress=False,
    ).rewards


def same_choices(
    world: World, seed: int, model: Rows, steps: int = STEPS
) -> Transitions:
    """What our robot lives through when it chooses, in each state, as often as `model` what was chosen there.

    Each pair (s, a) has 0.3 visits on top, so that the robot is at no loss in states that `model` does not know.
    """
    env, rng = environment(world, seed), np.random.default_rng(seed)
    chosen = np.full((env.task.states.n, env.task.actions.n), 0.3)
    np.add.at(chosen, (model.s, model.a), 1)
    up_to = np.cumsum(chosen / chosen.sum(axis=1, keepdims=True), axis=1)
    s, rows = env.state, Transitions.empty(steps)
    for t in range(steps):
        a = min(
            int(np.searchsorted(up_to[s], rng.random(), side="right")),
            env.task.actions.n - 1,
        )
        _, r, _, _, info = env.step(a)
        rows.s[t], rows.a[t], rows.r[t], rows.s_next[t] = s, a, r, info["state"]
        s = info["state"]
    return rows
