"""The datasets that come with the toolkit, and the layers of the library."""

import json
import os
import platform
import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.task_file import available_tasks

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "datasets"))
from make_datasets import DATASETS, card, learner, make_dataset  # noqa: E402

FILES = ("transitions.csv", "datapackage.json", "README.md")
WHOLE = (
    "worked_example",
    "navigation_1k",
)  # recorded again to their end: one that goes on for ever, one of episodes
if os.environ.get("RLROBOT_EDU_LONG"):
    WHOLE = tuple(DATASETS)
ROWS = {
    "arm_1k": 480,
    "arm_4k": 480,
    "mobile_arm_2k": 480,
}  # of the others, whole episodes; PyBullet takes its time
MOST_ROWS = 6000


def skip_where_it_cannot_be_the_same(name):
    card = json.loads((ROOT / "datasets" / name / "datapackage.json").read_text())
    here = f"{platform.system()} {platform.machine()}"
    if card["rlrobot"]["platform"] != here:
        pytest.skip(
            f"recorded on {card['rlrobot']['platform']}: on {here} the last digits of the physics may differ"
        )


@pytest.mark.long
@pytest.mark.parametrize("name", WHOLE)
def test_a_dataset_is_recorded_again_byte_for_byte(name, tmp_path):
    skip_where_it_cannot_be_the_same(name)
    make_dataset(name, tmp_path)
    for file in FILES:
        assert (tmp_path / name / file).read_bytes() == (
            ROOT / "datasets" / name / file
        ).read_bytes()


@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in DATASETS if name not in WHOLE])
def test_the_first_rows_of_a_dataset_are_recorded_again_byte_for_byte(name, tmp_path):
    if name in ROWS:
        pytest.importorskip("pybullet")
    skip_where_it_cannot_be_the_same(name)
    how = DATASETS[name]
    agent, env = learner(name, how["method"], how["seed"])
    rl.record(agent, env, steps=ROWS.get(name, MOST_ROWS)).save(tmp_path)
    again = (tmp_path / "transitions.csv").read_bytes()
    assert (ROOT / "datasets" / name / "transitions.csv").read_bytes().startswith(again)


@pytest.mark.parametrize("name", DATASETS)
def test_a_dataset_that_is_read_and_saved_has_the_same_bytes_and_its_page_tells_of_its_rows(
    name, tmp_path
):
    recording = rl.read_recording(name)
    recording.save(tmp_path)
    (tmp_path / "README.md").write_text(card(name, recording), encoding="utf-8")
    for file in FILES:
        assert (tmp_path / file).read_bytes() == (
            ROOT / "datasets" / name / file
        ).read_bytes()


@pytest.mark.parametrize("name", DATASETS)
def test_a_dataset_can_be_read_by_name_and_belongs_to_todays_task(name):
    recording = rl.read_recording(name)
    assert len(recording) >= 18_000
    assert recording.task is not None and recording.task.name == name


def test_every_dataset_has_its_task_and_all_together_are_small():
    assert set(DATASETS) <= set(available_tasks())
    assert (
        sum(
            path.stat().st_size
            for path in (ROOT / "datasets").rglob("*")
            if path.is_file()
        )
        <= 10e6
    )


def test_imports_run_downward_only():
    command = [str(Path(sys.executable).parent / "lint-imports"), "--no-cache"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout


def test_the_page_reads_your_own_rows_as_it_says(tmp_path):
    page = (ROOT / "datasets" / "README.md").read_text(encoding="utf-8")
    section = page.split("## From your own rows")[1].split("\n## ")[0]
    blocks = re.findall(r"```(\w+)\n(.*?)```", section, re.DOTALL)
    assert [kind for kind, _ in blocks] == ["python", "text", "python"]
    (_, from_list), (_, sheet), (_, from_sheet) = blocks
    (tmp_path / "mine.csv").write_text(sheet, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-c", from_list + from_sheet],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip() == from_sheet.split("# ")[1].strip()


@pytest.mark.parametrize("name", DATASETS)
def test_the_rows_of_a_dataset_alone_make_the_same_recording_and_model(name, tmp_path):
    recording = rl.read_recording(name)
    path = tmp_path / "mine.csv"
    path.write_bytes((ROOT / "datasets" / name / "transitions.csv").read_bytes())
    back = rl.read_recording(path, task=name)
    for column in (*Transitions._fields, "episode", "step"):
        np.testing.assert_array_equal(getattr(back, column), getattr(recording, column))
    models = [rl.SampleModel.from_recording(rows) for rows in (recording, back)]
    for field in fields(rl.SampleModel):
        one, other = (getattr(model, field.name) for model in models)
        np.testing.assert_array_equal(one, other)
