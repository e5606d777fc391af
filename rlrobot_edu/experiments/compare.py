"""Compare methods as the paper does: many repetitions of each, learning curves, and what they prove."""

from __future__ import annotations

import sys
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from rlrobot_edu import __version__
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.repeat import Job, World, as_world, batches, run_all
from rlrobot_edu.experiments.runs import Run, Runs
from rlrobot_edu.experiments.store import Store, fingerprint
from rlrobot_edu.files import sha256
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Size
from rlrobot_edu.models.sample_model import ARRAYS, SampleModel
from rlrobot_edu.task.task import Task


def compare(
    world: Task | str | Path | SampleModel,
    methods: Sequence[str] | Mapping[str, Mapping],
    repetitions: int = 30,
    *,
    steps: int = 3600,
    episodes: int | None = None,
    seed: int = 0,
    n_jobs: int = -1,
    store: str | Path | None = None,
    keep: bool = False,
    progress: bool = True,
    **settings,
) -> Comparison:
    """Let agents of several methods learn in the same world, many times each, and return what came of it.

    world: a task, its name or the path of your own; or a sample model
    methods: names such as ``"TOSL+SR"``; or parameters of `Agent` by a label of your own, such as
        ``{"λ = 0": {"method": "TOSL+SR", "lam": 0}, "λ = 0.9": {"method": "TOSL+SR"}}``
    repetitions: of each method; steps: of each repetition
    episodes: of each repetition in an episodic task, instead of `steps`; None: as many whole ones as fit into `steps`
    seed: fixes everything. Every repetition of every method has random numbers of its own, as an analysis of variance
        wants it; they depend on `seed`, the label and the repetition's number, and on nothing else: not on
        `n_jobs`, nor on which other methods there are, or how many repetitions
    n_jobs: cores to use, -1 for all; inside ``with joblib.parallel_config("dask")`` a cluster does the work
    store: a folder that keeps every finished repetition; the same call goes on from there, also with more repetitions
    keep: keep every transition (s, a, r, s'), not the rewards alone; progress: show a progress bar
    settings: parameters of `Agent` for all methods

    Raises ValueError for unknown methods or settings, and for a store of another experiment, or a damaged one.
    """
    world = as_world(world)
    agents = _agents(methods, settings)
    size = Size.of(world)
    if size.episode_steps is None and episodes is not None:
        raise ValueError("this task goes on for ever and has no episodes; give steps= instead of episodes=")
    if size.episode_steps is not None:
        episodes = max(1, steps // size.episode_steps) if episodes is None else episodes
        steps = episodes * size.episode_steps
    if min(repetitions, steps) < 1:
        raise ValueError(f"a comparison needs at least one repetition and one step, got {repetitions} and {steps}")
    facts = {
        "version": __version__,
        **_facts(world),
        "methods": {label: _about(world, parameters) for label, parameters in agents.items()},
        "steps": steps, "episodes": episodes, "seed": seed, "keep": keep,
    }  # fmt: skip
    kept = None if store is None else Store(store, facts)
    jobs = [
        Job(world, parameters["method"], _without_method(parameters), steps, episodes, keep, label, 0, ())._replace(
            seeds=np.random.SeedSequence(seed, spawn_key=(zlib.crc32(label.encode()),)).spawn(repetitions)
        )
        for label, parameters in agents.items()
    ]
    done = _run(jobs, repetitions, n_jobs, kept, progress)
    groups = {
        label: Runs([done[label, i] for i in range(repetitions)], parameters["method"], size)
        for label, parameters in agents.items()
    }
    return Comparison(world, groups, seed)


def _run(jobs: list[Job], repetitions: int, n_jobs: int, store: Store | None, progress: bool) -> dict:
    """The runs by label and repetition: those in the store, and all others, run now."""
    done: dict[tuple[str, int], Run] = {}

    def take(label: str, first: int, runs: list[Run]) -> None:
        done.update({(label, first + i): run for i, run in enumerate(runs)})

    for batch in store.load() if store else ():
        take(*batch)
    parts = []
    for job in jobs:
        missing = [i for i in range(repetitions) if (job.label, i) not in done]
        parts += batches(job, missing) if missing else ()
    total = len(jobs) * repetitions
    there = total - sum(len(part.seeds) for part in parts)
    if progress:
        from tqdm.auto import tqdm

        bar = tqdm(total=total, initial=there, unit="repetition", desc=f"{len(jobs)} methods", leave=False)
    try:
        for part, runs in run_all(parts, jobs[0].world, n_jobs):
            if store:
                store.save(part.label, part.first, runs)
            take(part.label, part.first, runs)
            if progress:
                bar.update(len(runs))
            there += len(runs)
    except KeyboardInterrupt:
        print(f"\nStopped after {there} of {total} repetitions. {_how_to_go_on(store)}", file=sys.stderr)
        raise
    finally:
        if progress:
            bar.close()
    return done


def _how_to_go_on(store: Store | None) -> str:
    if store is None:
        return "They are lost; with store='a folder' the same call would go on where it was stopped."
    return f"They are kept in {store.folder}: make the same call again to go on."


def _agents(methods: Sequence[str] | Mapping[str, Mapping], settings: Mapping) -> dict[str, dict]:
    """Parameters of each agent by label."""
    if isinstance(methods, str):
        methods = [methods]
    if not isinstance(methods, Mapping):
        if len(set(methods)) < len(methods):
            raise ValueError(f"each method must be named once, got {', '.join(map(str, methods))}")
        methods = {method: {"method": method} for method in methods}
    if not methods:
        raise ValueError("a comparison needs at least one method")
    return {str(label): {"method": label, **settings, **parameters} for label, parameters in methods.items()}


def _without_method(parameters: dict) -> dict:
    return {name: value for name, value in parameters.items() if name != "method"}


def _about(world: World, parameters: dict) -> dict:
    """Every parameter of an agent, the defaults included. Raises ValueError if one is wrong."""
    return {"method": parameters["method"], **Agent(world, **parameters).settings}


def _facts(world: World) -> dict:
    """What the world is, by name, the most telling first."""
    if isinstance(world, SampleModel):
        return {
            "world": "a sample model", "shape": list(world.shape), "n_actions": world.n_actions,
            "unseen": world.unseen, "episode_steps": world.episode_steps,
            "what the model has recorded": fingerprint(*(getattr(world, name) for name in ARRAYS)),
        }  # fmt: skip
    parts = ("robot", "scene", "inputs", "outputs", "rewards", "step_time", "episode_steps")
    facts = {"world": f"the task {world.name}", **{name: str(getattr(world, name)) for name in parts}}
    if Path(world.path).is_file():
        facts["the content of the task's file"] = sha256(Path(world.path).read_bytes())[:16]
    return facts
