"""The datasets that come with the toolkit, and the layers of the library."""

import json
import platform
import subprocess
import sys
from pathlib import Path

import pytest

import rlrobot_edu as rl

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "datasets"))
from make_datasets import DATASETS, make_dataset  # noqa: E402

SLOW = ("arm_1k", "arm_4k", "mobile_arm_2k")  # recorded again in part only: PyBullet takes its time


def skip_where_it_cannot_be_the_same(name):
    card = json.loads((ROOT / "datasets" / name / "datapackage.json").read_text())
    here = f"{platform.system()} {platform.machine()}"
    if card["rlrobot"]["platform"] != here:
        pytest.skip(f"recorded on {card['rlrobot']['platform']}: on {here} the last digits of the physics may differ")


@pytest.mark.parametrize("name", SLOW)
def test_the_first_rows_of_a_slow_dataset_are_recorded_again_byte_for_byte(name, tmp_path):
    pytest.importorskip("pybullet")
    skip_where_it_cannot_be_the_same(name)
    how = DATASETS[name]
    agent = rl.Agent(name, how["method"], seed=how["seed"])
    rl.record(rl.make_env(name, seed=how["seed"]), agent, steps=500).save(tmp_path)
    again = (tmp_path / "transitions.csv").read_bytes()
    assert (ROOT / "datasets" / name / "transitions.csv").read_bytes().startswith(again)


@pytest.mark.parametrize("name", [name for name in DATASETS if name not in SLOW])
def test_a_dataset_is_recorded_again_byte_for_byte(name, tmp_path):
    skip_where_it_cannot_be_the_same(name)
    make_dataset(name, tmp_path)
    for file in ("transitions.csv", "datapackage.json", "README.md"):
        assert (tmp_path / name / file).read_bytes() == (ROOT / "datasets" / name / file).read_bytes()


@pytest.mark.parametrize("name", DATASETS)
def test_a_dataset_can_be_read_by_name_and_belongs_to_todays_task(name):
    recording = rl.read_recording(name)
    assert len(recording) >= 18_000
    assert recording.task is not None and recording.task.name == name


def test_every_task_has_its_dataset_and_all_together_are_small():
    assert set(rl.available_tasks()) == set(DATASETS)
    assert sum(path.stat().st_size for path in (ROOT / "datasets").rglob("*") if path.is_file()) <= 10e6


def test_imports_run_downward_only():
    command = [str(Path(sys.executable).parent / "lint-imports"), "--no-cache"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout
