"""What a page needs to replay an agent's learning: kernels, and world and random numbers as they were at its start."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.memory import NOW, SETTINGS, trace_steps
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.step import begin_episode, make_step
from rlrobot_edu.models.model_env import SampleModelEnv
from rlrobot_edu.models.sampling import draw_outcome, draw_start
from rlrobot_edu.robots.cell_robot import CellRobot
from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase
from rlrobot_edu.robots.engines.kinematic.motion import drive, look
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.widgets.javascript.program import program, rewards_of
from rlrobot_edu.widgets.playground.worlds import (
    World,
    base_world,
    cells_world,
    model_world,
)
from rlrobot_edu.widgets.stepper.cell_values import INPUTS
from rlrobot_edu.widgets.stepper.page_data import algorithms_for, sparse
from rlrobot_edu.widgets.stepper.tape import Tape

Kernels = dict[str, Callable[..., Any]]


class ReplayStart:
    """What an agent and its world were before the first step of a tape, as far as a page needs it.

    parameters: the agent's, as memory.py names them
    """

    def __init__(self, agent: Agent, env: gymnasium.Env) -> None:
        self._agent, self._env, memory = agent, env, agent.memory
        self.parameters = {
            name: getattr(memory.parameters, name).item()
            for name in SETTINGS.names or ()
        }
        self._memory = {
            "q": sparse(memory.q), "visits": sparse(memory.visits),
            "now": {name: np.asarray(getattr(memory.now, name)).item() for name in NOW.names or ()},
            "parameters": self.parameters,
            **{name: getattr(memory, name).tolist() for name in ("queue_states", "queue_rewards", "queue_count")},
        }  # fmt: skip
        self._random = {
            "agent": _random(agent.rng),
            "world": _random(env.unwrapped.np_random),
        }

    def script(self, tape: Tape) -> str:
        """A JavaScript expression for stepper.js: all that a life needs, or the reason why there is none."""
        try:
            world, kernels = _world_of(self._env)
            program_text = program(kernels | self._kernels())
        except ValueError as error:
            return json.dumps(
                {"reason": f"“What if α were another?” cannot be tried here: {error}"},
                ensure_ascii=False,
            )
        told = {
            "world": world, "memory": self._memory, "random": self._random, "settings": self._settings(),
            "start": {"q": self._memory["q"], "visits": self._memory["visits"], "dropped": 0},
            "scene": tape.view.look_data(tape.first_look), "place": _place(self._env),
        }  # fmt: skip
        return f"{{...{json.dumps(told, ensure_ascii=False, separators=(',', ':'))}, kernels: {program_text}}}"

    def _kernels(self) -> Kernels:
        agent = self._agent
        if (
            agent.method.planner
            or agent.parameters.traces == "full"
            or None in self._random.values()
        ):
            raise ValueError(
                "a page knows no planner, no full traces, and only NumPy's usual random numbers."
            )
        kernels: Kernels = {
            kernel.__name__: kernel for kernel in (begin_episode, trace_steps)
        }
        for i, algorithm in enumerate(algorithms_for(agent)):
            step = make_step(Method(algorithm, agent.method.selection))
            kernels |= {f"select_{i}": step.select, f"learn_step_{i}": step.learn_step}
        return kernels | {
            "select": kernels["select_0"],
            "learn_step": kernels["learn_step_0"],
        }

    def _settings(self) -> list[str]:
        """The parameters that matter to the method."""
        method = self._agent.method
        chance = "temperature" if method.selection.is_softmax else "epsilon"
        acts = [chance] if method.selection.name not in ("RANDOM", "GREEDY") else []
        return ["alpha", "gamma", *["lam"] * method.algorithm.has_traces, *acts]


def _random(rng: np.random.Generator) -> dict[str, Any] | None:
    """The state of a generator in hex, for simulation.js; None if it is none of NumPy's usual ones."""
    state: Any = rng.bit_generator.state
    if state["bit_generator"] != "PCG64":
        return None
    numbers = {name: hex(state["state"][name]) for name in ("state", "inc")}
    return numbers | {"half": hex(state["uinteger"]) if state["has_uint32"] else None}


def _world_of(env: gymnasium.Env) -> tuple[World, Kernels]:
    """What simulation.js needs of a world, and the kernels by which it moves. Raises ValueError if it knows none."""
    if isinstance(env, SampleModelEnv):
        model = env.model
        return model_world(model, [], model.r_max), {
            "draw_outcome": draw_outcome,
            "draw_start": draw_start,
        }
    robot, task = getattr(env, "robot", None), getattr(env, "task", None)
    if (
        isinstance(env, RobotEnv)
        and isinstance(robot, CellRobot)
        and {v.name for v in task.inputs} <= INPUTS
    ):
        return cells_world(task), {}
    if (
        isinstance(env, RobotEnv)
        and isinstance(robot, KinematicBase)
        and robot.chassis == CHASSIS[task.robot]
    ):
        kernels = {"drive": drive, "look": look}
        return base_world(task), kernels | rewards_of(task)
    raise ValueError(
        "a page computes the worked example, sample models and the base with engine='kinematic', not this world."
    )


def _place(env: gymnasium.Env) -> list[float] | None:
    """Where the robot starts: x, y [m] and heading [rad], as simulation.js tells it; None without a robot."""
    robot = getattr(env, "robot", None)
    if isinstance(robot, CellRobot):
        return [-0.5, -0.5, 0.0]
    return list(robot.arena.start) if isinstance(robot, KinematicBase) else None
