"""The reproduction of the paper: what it runs, and what it says about it."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import made_blocks
import numpy as np
import pytest
from paper import experiments, paper, report, tables
from paper import run as reproduce
from scipy import stats

import rlrobot_edu as rl

ROOT = Path(__file__).parents[2]


def test_the_papers_tables_are_copied_without_a_slip():
    for task, (anova, f, _) in paper.ANOVA.items():
        assert anova.f == pytest.approx(f, rel=0.002)
        best, both, rest = paper.TUKEY[task]
        assert best.q + rest.q == pytest.approx(
            both.q, abs=0.011
        )  # so the three are in this order
        for pair in (best, both, rest):
            assert stats.studentized_range.sf(
                pair.q, 3, anova.df_within
            ) == pytest.approx(pair.p, abs=0.02)


def test_the_papers_differences_follow_from_its_analysis_of_variance():
    # By hand, for wander-1K: MSW = 6.58 / 15, n = 15 / 3 + 1 = 6, so 6.17 of Tukey's Q are 6.17·√(0.43867 / 6) = 1.668.
    assert paper.repetitions("wander_1k") == 6
    assert paper.difference("wander_1k", paper.TUKEY["wander_1k"][0]) == pytest.approx(
        1.668, abs=0.001
    )
    for task, (anova, _, _) in paper.ANOVA.items():
        n, differences = (
            paper.repetitions(task),
            [paper.difference(task, pair) for pair in paper.TUKEY[task]],
        )
        assert 3 * n - 3 == anova.df_within
        # of three groups of n: the squares of their three differences add up to 3 / n of the sum of squares between
        assert n / 3 * sum(d**2 for d in differences) == pytest.approx(
            anova.ss_between, rel=0.015
        )


def test_every_experiment_asks_about_methods_it_runs_often_enough():
    keys = [experiment.key for experiment in experiments.EXPERIMENTS]
    assert len(set(keys)) == len(keys)
    for experiment in experiments.EXPERIMENTS:
        assert {name for p in experiment.pairs for name in (p.better, p.worse)} <= set(
            experiment.methods
        )
        assert experiment.best is None or experiment.best in experiment.methods
        least = 200 if experiment.on_model else 30
        if experiment.realism and experiment.best:
            least = 12  # values of the parameters, once more where walls hold the robot
        assert experiment.repetitions[0] >= least
        if experiment.key.startswith("robot_") and experiment.pairs:
            assert experiment.repetitions[0] >= paper.repetitions(experiment.task)
        assert {length.unit for length in experiment.lengths} <= {"steps", "episodes"}


def test_a_shorter_process_is_the_beginning_of_a_longer_one():
    model = rl.SampleModel.from_recording(rl.read_recording("navigation_1k"))
    for short, long in (
        ({"steps": 3600}, {"steps": 7200}),
        ({"episodes": 1}, {"episodes": 3}),
    ):
        one, other = (
            rl.compare(model, ["Q+SR"], 2, progress=False, **length)["Q+SR"]
            for length in (short, long)
        )
        (unit, number) = next(iter(short.items()))
        length = experiments.Length(
            number // 3600 if unit == "steps" else number, "episodes"
        )
        for history, longer in zip(one, other, strict=True):
            begun = length.beginning(longer)
            assert begun.final_average_reward == history.final_average_reward
            assert unit == "steps" or np.array_equal(begun.rewards, history.rewards)
        begun = experiments.Length(60).beginning(other[0])
        assert begun.seconds == pytest.approx(other[0].seconds * 60 / len(other[0]))
        assert len(begun) == 60 and begun.final_average_reward == pytest.approx(
            other[0].rewards[:60].mean()
        )


@pytest.fixture
def small_set(monkeypatch):
    """Six experiments, made short; one of a task that is not here."""
    kept = (
        "preliminary_gamma",
        "model_wander_simple",
        "robot_wander_simple",
        "traces",
        "cause_fault",
    )
    short, two = [], (experiments.Length(20), experiments.Length(40))
    for e in experiments.EXPERIMENTS:
        if e.key in kept:
            short.append(e._replace(lengths=two[-len(e.lengths) :], repetitions=(3, 2)))
    short.append(short[0]._replace(key="model_juggling", task="juggling"))
    for module in (reproduce, report):
        monkeypatch.setattr(module, "EXPERIMENTS", tuple(short))
    monkeypatch.setattr(reproduce, "measure_costs", lambda: [1e-6] * 6)


@pytest.mark.long
def test_a_run_writes_tables_figures_averages_seed_and_versions_and_a_second_one_writes_the_same(
    small_set, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    path = reproduce.reproduce()
    assert path.resolve() == tmp_path / "docs" / "reproduction" / "README.md"
    text = path.read_text(encoding="utf-8")
    assert (
        "the task juggling is not here" in text
        and "is skipped: the task juggling" in capsys.readouterr().out
    )
    rows = list(csv.DictReader((path.parent / "averages.csv").open(encoding="utf-8")))
    assert len(rows) == 3 * (
        4 + 2 * 3 + 2 * 3 + 2 + 3
    )  # both of wander_simple at two lengths
    assert {row["experiment"] for row in rows} >= {"traces", "robot_wander_simple"}
    assert "**wander_simple: differences of mean final average rewards**" in text
    for name in ("robot_wander_simple", "differences"):
        assert (path.parent / f"{name}.png").read_bytes().startswith(
            b"\x89PNG"
        ) and f"]({name}.png)" in text
    environment = json.loads((path.parent / "environment.json").read_text())
    assert (
        environment["versions"]["rlrobot_edu"] == rl.__version__
        and environment["versions"]["seed"] == "0"
    )

    for learning in ("rlrobot_edu.experiments.repetitions.learn", "paper.run.learn"):
        monkeypatch.setattr(learning, lambda *args, **more: pytest.fail("run again"))
    assert (
        reproduce.reproduce().read_text(encoding="utf-8") == text
    )  # all of it from the stores

    block = made_blocks.BLOCK.search(text)[0]
    stale = block.replace("seed 0", "seed 9")
    path.write_text(f"What people wrote.\n\n{stale}\n\nMore of it.\n", encoding="utf-8")
    assert (
        reproduce.reproduce().read_text(encoding="utf-8")
        == f"What people wrote.\n\n{block}\n\nMore of it.\n"
    )


def test_the_quick_set_has_a_folder_of_its_own(small_set, tmp_path):
    path = reproduce.reproduce(
        quick=True, folder=tmp_path, stores=tmp_path / "stores", only=["traces"]
    )
    assert "experiments have not been run: " in path.read_text(encoding="utf-8")
    assert (
        path == tmp_path / "quick" / "README.md"
        and "reproduce.py --quick" in path.read_text(encoding="utf-8")
    )
    assert list(tmp_path.glob("*.md")) == []


@pytest.mark.long
def test_another_engine_has_a_folder_of_its_own_and_says_whom_it_cannot_simulate(
    small_set, tmp_path, monkeypatch
):
    giraff = next(
        e for e in experiments.EXPERIMENTS if e.key == "robot_giraff_wander_simple"
    )
    monkeypatch.setattr(
        reproduce,
        "EXPERIMENTS",
        (*reproduce.EXPERIMENTS, giraff._replace(repetitions=(2, 2))),
    )
    where = {
        "folder": tmp_path,
        "stores": tmp_path / "stores",
        "only": ["robot_wander_simple", giraff.key],
    }
    path = reproduce.reproduce(quick=True, engine="kinematic", **where)
    text = path.read_text(encoding="utf-8")
    assert (
        path == tmp_path / "kinematic" / "quick" / "README.md"
        and "--quick --engine kinematic" in text
    )
    assert (
        "Skipped: robot_giraff_wander_simple: engine='kinematic' does not simulate this robot"
        in text
    )
    own = reproduce.reproduce(quick=True, **where).parent / "averages.csv"
    assert own.read_bytes() != (path.parent / "averages.csv").read_bytes()


def test_a_task_without_a_dataset_is_recorded_once(tmp_path, monkeypatch):
    def read_recording(path):
        if path == "wander_simple":
            raise FileNotFoundError(path)
        return rl.read_recording(path)

    monkeypatch.setattr(reproduce, "read_recording", read_recording)
    monkeypatch.setattr(reproduce, "RECORDED", 50)
    one = reproduce._model("wander_simple", tmp_path)
    monkeypatch.setattr(
        reproduce, "record", lambda *args: pytest.fail("recorded again")
    )
    assert np.array_equal(
        one.s_next, reproduce._model("wander_simple", tmp_path).s_next
    )


def test_costs_are_measured_for_the_six_rows_of_the_paper():
    costs = reproduce.measure_costs(repetitions=3, steps=3000)
    assert (
        len(costs) == len(paper.COST) == 6 and costs[5] > costs[3] > 0
    )  # full traces cost more
    assert len(tables.cost_table(costs).rows) == 6


def test_the_command_line_knows_the_quick_set():
    helped = subprocess.run(
        [sys.executable, ROOT / "studies/reproduce.py", "--help"],
        capture_output=True,
        text=True,
    )
    assert helped.returncode == 0 and "--quick" in helped.stdout
