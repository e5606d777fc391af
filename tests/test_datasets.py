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


@pytest.mark.parametrize("name", DATASETS)
def test_a_dataset_is_recorded_again_byte_for_byte(name, tmp_path):
    card = json.loads((ROOT / "datasets" / name / "datapackage.json").read_text())
    here = f"{platform.system()} {platform.machine()}"
    if card["rlrobot"]["platform"] != here:
        pytest.skip(f"recorded on {card['rlrobot']['platform']}: on {here} the last digits of the physics may differ")
    make_dataset(name, tmp_path)
    for file in ("transitions.csv", "datapackage.json", "README.md"):
        assert (tmp_path / name / file).read_bytes() == (ROOT / "datasets" / name / file).read_bytes()


@pytest.mark.parametrize("name", DATASETS)
def test_a_dataset_can_be_read_by_name_and_belongs_to_todays_task(name):
    recording = rl.read_recording(name)
    assert len(recording) >= 18_000 or recording.episode[-1] + 1 >= 50
    assert recording.task is not None and recording.task.name == name


def test_every_task_on_wheels_has_its_dataset_and_all_together_are_small():
    wheeled = [name for name in rl.available_tasks() if rl.load_task(name).robot in ("mobile_base", "giraff")]
    assert set(wheeled) <= set(DATASETS)
    assert sum(path.stat().st_size for path in (ROOT / "datasets").rglob("*") if path.is_file()) <= 10e6


def test_imports_run_downward_only():
    command = [str(Path(sys.executable).parent / "lint-imports"), "--no-cache"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout
