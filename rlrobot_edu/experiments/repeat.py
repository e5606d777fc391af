"""Run the same learning process many times over, each with random numbers of its own, on all cores."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from joblib import Parallel, delayed

from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.runs import Run
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.size import Size
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task.task import Task, load_task

World = Task | SampleModel

# Steps that are worth the trip to another core; about 0.2 s each.
BATCH_STEPS = {True: 200_000, False: 2_000}  # of a model, of a robot


class Job(NamedTuple):
    """What one core does in one go: repetitions of one method.

    world, method, settings: of each agent; steps, episodes, keep: as in `learn`
    label, first: whose repetitions they are, and the number of the first; seeds: one for each
    """

    world: World
    method: str
    settings: dict
    steps: int
    episodes: int | None
    keep: bool
    label: str
    first: int
    seeds: Sequence[np.random.SeedSequence]

    def run(self) -> list[Run]:
        """The repetitions, one after the other."""
        return [self._once(seed) for seed in self.seeds]

    def _once(self, seed: np.random.SeedSequence) -> Run:
        # Not seed.spawn(): that counts in `seed` itself, and a job that a lost worker leaves behind is run again.
        agent_seed, env_seed = (
            np.random.SeedSequence(seed.entropy, spawn_key=(*seed.spawn_key, i), pool_size=seed.pool_size)
            for i in range(2)
        )
        agent = Agent(self.world, self.method, seed=agent_seed, **self.settings)
        env = make_env(self.world, env_seed)
        try:
            return Run.of(learn(agent, env, self.steps, episodes=self.episodes, keep=self.keep, progress=False))
        finally:
            env.close()


def as_world(world: Task | str | Path | SampleModel) -> World:
    """The task or model itself. Raises ValueError if it is neither, nor the name or path of a task."""
    if not isinstance(world, SampleModel | Task | str | Path):
        raise ValueError(f"this takes a task (or its name) or a SampleModel, not a {type(world).__name__}")
    return world if isinstance(world, SampleModel) else load_task(world)


def batches(job: Job, missing: Sequence[int]) -> Iterator[Job]:
    """`job` in pieces, for the repetitions `missing` (increasing) of it: large enough for a core to be worth it."""
    size = BATCH_STEPS[isinstance(job.world, SampleModel)] // max(job.steps, 1)
    size = max(1, min(size, -(-len(missing) // 8)))
    for group in np.split(missing, np.flatnonzero(np.diff(missing) > 1) + 1):
        for i in range(0, len(group), size):
            first, last = int(group[i]), int(group[min(i + size, len(group)) - 1])
            yield job._replace(first=first, seeds=job.seeds[first : last + 1])


def run_all(jobs: Iterable[Job], world: World, n_jobs: int) -> Iterator[tuple[Job, list[Run]]]:
    """Each job and its runs, in the order in which they get done.

    Models run in threads, because their compiled loop lets other threads work; robots run in processes. Inside
    ``with joblib.parallel_config(...)`` they run wherever that says.
    """
    prefer = "threads" if isinstance(world, SampleModel) else "processes"
    parallel = Parallel(n_jobs=n_jobs, prefer=prefer, batch_size=1, return_as="generator_unordered")
    return parallel(delayed(_run)(job) for job in jobs)


def _run(job: Job) -> tuple[Job, list[Run]]:
    return job._replace(world=None, seeds=()), job.run()  # the way back is not for what is known there


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
    not on `n_jobs` (-1: all cores).
    """
    world = as_world(world)
    Agent(world, method, **settings)  # a wrong setting is named here, not in another process
    seeds = np.random.SeedSequence(seed).spawn(repetitions)
    job = Job(world, method, settings, steps, None, False, method, 0, seeds)
    done = {}
    for part, runs in run_all(batches(job, range(repetitions)), world, n_jobs):
        done[part.first] = runs
    size = Size.of(world)
    return [run.history(method, size) for first in sorted(done) for run in done[first]]
