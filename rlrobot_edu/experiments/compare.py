"""Compare methods as the paper does: many repetitions of each, learning curves, and what they prove."""

import dataclasses
import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_edu.checks import check_count, check_name, is_whole
from rlrobot_edu.environments import World
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.repetitions import (
    SETTINGS,
    Key,
    learner,
    repetition,
    run,
    tried,
)
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.store import Store, facts_of
from rlrobot_edu.keywords import names_of
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import EPISODE_STEPS, MOST_STEPS
from rlrobot_edu.learning.methods import Method, made_of
from rlrobot_edu.learning.size import Env, Size, can_end, longest_episode
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.task.robot_cards import Engine
from rlrobot_edu.version import __version__

STEPS = 3600  # of a repetition


def compare(
    world: World | str | Path,
    methods: Sequence[str | Method] | Mapping[str, Mapping[str, Any]],
    repetitions: int = 30,
    *,
    steps: int | None = None,
    episodes: int | None = None,
    seed: int = 0,
    n_jobs: int = -1,
    store: str | Path | None = None,
    keep: bool = False,
    realism: Realism | None = None,
    engine: Engine | None = None,
    progress: bool = True,
    share: tuple[int, int] = (1, 1),
    **settings: Any,
) -> Comparison:
    """Let agents of several methods learn in the same world, many times each, and return the results.

    Parameters
    ----------
    world : Task, str, Path, SampleModel, EnvSpec or function
        A task, its name or the path of your own; a sample model; or an environment of Gymnasium, by its id,
        its spec or a function that returns a new one, see `make_env`. Each repetition has its own.
    methods : sequence of str, or mapping
        Names such as ``"TOSL+SR"``, or a `Method` with parts of your own; or parameters of `Agent` by a
        label, such as ``{"λ = 0": {"method": "TOSL+SR", "lam": 0}, "λ = 0.9": {"method": "TOSL+SR"}}``.
    repetitions : int
        Repetitions of each method.
    steps : int, optional
        Steps of each repetition, 3600 by default. Where an episode is cut off after some steps, the repetition
        ends after as many of the longest episodes as fit into `steps`; at least one must fit.
    episodes : int, optional
        Episodes of each repetition; then `steps` may be left out. Where nothing cuts an episode off, all of
        them together may take `steps`, or 10,000 each.
    seed : int
        Fixes everything. Every repetition of every method has random numbers of its own, as an analysis of
        variance wants it; they depend on `seed`, the label and the repetition's number, and on nothing else:
        not on `n_jobs`, nor on which other methods there are, or how many repetitions.
    n_jobs : int
        Cores to use, -1 for all; inside ``with joblib.parallel_config("dask")`` a cluster does the work.
    store : str or Path, optional
        A folder that keeps every finished repetition; the same call goes on from there, or with more of them.
        Another world, method or parameter is refused there, also changed code. What a world reads elsewhere, such as
        a file, cannot be noticed: if that has changed, give another folder.
    keep : bool
        Keep every transition (s, a, r, s'), not the rewards alone.
    realism : Realism, optional
        Imperfections to simulate, see `make_env`; None is the ideal robot.
    engine : Engine, optional
        The simulator of the robot, see `make_env`: all repetitions, on whatever core.
    progress : bool
        Show a progress bar.
    share : tuple of int, int
        (k, n): the k-th of n shares of all repetitions, counted from 1; a share for each computer.
    **settings
        Parameters of `Agent` for all methods.

    Returns
    -------
    Comparison
        Curves, tests and tables.

    Raises
    ------
    ValueError
        For unknown methods or settings, a share outside 1 to n, a realism or engine that the robot cannot have,
        episodes that do not end, and a store of another experiment, or a damaged one.
    FileNotFoundError
        If there is no such task file.
    ImportError
        If the engine that you ask for is missing; it says what to install.
    KeyboardInterrupt
        After Ctrl-C, in one line; it says whether the repetitions so far are kept.
    """
    if "method" in settings:
        raise ValueError(
            "name the methods in methods=; method= is not an argument of compare"
        )
    for name in settings:
        check_name(name, [*names_of(compare), *SETTINGS], "setting", "compare")
    seed = check_count("seed", seed, least=0)
    repetitions = check_count("repetitions", repetitions)
    check_jobs(n_jobs)
    _check_share(share)
    world, env, robot = tried(world, engine=engine, realism=realism)
    length = {**length_of(env, steps, episodes), "keep": keep}
    agents = {}
    jobs: dict[Key, Callable[[], History]] = {}
    for label, its_own in _by_label(methods).items():
        its_settings = settings | its_own
        agents[label] = learner(env, its_settings)
        root = np.random.SeedSequence(seed, spawn_key=(zlib.crc32(label.encode()),))
        for i, its_seed in enumerate(root.spawn(repetitions)):
            jobs[label, i] = partial(
                repetition, world, its_settings, length, its_seed, **robot
            )
    kept = None
    if store is not None:
        facts = _facts_of_agents(agents)
        facts |= {"version": __version__, **facts_of(world), "seed": seed, **length}
        facts |= {"realism": str(realism), "engine": robot["engine"]}
        kept = Store(store, facts)
        kept.begin(world)
    bar = None
    if progress:
        (first, *others) = agents
        bar = f"{len(agents)} methods" if others else first
    runs = run(
        jobs,
        threads=isinstance(world, SampleModel),
        n_jobs=n_jobs,
        store=kept,
        bar=bar,
        share=share,
    )
    return Comparison(world, runs)


def repeat(
    world: World | str | Path,
    method: str | Method = "TOSL+QBIASSR",
    repetitions: int = 30,
    **arguments: Any,
) -> Runs:
    """Let many agents of one method learn: `compare` with this method alone.

    Parameters
    ----------
    world : Task, str, Path, SampleModel, EnvSpec or function
        Where they learn, see `make_env`.
    method : str or Method
        How they learn, see `Agent`.
    repetitions : int
        How many agents.
    **arguments
        As of `compare`, such as ``steps=600``, ``seed=1`` or ``temperature=2``. With the
        same seed each agent is the one that `compare` makes.

    Returns
    -------
    Runs
        The histories, in order.

    Raises
    ------
    ValueError
        As `compare`.
    """
    if not isinstance(method, str | Method):
        raise ValueError(
            f"repeat takes one method, got {method!r:.200}; rl.compare takes several"
        )
    result = compare(world, [method], repetitions, **arguments)
    (runs,) = result.values()
    return runs


def _facts_of_agents(agents: Mapping[str, Agent]) -> dict[str, Any]:
    """The methods and parameters of the agents of each label, by name."""
    facts: dict[str, Any] = {}
    facts["methods"] = {label: agent.method.name for label, agent in agents.items()}
    for label, agent in agents.items():
        parameters = dataclasses.asdict(agent.parameters) | made_of(agent.method)
        for name, value in parameters.items():
            facts[f"{name} of {label}"] = value
    return facts


def check_jobs(n_jobs: object) -> None:
    """Raises ValueError unless this is a number of cores: 1 and more, or −1 and less for all but some."""
    if n_jobs is not None and not (is_whole(n_jobs) and n_jobs != 0):
        raise ValueError(
            f"n_jobs must be a number of cores, or -1 for all of them, got {n_jobs!r:.200}"
        )


def _check_share(share: Any) -> None:
    """Raises ValueError unless this is the k-th of n shares."""
    are_whole = isinstance(share, tuple | list) and all(map(is_whole, share))
    if are_whole and len(share) == 2 and 1 <= share[0] <= share[1]:
        return
    raise ValueError(
        f"share must be (k, n), the k-th of n shares counted from 1, got {share!r:.200}"
    )


def length_of(
    env: Env, steps: int | None, episodes: int | None
) -> dict[str, int | None]:
    """Steps of each repetition, and episodes if it has any."""
    steps = check_count("steps", steps, or_none=True)
    episodes = check_count("episodes", episodes, or_none=True)
    longest = Size.of(env).episode_steps
    if longest is not None and episodes is None:
        if steps is None:
            steps = max(STEPS, longest)
        episodes = steps // longest
        if episodes == 0:
            raise ValueError(
                f"an episode may take {longest} steps, more than {steps}; give more steps"
            )
    if episodes is None:
        return {"steps": steps or STEPS, "episodes": None}
    longest = longest_episode(env)
    if longest is None and not can_end(env):
        raise ValueError(
            "this task goes on for ever and has no episodes; give steps= instead of episodes="
        )
    most = episodes * (longest or EPISODE_STEPS)
    most = min(most, steps or MOST_STEPS)
    return {"steps": most, "episodes": episodes}


def _by_label(
    methods: Sequence[str | Method] | Mapping[str, Mapping[str, Any]],
) -> dict[str, dict[str, Any]]:
    """The settings of the agents of each label; without a method, the label is taken as the method."""
    labels: list[str] = []
    settings: list[dict[str, Any]] = []
    if isinstance(methods, Mapping):
        for label, parameters in methods.items():
            if not isinstance(parameters, Mapping):
                raise ValueError(
                    "a label needs parameters by name: {'λ = 0': {'method': 'TOSL+SR', 'lam': 0}}"
                )
            labels.append(str(label))
            settings.append({"method": label, **parameters})
    else:
        if isinstance(methods, str) or not isinstance(methods, Iterable):
            methods = [methods]
        for method in methods:
            labels.append(method.name if isinstance(method, Method) else str(method))
            settings.append({"method": method})
    if not labels:
        raise ValueError("a comparison needs at least one method")
    if len(set(labels)) < len(labels):
        raise ValueError(f"each method must be named once, got {', '.join(labels)}")
    return dict(zip(labels, settings, strict=True))
