"""Run the same learning process many times over, each with random numbers of its own, on all cores."""

from collections.abc import Callable, Mapping
from copy import copy
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from joblib import delayed

from rlrobot_edu.checks import check_count, check_name
from rlrobot_edu.environments import World, as_world, make_env
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.experiments.workers import workers
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.methods import Method
from rlrobot_edu.learning.parameters import Parameters
from rlrobot_edu.learning.progress import Interrupted, progress_bar
from rlrobot_edu.learning.size import Env
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task.robot_cards import Engine
from rlrobot_edu.task.task import Task

Key = tuple[str, int]  # of a repetition: whose it is, and its number
Settings = Mapping[str, Any]  # parameters of an agent, its method included
Seed = np.random.SeedSequence


def learner(env: Env, settings: Settings, seed: Seed | None = None) -> Agent:
    """A new agent for this environment. Raises ValueError for wrong settings."""
    if "seed" in settings:
        raise ValueError(
            "each repetition has a seed of its own; leave seed out of an agent's settings"
        )
    for name in settings:
        check_name(
            name,
            ["method", "planner", *Parameters.__annotations__],
            "setting",
            "an agent",
        )
    return Agent(env, **{**settings, "seed": seed})


def repetition(
    world: World, settings: Settings, length: Settings, seed: Seed, **robot: Any
) -> History:
    """What a repetition of one method does: a function of its seed, and of nothing else.

    length: how long it learns, `steps` and more for `learn`; robot: its realism and engine
    """
    # A copy, because spawn() counts in the seed itself, and what a lost worker leaves behind is run again.
    agent_seed, env_seed = copy(seed).spawn(2)
    with make_env(world, env_seed, **robot) as env:
        history = learn(
            learner(env, settings, agent_seed), env, **length, progress=False
        )
    if (ended := len(history.returns)) < (length.get("episodes") or 0):
        raise ValueError(
            f"in {len(history):,} steps only {ended} episodes have ended; give more steps"
        )
    return history


def tried(
    world: World | str | Path, seed: int, repetitions: int, **robot: Any
) -> tuple[World, Env, Any]:
    """The world itself, an environment of it to look at, and the arguments of its robot, engine included.

    Raises ValueError for what cannot be: what `make_env` refuses is said here, not on another core.
    """
    world = as_world(world)
    check_count("seed", seed, least=0)
    check_count("repetitions", repetitions)
    env = make_env(world, **robot)
    env.close()
    engine = getattr(env.unwrapped, "engine", None) if isinstance(world, Task) else None
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
    """All repetitions by label: those in the store, and the others, run now.

    jobs: what each repetition does
    threads: whether they are to run in threads, as compiled loops do, and not in processes; inside
        ``with joblib.parallel_config(...)`` they run wherever that says
    bar: what a progress bar says; None for no bar
    share: (k, n) runs, and returns, the k-th of n shares: each n-th repetition of all
    """
    keys = list(jobs)[share[0] - 1 :: share[1]]
    done = {
        key: history
        for key in keys
        if store and (history := store.load(*key)) is not None
    }
    to_do = (delayed(_one)(key, jobs[key]) for key in keys if key not in done)
    parallel = workers(
        n_jobs,
        prefer="threads" if threads else "processes",
        return_as="generator_unordered",
    )
    about = {"initial": len(done), "unit": "repetition", "desc": bar}
    with progress_bar(len(keys), bar is not None, delay=0, **about) as shown:
        try:
            for key, history in parallel(to_do):
                if store:
                    store.save(key[0], key[1], history)
                done[key] = history
                shown.update()
        except KeyboardInterrupt:
            kept = (
                f"kept in {store.folder}: the same call goes on"
                if store
                else "lost: there is no store"
            )
            raise Interrupted(
                f"Stopped at {len(done)} of {len(keys)} repetitions, {kept}."
            ) from None
    labels = dict.fromkeys(label for label, _ in jobs)
    return {
        label: Runs(done[key] for key in keys if key[0] == label) for label in labels
    }


def _one(key: Key, job: Callable[[], History]) -> tuple[Key, History]:
    return key, job()


def repeat(
    world: World | str | Path,
    method: str | Method = "TOSL+QBIASSR",
    *,
    repetitions: int,
    steps: int,
    seed: int = 0,
    n_jobs: int = -1,
    engine: Engine | None = None,
    progress: bool = True,
    **settings: Any,
) -> Runs:
    """Let `repetitions` new agents of one method learn, each with random numbers of its own.

    Parameters
    ----------
    world : Task, str, Path, SampleModel, EnvSpec or function
        A task, its name or the path of your own; a sample model; or an environment of Gymnasium, see
        `make_env`.
    method : str or Method
        See `Agent`.
    repetitions, steps : int
        How many agents, and how many steps each, also where an episode has not ended.
    seed : int
        Each repetition takes its seeds from ``SeedSequence(seed).spawn``, so the result depends on it alone.
    n_jobs : int
        Cores to use, -1 for all.
    engine : Engine, optional
        The simulator of the robot, see `make_env`.
    progress : bool
        Show a progress bar.
    **settings
        Further parameters of `Agent`, such as ``temperature=2``.

    Returns
    -------
    Runs
        The histories, in order.

    Raises
    ------
    ValueError
        For an unknown world, method or setting, and for impossible numbers.
    FileNotFoundError
        If there is no such task file.
    ImportError
        If the engine that you ask for is missing; it says what to install.
    KeyboardInterrupt
        After Ctrl-C, in one line; the repetitions so far are lost.
    """
    world, env, robot = tried(world, seed, repetitions, engine=engine)
    check_count("steps", steps, least=0)
    settings["method"] = method
    name = learner(env, settings).method.name
    one = partial(repetition, world, settings, {"steps": steps}, **robot)
    seeds = np.random.SeedSequence(seed).spawn(repetitions)
    jobs = {("", i): partial(one, its_seed) for i, its_seed in enumerate(seeds)}
    bar = name if progress else None
    return run(jobs, threads=isinstance(world, SampleModel), n_jobs=n_jobs, bar=bar)[""]
