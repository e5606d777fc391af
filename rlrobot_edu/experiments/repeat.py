"""Run the same learning process many times over, each with random numbers of its own, on all cores."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from joblib import Parallel, delayed

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task import Task, load_task
from rlrobot_edu.worlds import make_env


def repeat(
    world: Task | str | Path | SampleModel,
    method: str = "TOSL+QBIASSR",
    *,
    repetitions: int,
    steps: int,
    seed: int = 0,
    n_jobs: int = -1,
    **settings,
) -> list[History]:
    """Let `repetitions` new agents learn for `steps` steps each; returns their histories, in order.

    world: a Task (or its name or path), or a SampleModel; method: see `Agent`
    settings: further parameters of `Agent`, such as ``temperature=2``
    Each repetition takes its seeds from ``SeedSequence(seed).spawn``, so that the result depends on `seed` alone and
    not on `n_jobs` (-1: all cores). Models run in threads, because their compiled loop lets other threads work;
    robots run in processes.
    """
    if not isinstance(world, SampleModel | Task | str | Path):
        raise ValueError(f"repeat takes a task (or its name) or a SampleModel, not a {type(world).__name__}")
    if not isinstance(world, SampleModel):
        world = load_task(world)
    prefer = "threads" if isinstance(world, SampleModel) else "processes"
    seeds = np.random.SeedSequence(seed).spawn(repetitions)
    once = delayed(_one_repetition)
    return Parallel(n_jobs=n_jobs, prefer=prefer)(once(world, method, steps, s, settings) for s in seeds)


def _one_repetition(world, method: str, steps: int, seed: np.random.SeedSequence, settings: dict) -> History:
    agent_seed, env_seed = seed.spawn(2)
    agent = Agent(world, method, seed=agent_seed, **settings)
    return learn(agent, make_env(world, env_seed), steps, progress=False)
