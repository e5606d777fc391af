"""The worlds of better_bias.py: tasks in which no circle pays, changed in one thing at a time."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, NamedTuple

import gymnasium
import numpy as np
from better_bias_fast import FastBase
from blind_study import nine_actions, straight_ahead

import rlrobot_edu as rl
from rlrobot_edu.robots.arenas import ARENAS, Arena, Wall

CELL, MEMORY = (
    0.25,
    300,
)  # of new ground: side of a cell [m], and for how long the robot has been there [steps]
INNER_WALLS, CLEAR = (
    10,
    0.6,
)  # of a random maze: panels of 1 m, none nearer to the start than this [m]


class World(NamedTuple):
    """Where an agent learns, and for how long.

    task, settings: what the agent gets; engine, realism: of the robot; episodes: of an episodic task
    new_ground: whether only ground where the robot has not been lately pays; maze: a random one's number
    """

    task: rl.Task
    steps: int = 3600
    engine: str = "kinematic"
    episodes: int | None = None
    realism: rl.Realism | None = None
    settings: dict[str, Any] = {}  # noqa: RUF012 - never changed
    algorithm: str = "TOSL"
    new_ground: bool = False
    maze: int | None = None

    def env(self, seed: np.random.SeedSequence) -> gymnasium.Env:
        """The environment; for new ground one that runs the loop of learning compiled, which gives the same numbers."""
        if self.new_ground and self.is_fast:
            arena = (
                ARENAS[self.task.scene] if self.maze is None else random_maze(self.maze)
            )
            return FastBase(self.task, arena, CELL, MEMORY)
        return self.plain_env(seed)

    @property
    def is_fast(self) -> bool:
        """Whether its loop is compiled: wander_1k, 4k and 12k, changed or not, and navigation_1k without an engine."""
        return self.engine == "kinematic" and self.task.scene.startswith("maze")

    def plain_env(self, seed: np.random.SeedSequence) -> gymnasium.Env:
        """The environment of the toolkit."""
        env = rl.make_env(self.task, seed, engine=self.engine, realism=self.realism)
        if self.maze is not None:
            env.robot.arena = random_maze(self.maze)
            env.robot.reset()  # builds its walls
        return NewGround(env) if self.new_ground else env


class NewGround(gymnasium.Wrapper):
    """Collisions cost what they cost; of the other steps those pay 10 that end where the robot has not been lately.

    That is in a cell of 0.25 m in which it was not in the last 300 steps; others cost 0.02. So no circle pays.
    """

    def reset(self, **given: Any) -> tuple[np.ndarray, dict[str, Any]]:
        """Begin; nothing has been seen."""
        observation, info = self.env.reset(**given)
        self._last: dict[tuple[int, int], int] = {}
        self._now = 0
        self._new(info["readings"])
        return observation, info

    def _new(self, readings: dict[str, float]) -> bool:
        """Whether this is new ground; from now on it is not."""
        cell = int(np.floor(readings["x"] / CELL)), int(np.floor(readings["y"] / CELL))
        is_new = self._now - self._last.get(cell, -MEMORY - 1) > MEMORY
        self._last[cell] = self._now
        return is_new

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """One step of the robot."""
        observation, reward, terminated, truncated, info = self.env.step(action)
        self._now += 1
        is_new = self._new(info["readings"])
        if reward > -1:
            reward = 10.0 if is_new else -0.02
        return observation, reward, terminated, truncated, info


def random_maze(number: int) -> Arena:
    """The authors' outer walls with ten panels anywhere inside, from the maze's number alone."""
    rng = np.random.default_rng(np.random.SeedSequence(32, spawn_key=(number,)))
    its = ARENAS["maze_6x6"]
    walls = list(its.walls[:4])
    while len(walls) < 4 + INNER_WALLS:
        x, y = rng.uniform(-2.6, 2.6, 2)
        wall = Wall(float(x), float(y), 1.0, angle=float(rng.choice(12)) * np.pi / 12)
        along = np.array([np.cos(wall.angle), np.sin(wall.angle)])
        nearest = np.array([x, y]) - along * np.clip(along @ [x, y], -0.5, 0.5)
        if np.hypot(*nearest) > CLEAR:
            walls.append(wall)
    return its._replace(walls=tuple(walls))


def coarse(task: rl.Task) -> rl.Task:
    """The task with two bins a laser, the lowest and the rest; of other inputs two bins become one."""

    def cut(variable: rl.InputVariable) -> rl.InputVariable:
        if variable.sectors:
            return dataclasses.replace(variable, sectors=variable.sectors // 2)
        which = slice(1) if "laser" in variable.name else slice(1, None, 2)
        return dataclasses.replace(variable, cuts=variable.cuts[which])

    return dataclasses.replace(task, inputs=[cut(variable) for variable in task.inputs])


def larger(task: rl.Task) -> rl.Task:
    """wander_12k with one more laser of four bins, rear left: 50,000 states."""
    cuts = list(task.inputs[-1].cuts)
    return dataclasses.replace(
        task,
        inputs=[*task.inputs, rl.InputVariable("laser_rear_left", cuts=cuts, unit="m")],
    )


@functools.cache
def worlds() -> dict[str, World]:
    """All of them by name."""
    one, four, twelve = (rl.load_task(f"wander_{size}") for size in ("1k", "4k", "12k"))
    authors = dataclasses.replace(four, command=straight_ahead)
    found = {
        "wander_1k": World(one),
        "wander_4k, nine actions": World(nine_actions(four)),
        "wander_4k, new ground": World(four, new_ground=True),
        "wander_1k, vrep": World(one, engine="pymunk", realism=rl.Realism.vrep()),
        "giraff_wander_1k": World(rl.load_task("giraff_wander_1k"), 1800, "pymunk"),
        "navigation_1k": World(rl.load_task("navigation_1k"), 7200, episodes=2),
        "arm_1k": World(rl.load_task("arm_1k"), 1200, episodes=10),
        "arm_4k": World(rl.load_task("arm_4k"), 1200, episodes=10),
        "wander_simple": World(rl.load_task("wander_simple"), 300),
        "giraff_wander_simple": World(
            rl.load_task("giraff_wander_simple"), 300, "pymunk"
        ),
        "giraff_wander_4k": World(rl.load_task("giraff_wander_4k"), 1800, "pymunk"),
        "wander_12k, nine actions": World(nine_actions(twelve)),
        "50,000 states, nine actions": World(nine_actions(larger(twelve))),
        "wander_1k, new ground": World(one, new_ground=True),
        "wander_4k, their wheels": World(authors),
        "wander_12k, their wheels": World(
            dataclasses.replace(twelve, command=straight_ahead)
        ),
        "wander_4k": World(four),
        "wander_12k": World(twelve),
    }
    found |= {
        f"wander_1k, α = {alpha}": World(one, settings={"alpha": alpha})
        for alpha in (0.05, 0.2, 0.5)
    }
    found |= {
        f"wander_1k, {name}": World(one, algorithm=name)
        for name in ("Q", "SARSA", "ESARSA", "SL")
    }
    return found | {f"maze {number}": World(one, maze=number) for number in range(10)}
