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
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.task.task import Task
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
    """An agent and its world before the first step of a tape, as far as a page needs them.

    parameters: the agent's, as memory.py names them
    """

    def __init__(self, agent: Agent, env: gymnasium.Env) -> None:
        self._agent = agent
        self._env = env
        memory = agent.memory
        self.parameters = _numbers_of(memory.parameters, SETTINGS)
        self._memory = {
            "q": sparse(memory.q),
            "visits": sparse(memory.visits),
            "now": _numbers_of(memory.now, NOW),
            "parameters": self.parameters,
            "queue_states": memory.queue_states.tolist(),
            "queue_rewards": memory.queue_rewards.tolist(),
            "queue_count": memory.queue_count.tolist(),
        }
        self._random = {
            "agent": _random(agent.rng),
            "world": _random(env.unwrapped.np_random),
        }

    def script(self, tape: Tape) -> str:
        """A JavaScript expression for stepper.js: all that a replay needs, or the reason why there is none."""
        try:
            world, kernels = _world_of(self._env)
            program_text = program(kernels | self._kernels())
        except ValueError as error:
            reason = f"“What if α were another?” cannot be tried here: {error}"
            return json.dumps({"reason": reason}, ensure_ascii=False)
        q, visits = self._memory["q"], self._memory["visits"]
        data = {
            "world": world,
            "memory": self._memory,
            "random": self._random,
            "settings": self._settings(),
            "start": {"q": q, "visits": visits, "dropped": 0},
            "scene": tape.view.look_data(tape.first_look),
            "place": _place(self._env),
        }
        text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
        return f"{{...{text}, kernels: {program_text}}}"

    def _kernels(self) -> Kernels:
        agent = self._agent
        if agent.method.planner or None in self._random.values():
            raise ValueError(
                "a page knows no planner, and only NumPy's usual random numbers."
            )
        kernels: Kernels = {"begin_episode": begin_episode, "trace_steps": trace_steps}
        for i, algorithm in enumerate(algorithms_for(agent)):
            step = make_step(Method(algorithm, agent.method.selection))
            kernels[f"select_{i}"] = step.select
            kernels[f"learn_step_{i}"] = step.learn_step
        kernels["select"] = kernels["select_0"]
        kernels["learn_step"] = kernels["learn_step_0"]
        return kernels

    def _settings(self) -> list[str]:
        """The parameters that matter to the method."""
        method = self._agent.method
        names = ["alpha", "gamma"]
        if method.algorithm.has_traces:
            names.append("lam")
        if method.selection.is_softmax:
            names.append("temperature")
        elif method.selection.name not in ("RANDOM", "GREEDY"):
            names.append("epsilon")
        return names


def _numbers_of(record: Any, kind: np.dtype) -> dict[str, Any]:
    """The fields of a record as Python's numbers."""
    names = kind.names or ()
    return {name: np.asarray(getattr(record, name)).item() for name in names}


def _random(rng: np.random.Generator) -> dict[str, Any] | None:
    """The state of a generator in hex, for simulation.js; None if it is none of NumPy's usual ones."""
    state: Any = rng.bit_generator.state
    if state["bit_generator"] != "PCG64":
        return None
    return {
        "state": hex(state["state"]["state"]),
        "inc": hex(state["state"]["inc"]),
        "half": hex(state["uinteger"]) if state["has_uint32"] else None,
    }


def _world_of(env: gymnasium.Env) -> tuple[World, Kernels]:
    """What simulation.js needs of a world, and the kernels that move it.

    Raises ValueError for a world that simulation.js does not have.
    """
    kernels: Kernels
    if isinstance(env, SampleModelEnv):
        kernels = {"draw_outcome": draw_outcome, "draw_start": draw_start}
        return model_world(env.model, [], env.model.r_max), kernels
    if isinstance(env, RobotEnv):
        robot, task = env.robot, env.task
        inputs = {variable.name for variable in task.inputs}
        if isinstance(robot, CellRobot) and inputs <= INPUTS:
            return cells_world(task), {}
        if isinstance(robot, KinematicBase) and _is_ideal(robot, task):
            return base_world(task), {"drive": drive, "look": look, **rewards_of(task)}
    raise ValueError(
        "a page computes the worked example, sample models and the ideal base with engine='kinematic', not this world."
    )


def _is_ideal(robot: KinematicBase, task: Task) -> bool:
    """Whether it is the base as simulation.js has it."""
    return robot.chassis == CHASSIS[task.robot] and robot.realism == Realism()


def _place(env: gymnasium.Env) -> list[float] | None:
    """Where the robot starts: x, y [m] and heading [rad], as in simulation.js; None without a robot."""
    robot = getattr(env, "robot", None)
    if isinstance(robot, CellRobot):
        return [-0.5, -0.5, 0.0]
    if isinstance(robot, KinematicBase):
        return list(robot.arena.start)
    return None
