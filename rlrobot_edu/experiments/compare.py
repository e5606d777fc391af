"""Compare methods as the paper does: many repetitions of each, learning curves, and what they prove."""

import dataclasses
import zlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import joblib
import numpy as np

from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.repeat import Repetition, as_world, engine_of, run
from rlrobot_edu.experiments.store import Store
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.methods import Method, own_parts
from rlrobot_edu.learning.size import Size
from rlrobot_edu.models.sample_model import DTYPES, SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.task.task import Task
from rlrobot_edu.version import __version__


def compare(
    world: Task | str | Path | SampleModel,
    methods: Sequence[str | Method] | Mapping[str, Mapping[str, Any]],
    repetitions: int = 30,
    *,
    steps: int = 3600,
    episodes: int | None = None,
    seed: int = 0,
    n_jobs: int = -1,
    store: str | Path | None = None,
    keep: bool = False,
    realism: Realism | None = None,
    engine: str | None = None,
    progress: bool = True,
    share: tuple[int, int] = (0, 1),
    **settings: Any,
) -> Comparison:
    """Let agents of several methods learn in the same world, many times each, and return what came of it.

    Parameters
    ----------
    world : Task, str, Path or SampleModel
        A task, its name or the path of your own; or a sample model.
    methods : sequence of str, or mapping
        Names such as ``"TOSL+SR"``, or a `Method` with parts of your own; or parameters of `Agent` by a label, such as
        ``{"λ = 0": {"method": "TOSL+SR", "lam": 0}, "λ = 0.9": {"method": "TOSL+SR"}}``.
    repetitions, steps : int
        Repetitions of each method, and steps of each repetition.
    episodes : int, optional
        Of each repetition in an episodic task, instead of `steps`; None: as many whole ones as fit into `steps`.
    seed : int
        Fixes everything. Every repetition of every method has random numbers of its own, as an analysis of variance
        wants it; they depend on `seed`, the label and the repetition's number, and on nothing else: not on
        `n_jobs`, nor on which other methods there are, or how many repetitions.
    n_jobs : int
        Cores to use, -1 for all; inside ``with joblib.parallel_config("dask")`` a cluster does the work.
    store : str or Path, optional
        A folder that keeps every finished repetition; the same call goes on from there, also with more repetitions.
    keep : bool
        Keep every transition (s, a, r, s'), not the rewards alone.
    realism : Realism, optional
        Weaknesses of the robot, see `make_env`; None is the ideal one.
    engine : str, optional
        The simulator of the robot, see `make_env`: all repetitions, on whatever core.
    progress : bool
        Show a progress bar.
    share : tuple of int, int
        (k, n) for every n-th of all repetitions, beginning with number k; (0, 1) is all. See `shard`.
    **settings
        Parameters of `Agent` for all methods.

    Returns
    -------
    Comparison
        Curves, tests and tables.

    Raises
    ------
    ValueError
        For unknown methods or settings, a realism or engine that the robot cannot have, and a store of another
        experiment, or a damaged one.
    """
    world = as_world(world)
    check_count("seed", seed, least=0)
    size = Size.of(world)
    if size.episode_steps is None and episodes is not None:
        raise ValueError("this task goes on for ever and has no episodes; give steps= instead of episodes=")
    if size.episode_steps is not None:
        episodes = max(1, steps // size.episode_steps) if episodes is None else episodes
        steps = episodes * size.episode_steps
    if "method" in settings:
        raise ValueError("the methods to compare are given all together, as methods; leave method out")
    if isinstance(methods, Mapping) and not all(isinstance(mine, Mapping) for mine in methods.values()):
        raise ValueError("each label needs its parameters by name, such as {'λ = 0': {'method': 'TOSL+SR', 'lam': 0}}")
    check_count("repetitions", repetitions)
    check_count("steps", steps)
    length = {"steps": steps, "episodes": episodes, "keep": keep}
    engine = engine_of(world, engine, realism)
    functions, seeds, names = {}, {}, {}
    parameters: dict[str, Any] = {}
    for label, mine in _by_label(methods).items():
        functions[label] = Repetition(world, {**settings, **mine}, length, realism, engine)
        seeds[label] = np.random.SeedSequence(seed, spawn_key=(zlib.crc32(label.encode()),)).spawn(repetitions)
        agent = functions[label].agent()
        names[label] = agent.method
        agents = dataclasses.asdict(agent.parameters) | own_parts(agent.made_of)
        parameters |= {f"{name} of {label}": x for name, x in agents.items()}
    facts = {"methods": names, **parameters, "version": __version__, **facts_of(world), "seed": seed, **length}
    facts |= {"realism": str(realism), "engine": engine}
    if kept := None if store is None else Store(store, facts):
        kept.begin(world)
    bar, threads = f"{len(functions)} methods" if progress else None, isinstance(world, SampleModel)
    runs = run(functions, seeds, threads=threads, n_jobs=n_jobs, store=kept, bar=bar, share=share)
    return Comparison(world, runs, seed)


def _by_label(methods: Sequence[str | Method] | Mapping[str, Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """What is given for the agents of each label; where there is no method, the label is one."""
    if isinstance(methods, str | Method):
        methods = [methods]
    if isinstance(methods, Mapping):
        given = {str(label): {"method": label, **mine} for label, mine in methods.items()}
    else:
        given = {method.name if isinstance(method, Method) else str(method): {"method": method} for method in methods}
        if len(given) < len(methods):
            raise ValueError(f"each method must be named once, got {', '.join(map(str, methods))}")
    if not given:
        raise ValueError("a comparison needs at least one method")
    return given


def facts_of(world: Task | SampleModel) -> dict[str, Any]:
    """What the world is, by name, the most telling first."""
    if isinstance(world, SampleModel):
        return {
            "world": "a sample model", "shape": list(world.shape), "n_actions": world.n_actions,
            "unseen": world.unseen, "episode_steps": world.episode_steps,
            "what the model has recorded": joblib.hash([getattr(world, name) for name in DTYPES]),
        }  # fmt: skip
    parts = ("robot", "scene", "inputs", "outputs", "rewards", "step_time", "episode_steps", "goal_steps")
    facts = {"world": f"the task {world.name}", **{name: str(getattr(world, name)) for name in parts}}
    facts["the content of the task's file"] = world.fingerprint[:16]
    for name in ("reward", "command", "goal"):
        facts[f"the function {name}"] = code_of(getattr(world, name), file=world.path)
    return facts
