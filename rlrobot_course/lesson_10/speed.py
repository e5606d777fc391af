"""How long a step takes, of a learner that was written in a notebook and of an agent of the library."""

import time
from collections.abc import Callable

import numpy as np

from rlrobot_course.worlds.tapes import RobotWorld
from rlrobot_edu import Agent, Method, SampleModel, learn, make_env, read_recording

LEARNER_STEPS, METHOD_STEPS = 1000, 20_000
SETTINGS = {"alpha": 0.1, "gamma": 0.9, "lam": 0.9, "temperature": 1.0}


def of_learner(learner: Callable[..., np.ndarray]) -> float:
    """Microseconds a step of a `learn` as lesson 10 asks for it, with the robot of wander_1k."""
    world = RobotWorld("wander_1k", seed=0)
    start = time.perf_counter()
    learner(
        world,
        world.shape,
        world.n_actions,
        world.r_max,
        LEARNER_STEPS,
        np.random.default_rng(0),
        **SETTINGS,
    )
    return (time.perf_counter() - start) / LEARNER_STEPS * 1e6


def of_method(method: str | Method, traces: str) -> float:
    """Microseconds a step of an agent in the sample model of wander_1k, once its kernels are compiled."""
    maze = SampleModel.from_recording(read_recording("wander_1k"))
    agent, env = (
        Agent(maze, method, traces=traces, loop_evasion=False, seed=0, **SETTINGS),
        make_env(maze, seed=0),
    )
    learn(agent, env, steps=10, progress=False)
    start = time.perf_counter()
    learn(agent, env, steps=METHOD_STEPS, progress=False)
    return (time.perf_counter() - start) / METHOD_STEPS * 1e6
