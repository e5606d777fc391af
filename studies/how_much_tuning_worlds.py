"""The worlds, methods and settings of how_much_tuning.py, as tuning_registered.json has them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from better_bias_fast import FastBase
from better_bias_worlds import CELL, MEMORY, random_maze

import rlrobot_edu as rl
from rlrobot_edu.experiments.sweep import random_settings, sweep
from rlrobot_edu.robots.arenas import ARENAS

Plan = Mapping[str, Any]
REGISTERED: Plan = json.loads(
    (Path(__file__).parent / "tuning_registered.json").read_text(encoding="utf-8")
)
MAZES = [f"maze {number}" for number in range(10)]


def settings_of(plan: Plan) -> list[dict[str, float]]:
    """The settings, the same for all methods."""
    return random_settings(plan["sizes"]["settings"], plan["seeds"]["settings"])


def parameters(plan: Plan, method: str, setting: str) -> dict[str, Any]:
    """The parameters of an agent at a setting: its number, ``paper`` or ``random``, which acts at random."""
    if setting == "random":
        return {"method": "Q+RANDOM"}
    if setting == "paper":
        return {"method": method, **plan["paper's setting"]}
    return {"method": method, **settings_of(plan)[int(setting)]}


def new_ground() -> gymnasium.Env[Any, Any]:
    """wander_4k where only new ground pays, compiled."""
    task = rl.load_task("wander_4k")
    return FastBase(task, ARENAS[task.scene], CELL, MEMORY)


def in_maze(number: int) -> gymnasium.Env[Any, Any]:
    """wander_1k in a random maze."""
    env = rl.make_env("wander_1k", engine="kinematic")
    env.unwrapped.robot.arena = random_maze(number)
    env.unwrapped.robot.reset()  # builds its walls
    return env


def world_of(name: str) -> tuple[Any, dict[str, Any]]:
    """What `sweep` takes as a world, and its engine and realism."""
    if name == "new ground":
        return new_ground, {}
    if name in MAZES:
        return partial(in_maze, MAZES.index(name)), {}
    if name == "friction":
        return "wander_1k", {"engine": "pymunk", "realism": rl.Realism.vrep()}
    task, _, engine = name.partition(", ")
    return task, {"engine": engine.lower() or "kinematic"}


def scores(
    plan: Plan,
    world: str,
    method: str,
    settings: list[str],
    robots: int,
    stage: str,
    n_jobs: int,
) -> np.ndarray:
    """Final average rewards, array (settings, robots); `stage` chooses the robots' seed."""
    steps, episodes = plan["lengths"]["maze" if world in MAZES else world]
    made, robot = world_of(world)
    rows = [parameters(plan, method, setting) for setting in settings]
    result = sweep(
        made, rows, robots, steps=steps, episodes=episodes, seed=plan["seeds"][stage],
        n_jobs=n_jobs, progress=False, **robot,
    )  # fmt: skip
    return result.scores
