"""Run the same learning process many times over, each with random numbers of its own, on all cores."""

import dataclasses
import functools
import multiprocessing
import os
import threading
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from joblib import Parallel, delayed

from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.seeds import check_number
from rlrobot_edu.task.messages import counts
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task

# Steps that are worth the trip to another core; about 0.2 s each.
BATCH_STEPS = {True: 200_000, False: 2_000}  # of a model, of a robot


@dataclass(frozen=True)
class Job:
    """Repetitions of one method, and what one core does of them in one go.

    label: whose repetitions they are
    world, method, parameters: of each agent; steps, episodes, keep: as in `learn`
    seeds: one for each repetition; first: number of the first one
    """

    label: str
    world: Task | SampleModel
    method: str
    parameters: Parameters
    steps: int
    seeds: Sequence[np.random.SeedSequence]
    episodes: int | None = None
    keep: bool = False
    first: int = 0

    @classmethod
    def of(cls, label: str, world: Task | SampleModel, settings: dict[str, Any], **length: Any) -> "Job":
        """The job of agents with these settings, method included. A wrong one is named here, not on another core."""
        agent = Agent(world, **settings)
        return cls(label, world, agent.method, agent.parameters, **length)

    def run(self) -> tuple[str, int, list[History]]:
        """The repetitions, one after the other: label, number of the first, and their histories."""
        if multiprocessing.current_process().name.startswith("LokyProcess"):
            _end_with_parent()
        return self.label, self.first, [self._once(seed) for seed in self.seeds]

    def _once(self, seed: np.random.SeedSequence) -> History:
        # Not seed.spawn(): that counts in `seed` itself, and a job that a lost worker leaves behind is run again.
        agent_seed, env_seed = (
            np.random.SeedSequence(seed.entropy, spawn_key=(*seed.spawn_key, i), pool_size=seed.pool_size)
            for i in range(2)
        )
        agent = Agent(self.world, self.method, seed=agent_seed, **dataclasses.asdict(self.parameters))
        env = make_env(self.world, env_seed)
        try:
            return learn(agent, env, self.steps, episodes=self.episodes, keep=self.keep, progress=False)
        finally:
            env.close()

    def batches(self, missing: Sequence[int]) -> "Iterator[Job]":
        """The job in pieces, for the repetitions `missing` (increasing): large enough for a core to be worth it."""
        size = BATCH_STEPS[isinstance(self.world, SampleModel)] // max(self.steps, 1)
        size = max(1, min(size, -(-len(missing) // 8)))
        for group in np.split(missing, np.flatnonzero(np.diff(missing) > 1) + 1):
            for i in range(0, len(group), size):
                first, last = int(group[i]), int(group[min(i + size, len(group)) - 1])
                yield dataclasses.replace(self, first=first, seeds=self.seeds[first : last + 1])


@functools.cache
def _end_with_parent() -> None:
    """Let this worker process end as soon as the one that started it is gone; loky's would work on and then wait."""
    parent = os.getppid()

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(1)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def as_world(world: Task | str | Path | SampleModel) -> Task | SampleModel:
    """The task or model itself. Raises ValueError if it is neither, nor the name or path of a task."""
    if not isinstance(world, SampleModel | Task | str | Path):
        raise ValueError(f"this takes a task (or its name) or a SampleModel, not a {type(world).__name__}")
    return world if isinstance(world, SampleModel) else load_task(world)


def run_all(jobs: Iterable[Job], world: Task | SampleModel, n_jobs: int) -> Iterator[tuple[str, int, list[History]]]:
    """Label, number of the first repetition and histories of each job, in the order in which they get done.

    Models run in threads, because their compiled loop lets other threads work; robots run in processes. Inside
    ``with joblib.parallel_config(...)`` they run wherever that says.
    """
    prefer = "threads" if isinstance(world, SampleModel) else "processes"
    parallel = Parallel(n_jobs=n_jobs, prefer=prefer, batch_size=1, return_as="generator_unordered")
    done: Iterator[tuple[str, int, list[History]]] = parallel(delayed(Job.run)(job) for job in jobs)
    return done


def repeat(
    world: Task | str | Path | SampleModel,
    method: str = "TOSL+QBIASSR",
    *,
    repetitions: int,
    steps: int,
    seed: int = 0,
    n_jobs: int = -1,
    **settings: Any,
) -> Runs:
    """Let `repetitions` new agents of one method learn, each with random numbers of its own.

    Parameters
    ----------
    world : Task, str, Path or SampleModel
        A task, its name or the path of your own; or a sample model.
    method : str
        See `Agent`.
    repetitions, steps : int
        How many agents, and how many steps each.
    seed : int
        Each repetition takes its seeds from ``SeedSequence(seed).spawn``, so the result depends on it alone.
    n_jobs : int
        Cores to use, -1 for all.
    **settings
        Further parameters of `Agent`, such as ``temperature=2``.

    Returns
    -------
    Runs
        The histories, in order.
    """
    world = as_world(world)
    check_number(seed)
    if not counts(repetitions, least=0):
        raise ValueError(f"repetitions must be a whole number of at least 0, got {repetitions!r:.200}")
    seeds = np.random.SeedSequence(seed).spawn(repetitions)
    job = Job.of(method, world, {"method": method, **settings}, steps=steps, seeds=seeds)
    done = {first: histories for _, first, histories in run_all(job.batches(range(repetitions)), world, n_jobs)}
    return Runs([history for first in sorted(done) for history in done[first]])
