"""Run the paper's experiments, and write a page on which ours stand beside the paper's: ``make reproduce``."""

import csv
import io
import json
import platform
import time
from collections.abc import Collection
from importlib import metadata
from pathlib import Path

import numpy as np

from rlrobot_edu import __version__
from rlrobot_edu.environments import make_env
from rlrobot_edu.experiments.compare import compare
from rlrobot_edu.experiments.comparison import Comparison
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.models.recording import read_recording, record
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.reproduction.paper import COST, EXPERIMENTS, Experiment
from rlrobot_edu.reproduction.report import Outcome, cost_table, page
from rlrobot_edu.task.task_file import available_tasks

SEED = 0
RECORDED = 18_000  # steps of a recording that is made here, because the toolkit comes with none: five hours


def reproduce(
    quick: bool = False, folder: str | Path = "docs/reproduction", stores: str | Path = "results", only: Collection = ()
) -> Path:
    """Run all experiments of the paper and write the report; returns its path.

    quick: a tenth of the repetitions, written to `folder`/quick
    stores: folder of the finished repetitions; a call that was stopped goes on from there
    only: keys of the experiments to run, see `paper.EXPERIMENTS`; none: all
    """
    folder = Path(folder, "quick") if quick else Path(folder)
    stores = Path(stores, "reproduction_quick" if quick else "reproduction")
    outcomes, skipped, averages = {}, {}, []
    for number, experiment in enumerate(EXPERIMENTS, start=1):
        if only and experiment.key not in only:
            continue
        print(f"{number} of {len(EXPERIMENTS)}: {experiment.title} ({experiment.key})", flush=True)
        try:
            result = _run(experiment, quick, stores)
        except (LookupError, ImportError) as reason:
            skipped[experiment.key] = str(reason.args[0])
            print(f"  skipped: {skipped[experiment.key]}")
            continue
        figure = result.plot(title=experiment.title)
        write_whole(folder / f"{experiment.key}.png", figure.png())
        outcomes[experiment.key] = Outcome.of(experiment, result, figure.alt)
        averages += _averages(experiment.key, result)
    costs = measure_costs() if not only else None
    write_whole(folder / "averages.csv", _as_csv(averages))
    write_whole(folder / "environment.json", json.dumps(_environment(quick), indent=1) + "\n")
    if costs is not None:
        write_whole(folder / "cost.md", cost_table(costs).markdown + "\n")
    path = folder / "README.md"
    write_whole(path, page(outcomes, skipped, costs, _environment(quick)))
    print(f"Written: {path}")
    return path


def measure_costs(repetitions: int = 30, steps: int = 3600) -> list[float]:
    """CPU time a step of each row of the paper's table [s]: the median of the repetitions, the rows taking turns."""
    model = _model("wander_1k", Path("results"))
    times = []
    for seed in range(repetitions + 1):  # the first one compiles
        times.append([])
        for method, traces, _ in COST:
            agent, env = Agent(model, method, traces=traces, seed=seed), make_env(model, seed)
            start = time.process_time()
            learn(agent, env, steps, progress=False)
            times[-1].append((time.process_time() - start) / steps)
    return np.median(times[1:], axis=0).tolist()


def _run(experiment: Experiment, quick: bool, stores: Path) -> Comparison:
    """The comparison. Raises LookupError or ImportError if the task is not here, or not on this computer."""
    if experiment.task not in available_tasks():
        raise LookupError(f"the task {experiment.task} is not here")
    make_env(experiment.task).close()
    world = _model(experiment.task, stores) if experiment.model else experiment.task
    repetitions = experiment.repetitions[quick]
    store = stores / experiment.key
    return compare(world, experiment.methods, repetitions, steps=experiment.steps, seed=SEED, store=store)


def _model(task: str, stores: Path) -> SampleModel:
    """The sample model of the toolkit's own recording of `task`, or of one made now (and kept)."""
    own = stores / "recordings" / task
    try:
        recording = read_recording(own if own.is_dir() else task)
    except FileNotFoundError:
        print(f"  recording {RECORDED} steps of {task} …", flush=True)
        recording = record(make_env(task, SEED), Agent(task, "TOSL+SR", seed=SEED), RECORDED)
        recording.save(own)
    return SampleModel.from_recording(recording)


def _averages(key: str, result: Comparison) -> list[tuple]:
    return [(key, label, i, float(x)) for label, final in result.final.items() for i, x in enumerate(final)]


def _as_csv(rows: list[tuple]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([("experiment", "method", "repetition", "final_average_reward"), *rows])
    return text.getvalue()


def _environment(quick: bool) -> dict:
    packages = ("numpy", "scipy", "numba", "gymnasium", "joblib", "pymunk")
    return {
        "rlrobot_edu": __version__, "set": "quick" if quick else "full", "seed": SEED,
        "platform": f"{platform.system()} {platform.machine()}", "python": platform.python_version(),
        **{name: metadata.version(name) for name in packages},
    }  # fmt: skip
