"""One repetition of an experiment, and all of them on all cores."""

from collections.abc import Callable, Iterator, Mapping
from copy import copy
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from joblib import Parallel, delayed

from rlrobot_edu.checks import check_name
from rlrobot_edu.environments import World, as_world, make_env
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.progress import Interrupted, progress_bar
from rlrobot_edu.learning.size import Env
from rlrobot_edu.task.task import Task

Key = tuple[str, int]  # of a repetition: the label of its method, and its number
Settings = Mapping[str, Any]  # parameters of an agent, its method included
Seed = np.random.SeedSequence
K = TypeVar("K")  # of a job: its key
T = TypeVar("T")  # and its result
SETTINGS = ("method", "planner", *Parameters.__annotations__)  # of an agent


def learner(env: Env, settings: Settings, seed: Seed | None = None) -> Agent:
    """A new agent for this environment. Raises ValueError for wrong settings."""
    if "seed" in settings:
        raise ValueError(
            "each repetition has a seed of its own; leave seed out of an agent's settings"
        )
    for name in settings:
        check_name(name, SETTINGS, "setting", "an agent")
    return Agent(env, **{**settings, "seed": seed})


def repetition(
    world: World, settings: Settings, length: Settings, seed: Seed, **robot: Any
) -> History:
    """Let a new agent of one method learn in a new environment.

    The history depends on `seed` and on nothing else that is random.

    length: how long it learns, `steps` and more for `learn`
    robot: its realism and engine, see `make_env`
    """
    # spawn() counts in the seed itself, and what a lost worker leaves behind is run
    # again: so the seed is copied first.
    agent_seed, env_seed = copy(seed).spawn(2)
    with make_env(world, env_seed, **robot) as env:
        agent = learner(env, settings, agent_seed)
        history = learn(agent, env, **length, progress=False)
    ended = len(history.returns)
    if ended < (length.get("episodes") or 0):
        raise ValueError(
            f"in {len(history):,} steps only {ended} episodes have ended; give more steps"
        )
    return history


def tried(world: World | str | Path, **robot: Any) -> tuple[World, Env, dict[str, Any]]:
    """The world itself, an environment of it, and the arguments of its robot.

    Raises ValueError for what `make_env` refuses: here, and not in another process.
    """
    world = as_world(world)
    env = make_env(world, **robot)
    env.close()
    engine = None
    if isinstance(world, Task):
        engine = getattr(env.unwrapped, "engine", None)
    return world, env, {**robot, "engine": engine}


def run(
    jobs: Mapping[Key, Callable[[], History]],
    *,
    threads: bool,
    n_jobs: int = -1,
    store: Store | None = None,
    bar: str | None = None,
    share: tuple[int, int] = (1, 1),
) -> dict[str, Runs]:
    """All repetitions by label: those in the store, and the others, which are run now.

    jobs: what each repetition does
    threads: whether they run in threads, as compiled loops do, and not in processes;
        ``with joblib.parallel_config(...)`` can choose another place
    bar: the text of a progress bar; None for no bar
    share: (k, n) runs, and returns, the k-th of n shares: each n-th repetition of all
    """
    first, stride = share
    keys = list(jobs)[first - 1 :: stride]
    done: dict[Key, History] = {}
    if store is not None:
        stored = {key: store.load(*key) for key in keys}
        done = {key: kept for key, kept in stored.items() if kept is not None}
    to_do = {key: jobs[key] for key in keys if key not in done}
    about = {"initial": len(done), "unit": "repetition", "desc": bar}
    with progress_bar(len(keys), bar is not None, delay=0, **about) as shown:
        try:
            for key, history in in_parallel(to_do, threads, n_jobs):
                if store is not None:
                    label, number = key
                    store.save(label, number, history)
                done[key] = history
                shown.update()
        except KeyboardInterrupt:
            fate = "lost: there is no store"
            if store is not None:
                fate = f"kept in {store.folder}: the same call goes on"
            raise Interrupted(
                f"Stopped at {len(done)} of {len(keys)} repetitions, {fate}."
            ) from None
    labels = dict.fromkeys(label for label, _ in jobs)
    return {
        label: Runs(done[key] for key in keys if key[0] == label) for label in labels
    }


def in_parallel(
    jobs: Mapping[K, Callable[[], T]], threads: bool, n_jobs: int
) -> Iterator[tuple[K, T]]:
    """Do all jobs on several cores; yield the key and the result of each as soon as it is done.

    threads: whether they run in threads, see `run`
    """
    parallel = Parallel(
        n_jobs,
        prefer="threads" if threads else "processes",
        return_as="generator_unordered",
    )
    yield from parallel(delayed(_one)(key, job) for key, job in jobs.items())


def _one(key: K, job: Callable[[], T]) -> tuple[K, T]:
    return key, job()
