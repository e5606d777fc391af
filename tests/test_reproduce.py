"""The reproduction of the paper: what it runs, and what it says about it."""

import csv
import json
import os
import subprocess
import sys

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.experiments.statistics import Interval, Pair, tukey_p
from rlrobot_edu.reproduction import paper, report
from rlrobot_edu.reproduction import run as reproduce


def pair(difference, p):
    return Pair("TOSL+SR", "Q+SR", difference, 1.0, p, Interval(0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    "difference, p, paper_p, said",
    [
        (1.0, 0.001, 0.002, "same direction, same significance"),
        (1.0, 0.2, 0.7, "same direction, same significance"),
        (1.0, 0.03, 0.002, "same direction, not the same significance (ours p<0.05, the paper's p<0.01)"),
        (-1.0, 0.001, 0.002, "not the same direction, same significance"),
        (-1.0, 0.001, None, "not the same direction (ours p<0.01)"),
    ],
)
def test_a_verdict_says_what_agrees_with_the_paper(difference, p, paper_p, said):
    assert report.verdict(pair(difference, p), paper.PaperPair("TOSL+SR", "Q+SR", 1.0, paper_p)) == said


def test_the_papers_tables_are_copied_without_a_slip():
    for task, (anova, f, _) in paper.ANOVA.items():
        assert anova.f == pytest.approx(f, rel=0.002)
        best, both, rest = paper.TUKEY[task]
        assert best.q + rest.q == pytest.approx(both.q, abs=0.011)  # so the three are in this order
        for pair in (best, both, rest):
            assert tukey_p(pair.q, 3, anova.df_within) == pytest.approx(pair.p, abs=0.02)


def test_every_experiment_asks_about_methods_it_runs():
    keys = [experiment.key for experiment in paper.EXPERIMENTS]
    assert len(set(keys)) == len(keys)
    for experiment in paper.EXPERIMENTS:
        assert {name for p in experiment.pairs for name in (p.better, p.worse)} <= set(experiment.methods)
        assert experiment.repetitions[0] >= (200 if experiment.model else 30)
    assert [e.repetitions[0] for e in paper.EXPERIMENTS if e.key == "robot_wander_simple"] == [100]


@pytest.fixture
def small_set(monkeypatch):
    """Four experiments, made short; one of a task that is not here."""
    kept = ("model_wander_1k", "model_wander_simple", "robot_wander_simple", "traces")
    short = [e._replace(steps=20, repetitions=(3, 2)) for e in paper.EXPERIMENTS if e.key in kept]
    short.append(short[0]._replace(key="model_juggling", task="juggling"))
    for module in (reproduce, report):
        monkeypatch.setattr(module, "EXPERIMENTS", tuple(short))
    monkeypatch.setattr(reproduce, "measure_costs", lambda: [1e-6] * 6)


def test_the_report_has_every_table_figure_average_seed_and_version(small_set, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    path = reproduce.reproduce()
    assert path.resolve() == tmp_path / "docs" / "reproduction" / "README.md"
    text = path.read_text(encoding="utf-8")
    assert "the task juggling is not here" in text and "skipped: the task juggling" in capsys.readouterr().out
    for word in ("paper's F", "HSD Q statistic", "same direction", "significance", "diagnose()", "CPU time a step"):
        assert word in text
    rows = list(csv.DictReader((path.parent / "averages.csv").open(encoding="utf-8")))
    assert len(rows) == 3 * (3 + 3 + 3 + 2) and {row["experiment"] for row in rows} >= {"traces", "robot_wander_simple"}
    assert (path.parent / "traces.png").read_bytes().startswith(b"\x89PNG")
    environment = json.loads((path.parent / "environment.json").read_text())
    assert environment["rlrobot_edu"] == rl.__version__ and environment["seed"] == 0

    quick = reproduce.reproduce(quick=True)
    assert quick.parent.name == "quick" and path.read_text(encoding="utf-8") == text


def test_a_second_call_takes_everything_from_the_stores_and_writes_the_same(small_set, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = reproduce.reproduce().read_bytes()
    monkeypatch.setattr("rlrobot_edu.experiments.repeat.learn", lambda *args, **more: pytest.fail("run again"))
    assert reproduce.reproduce().read_bytes() == text


def test_a_task_without_a_dataset_is_recorded_once(tmp_path, monkeypatch):
    def read_recording(path):
        if path == "wander_simple":
            raise FileNotFoundError(path)
        return rl.read_recording(path)

    monkeypatch.setattr(reproduce, "read_recording", read_recording)
    monkeypatch.setattr(reproduce, "RECORDED", 50)
    one = reproduce._model("wander_simple", tmp_path)
    monkeypatch.setattr(reproduce, "record", lambda *args: pytest.fail("recorded again"))
    assert np.array_equal(one.s_next, reproduce._model("wander_simple", tmp_path).s_next)


def test_costs_are_measured_for_the_six_rows_of_the_paper():
    costs = reproduce.measure_costs(repetitions=3, steps=3000)
    assert len(costs) == len(paper.COST) == 6 and costs[5] > costs[3] > 0  # full traces cost more
    assert len(report.cost_table(costs).rows) == 6


def test_the_command_line_knows_the_quick_set():
    helped = subprocess.run(
        [sys.executable, "-m", "rlrobot_edu", "reproduce", "--help"], capture_output=True, text=True, env=os.environ
    )
    assert helped.returncode == 0 and "--quick" in helped.stdout
