"""Run the same learning process many times over, each with random numbers of its own, on all cores."""

import functools
import multiprocessing
import os
import threading
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from joblib import Parallel, delayed

from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.progress import progress_bar
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot_env import default_engine
from rlrobot_edu.task.messages import check_count, known
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task

# Steps that are worth the trip to another core; about 0.2 s each.
BATCH_STEPS = {True: 200_000, False: 2_000}  # of a model, of a robot

Batch = dict[tuple[str, int], History]  # finished repetitions by label and number


@dataclass(frozen=True)
class Job:
    """Repetitions of one method, and what one core does of them in one go.

    label: whose repetitions they are
    world, settings: of each agent, method included; length: how long it learns, `steps` and more for `learn`
    seeds: one for each repetition; first: number of the first one
    realism, engine: of the robot
    """

    label: str
    world: Task | SampleModel
    settings: Mapping[str, Any]
    length: Mapping[str, Any]
    seeds: Sequence[np.random.SeedSequence]
    first: int = 0
    realism: Realism | None = None
    engine: str | None = None

    def agent(self, seed: np.random.SeedSequence | None = None) -> Agent:
        """A new agent. Raises ValueError for wrong settings: better here than on another core."""
        if "seed" in self.settings:
            raise ValueError("each repetition has a seed of its own; leave seed out of an agent's settings")
        for name in self.settings:
            known(name, ["method", *Parameters.__annotations__], "setting", "an agent")
        return Agent(self.world, **{**self.settings, "seed": seed})

    def run(self) -> Batch:
        """The repetitions, one after the other."""
        if multiprocessing.current_process().name.startswith("LokyProcess"):
            _end_with_parent()
        return {(self.label, i): self._once(seed) for i, seed in enumerate(self.seeds, self.first)}

    def _once(self, seed: np.random.SeedSequence) -> History:
        # A copy, because spawn() counts in the seed itself, and a job that a lost worker leaves behind is run again.
        agent_seed, env_seed = copy(seed).spawn(2)
        with make_env(self.world, env_seed, engine=self.engine, realism=self.realism) as env:
            history = learn(self.agent(agent_seed), env, **self.length, progress=False)
        return history

    def batches(self, missing: Sequence[int]) -> "Iterator[Job]":
        """The job in pieces, for the repetitions `missing` (increasing): large enough for a core to be worth it."""
        size = BATCH_STEPS[isinstance(self.world, SampleModel)] // max(self.length["steps"], 1)
        size = max(1, min(size, -(-len(missing) // 8)))
        for group in np.split(missing, np.flatnonzero(np.diff(missing) > 1) + 1):
            for numbers in np.split(group, range(size, len(group), size)):
                yield replace(self, first=int(numbers[0]), seeds=self.seeds[numbers[0] : numbers[-1] + 1])


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


def engine_of(world: Task | SampleModel, engine: str | None = None, realism: Realism | None = None) -> str | None:
    """Who is to simulate the robot, if there is one. What `make_env` refuses is said here and not on another core."""
    if engine is not None or realism is not None:  # the default needs no trial, and a trial starts a simulator
        make_env(world, engine=engine, realism=realism).close()
    return engine or (None if isinstance(world, SampleModel) else default_engine(world))


def run_all(jobs: Iterable[Job], world: Task | SampleModel, n_jobs: int) -> Iterator[Batch]:
    """What comes of each job, in the order in which they get done.

    Models run in threads, because their compiled loop lets other threads work; robots run in processes. Inside
    ``with joblib.parallel_config(...)`` they run wherever that says.
    """
    prefer = "threads" if isinstance(world, SampleModel) else "processes"
    parallel = Parallel(n_jobs=n_jobs, prefer=prefer, batch_size=1, return_as="generator_unordered")
    done: Iterator[Batch] = parallel(delayed(Job.run)(job) for job in jobs)
    return done


def repeat(
    world: Task | str | Path | SampleModel,
    method: str | Method = "TOSL+QBIASSR",
    *,
    repetitions: int,
    steps: int,
    seed: int = 0,
    n_jobs: int = -1,
    engine: str | None = None,
    progress: bool = True,
    **settings: Any,
) -> Runs:
    """Let `repetitions` new agents of one method learn, each with random numbers of its own.

    Parameters
    ----------
    world : Task, str, Path or SampleModel
        A task, its name or the path of your own; or a sample model.
    method : str or Method
        See `Agent`.
    repetitions, steps : int
        How many agents, and how many steps each.
    seed : int
        Each repetition takes its seeds from ``SeedSequence(seed).spawn``, so the result depends on it alone.
    n_jobs : int
        Cores to use, -1 for all.
    engine : str, optional
        Who simulates the robot, see `make_env`.
    progress : bool
        Show a progress bar.
    **settings
        Further parameters of `Agent`, such as ``temperature=2``.

    Returns
    -------
    Runs
        The histories, in order.
    """
    world = as_world(world)
    check_count("seed", seed, least=0)
    check_count("repetitions", repetitions)
    check_count("steps", steps, least=0)
    seeds = np.random.SeedSequence(seed).spawn(repetitions)
    job = Job("", world, {"method": method, **settings}, {"steps": steps}, seeds, engine=engine_of(world, engine))
    name = job.agent().method
    done: Batch = {}
    with progress_bar(repetitions, progress, delay=0, unit="repetition", desc=name) as bar:
        for batch in run_all(job.batches(range(repetitions)), world, n_jobs):
            done |= batch
            bar.update(len(batch))
    return Runs(done[key] for key in sorted(done))
