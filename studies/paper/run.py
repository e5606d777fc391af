"""Run the paper's experiments, and put ours beside the paper's into the page of the report: ``make reproduce``."""

import csv
import io
import json
import platform
import time
from collections.abc import Collection
from copy import copy
from functools import partial
from importlib import metadata
from pathlib import Path

import numpy as np
from tqdm.auto import tqdm

from paper.experiments import EXPERIMENTS, FAULTY, Experiment, Length
from paper.paper import COST
from paper.report import write_page
from paper.worlds import PreviousAction
from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.compare import compare
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.experiments.repetitions import run
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.store import Store, facts_of
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.models.read_recording import read_recording
from rlrobot_edu.models.recording import record
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task_file import available_tasks, load_task
from rlrobot_edu.version import __version__

SEED = 0
RECORDED = 18_000  # steps of a recording that is made here: five hours
# about how long a step takes [s], so that the bar can say what is left; and what an experiment takes besides
MODEL_STEP, ROBOT_STEP, ARM_STEP, FAULTY_STEP, BESIDES = 2e-6, 2.5e-4, 1.6e-3, 4e-5, 3.0


def reproduce(
    quick: bool = False,
    folder: str | Path = "docs/reproduction",
    stores: str | Path = "results",
    only: Collection = (),
    engine: str = "",
    seed: int = SEED,
) -> Path:
    """Run all experiments of the paper and write averages, figures and the tables of the report; returns its path.

    quick: few repetitions, written to `folder`/quick, with a page of tables and figures alone
    engine: that simulates the robots, written to `folder`/engine, likewise; a robot that it cannot simulate is left
        out. Empty: each robot's own. Experiments in sample models are the same with any
    stores: folder of the finished repetitions; a call that was stopped goes on from there
    only: keys of the experiments to run, see `experiments.EXPERIMENTS`; none: all
    seed: of all comparisons; another one than the report's has a folder of its own, likewise
    """
    another = "" if seed == SEED else f"seed_{seed}"
    words = [*filter(None, [engine, another, "quick" if quick else ""])]
    folder, stores = (
        Path(folder, *words),
        Path(stores, "_".join(["reproduction", *words])),
    )
    averages: list[tuple] = []
    skipped, pictures = {}, {}
    wanted = [
        experiment for experiment in EXPERIMENTS if not only or experiment.key in only
    ]
    layout = (
        "{desc} {percentage:3.0f} % |{bar}| {elapsed} passed, about {remaining} left"
    )
    with tqdm(
        total=sum(expected(e, quick) for e in wanted), bar_format=layout, smoothing=0.1
    ) as bar:
        for number, experiment in enumerate(wanted, start=1):
            bar.set_description(f"{number} of {len(wanted)}: {experiment.key}")
            try:
                result = run_experiment(experiment, quick, stores, engine, seed)
            except (LookupError, ImportError) as reason:
                skipped[experiment.key] = str(reason.args[0])
                bar.write(f"{experiment.key} is skipped: {skipped[experiment.key]}")
            else:
                averages += _rows(experiment, result)
                if experiment.key.startswith("robot_"):
                    pictures |= curves_of(experiment, result, folder)
            bar.update(expected(experiment, quick))
    about = {
        "command": "python studies/reproduce.py"
        + " --quick" * quick
        + f" --engine {engine}" * bool(engine)
        + (f" --seed {seed}" if another else "")
    }
    about |= {
        "versions": _versions(seed),
        "skipped": skipped,
        "seconds a step": [] if only or engine or another else measure_costs(),
    }
    write_whole(folder / "averages.csv", _as_csv(averages))
    write_whole(folder / "environment.json", json.dumps(about, indent=1) + "\n")
    path = write_page(folder, pictures, has_prose=not words)
    print(f"Written: {path}")
    return path


def draw_curves(
    only: Collection[str] = (),
    folder: str | Path = "docs/reproduction",
    stores: str | Path = "results/reproduction",
) -> Path:
    """Draw the robots' learning curves anew, and the page's other figures; returns the page.

    only: keys of the experiments; none: all on robots. Their runs are taken from `stores`, and missing ones are made.
    """
    pictures: dict[str, str] = {}
    for experiment in EXPERIMENTS:
        if experiment.key.startswith("robot_") and (not only or experiment.key in only):
            result = run_experiment(experiment, False, Path(stores), "")
            pictures |= curves_of(experiment, result, Path(folder))
    return write_page(Path(folder), pictures, has_prose=True)


def curves_of(
    experiment: Experiment, result: Comparison, folder: Path
) -> dict[str, str]:
    """Write the learning curves of an experiment; returns the picture in Markdown, by its name."""
    figure, name = result.plot(), f"{experiment.key}.png"
    write_whole(folder / name, figure.still().data)
    return {name: f"![{figure.finding}. {figure.alt}]({name})"}


def expected(experiment: Experiment, quick: bool) -> float:
    """About how long it takes on one core [s]; only the progress bar goes by it."""
    number, unit = experiment.lengths[-1]
    arm = experiment.task.startswith("arm")
    steps = number * (
        1 if unit == "steps" else 120 if arm else 1500
    )  # an episode of navigation: more or less
    steps *= experiment.repetitions[quick]
    a_step = MODEL_STEP if experiment.on_model else ARM_STEP if arm else ROBOT_STEP
    return BESIDES + steps * (
        a_step * len(experiment.methods) + FAULTY_STEP * experiment.faulty
    )


def measure_costs(repetitions: int = 30, steps: int = 3600) -> list[float]:
    """CPU time a step of each row of the paper's table [s]: the median of the repetitions, the rows taking turns."""
    model = _model("wander_1k", Path("results"))
    times = []
    for seed in range(repetitions + 1):  # the first one compiles
        times.append([])
        for method, traces, _ in COST:
            agent, env = (
                Agent(model, method, traces=traces, seed=seed),
                make_env(model, seed),
            )
            start = time.process_time()
            learn(agent, env, steps, progress=False)
            times[-1].append((time.process_time() - start) / steps)
    return np.median(times[1:], axis=0).tolist()


def run_experiment(
    experiment: Experiment, quick: bool, stores: Path, engine: str, seed: int = SEED
) -> Comparison:
    """The comparison. Raises LookupError or ImportError if the task is not here, or cannot be run so."""
    if experiment.task not in available_tasks():
        raise LookupError(f"the task {experiment.task} is not here")
    task = load_task(experiment.task)
    engines = ROBOTS[task.robot].engines
    make_env(
        task, engine=next(iter(engines))
    ).close()  # the published one, and no other
    if (
        engine
        and not experiment.on_model
        and (engine not in engines or experiment.realism)
    ):
        raise LookupError(
            f"engine={engine!r} does not simulate this robot, or not as it is to be here"
        )
    world = (
        _model(experiment.task, stores, experiment.seed)
        if experiment.on_model
        else task
    )
    if experiment.change:
        world = experiment.change(world)
    number, unit = experiment.lengths[-1]
    repetitions = experiment.repetitions[quick]
    result = compare(
        world, experiment.methods, repetitions, **{unit: number}, seed=seed, store=stores / experiment.key,
        realism=experiment.realism, engine=None if experiment.on_model else engine or None,
    )  # fmt: skip
    if not experiment.faulty:
        return result
    faulty = _faulty_runs(
        world, repetitions, number, stores / f"{experiment.key}_faulty", seed
    )
    return Comparison(world, {**result, FAULTY: faulty})


def _faulty_runs(
    model: SampleModel, repetitions: int, steps: int, folder: Path, seed: int
) -> Runs:
    """Q-learning in a world that answers with the action before, kept like any comparison; the loop is Python's."""
    facts = {
        "methods": {FAULTY: "Q+SR"},
        "version": __version__,
        **facts_of(model),
        "seed": seed,
        "steps": steps,
    }
    store, seeds = (
        Store(folder, facts),
        np.random.SeedSequence(seed, spawn_key=(1,)).spawn(repetitions),
    )
    store.begin(model)
    jobs = {
        (FAULTY, i): partial(faulty_run, model, steps, one)
        for i, one in enumerate(seeds)
    }
    return run(jobs, threads=False, store=store)[FAULTY]


def faulty_run(model: SampleModel, steps: int, seed: np.random.SeedSequence) -> History:
    """One repetition of Q-learning with the fault of the paper's program."""
    agent_seed, env_seed = copy(seed).spawn(2)
    agent, env = (
        Agent(model, "Q+SR", seed=agent_seed),
        PreviousAction(make_env(model, env_seed)),
    )
    return learn(agent, env, steps, progress=False)


def _model(task: str, stores: Path, seed: int | None = None) -> SampleModel:
    """The sample model of the toolkit's own recording of `task`, or of one made now (and kept)."""
    own = stores / "recordings" / (task if seed is None else f"{task}_{seed}")
    try:
        recording = read_recording(own if own.is_dir() or seed is not None else task)
    except FileNotFoundError:
        seed = SEED if seed is None else seed
        recording = record(
            Agent(task, "TOSL+SR", seed=seed), make_env(task, seed), RECORDED
        )
        recording.save(own)
    return SampleModel.from_recording(recording)


def _rows(experiment: Experiment, result: Comparison) -> list[tuple]:
    """Rows of averages.csv."""
    return [
        (experiment.key, length, label, i, f"{x:.8g}")
        for length in experiment.lengths
        for label, final in shortened(result, length).final.items() for i, x in enumerate(final)
    ]  # fmt: skip


def shortened(result: Comparison, length: Length) -> Comparison:
    """The comparison of the same agents, stopped sooner."""
    groups = {
        label: Runs(length.beginning(history) for history in runs)
        for label, runs in result.items()
    }
    return Comparison(result.world, groups)


def _as_csv(rows: list[tuple]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows(
        [
            ("experiment", "length", "method", "repetition", "final_average_reward"),
            *rows,
        ]
    )
    return text.getvalue()


def _versions(seed: int) -> dict[str, str]:
    packages = ("numpy", "scipy", "numba", "gymnasium", "joblib", "pymunk")
    return {
        "rlrobot_edu": __version__, "seed": str(seed),
        "platform": f"{platform.system()} {platform.machine()}", "python": platform.python_version(),
        **{name: metadata.version(name) for name in packages},
    }  # fmt: skip
