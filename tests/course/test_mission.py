"""The mission: each stage works alone, names what is missing, and finds what earlier stages have left."""

import itertools
import json
from types import SimpleNamespace

import pytest

import rlrobot_edu as rl
from rlrobot_course import mission


@pytest.mark.parametrize("stage", ["learn", "model", "plan", "rehearse"])
def test_a_stage_works_alone_and_names_what_is_missing(stage, tmp_path, capsys):
    getattr(mission, stage)(tmp_path / "mission")
    said = capsys.readouterr().out
    assert "wander_simple stands in" in said and f"Mission, {stage}:" in said


def test_a_task_file_travels_from_stage_to_stage(tmp_path, capsys):
    mission.drive(tmp_path, steps=300)
    assert rl.load_task(tmp_path / mission.TASK).name == "my_robot"
    mission.learn(tmp_path, steps=300)
    for stage in (mission.model, mission.plan, mission.rehearse):
        stage(tmp_path)
    mission.report(tmp_path, repetitions=2, steps=100)
    assert "stands in" not in (said := capsys.readouterr().out) and "Tukey: TOSL+QBIASSR − SARSA+SR" in said
    page = mission.page(tmp_path).read_text(encoding="utf-8")
    assert "# My mission: my_robot" in page and page.count("not yet.") == 1
    assert "**serve** (lesson 17): not yet." in page


def test_a_task_that_has_changed_does_not_go_with_its_old_recording_nor_its_old_agent(tmp_path, capsys):
    mission.drive(tmp_path, steps=100)
    mission.learn(tmp_path, steps=100)
    path = tmp_path / mission.TASK
    path.write_text(path.read_text(encoding="utf-8").replace("cuts=[0.20]", "cuts=[0.20, 0.5]"), encoding="utf-8")
    capsys.readouterr()
    mission.model(tmp_path)
    mission.rehearse(tmp_path, steps=50)
    said = capsys.readouterr().out
    assert "Your recording is of an older my_robot.py" in said and "has no agent of this task (lesson 11)" in said
    page = mission.page(tmp_path).read_text(encoding="utf-8")
    of = {line.split("**")[1]: "(Of an older my_robot.py.)" in line for line in page.splitlines() if "**" in line}
    assert of == dict.fromkeys(mission.STAGES, False) | {"drive": True, "learn": True}
    assert "(lesson 13): wander_simple: it knows" in page, "whose model it is"


def test_a_robot_that_goes_to_and_fro_is_known_by_how_far_it_gets(monkeypatch):
    places = itertools.cycle([{"x": 0.0, "y": 0.1}, {"x": 0.1, "y": 0.1}])
    env = SimpleNamespace(unwrapped=SimpleNamespace(robot=SimpleNamespace(readings=next(places))))

    def drive(agent, env, steps):
        for _ in range(steps):
            env.unwrapped.robot.readings = next(places)
            yield SimpleNamespace(r=10.0)

    monkeypatch.setattr(mission, "let_drive", drive)
    rewards, far = mission._driven(None, env, 30)
    assert rewards.mean() == 10 and "after 10 steps it is 0.00 m from where it was" in far


@pytest.mark.long
def test_an_arm_rehearses_what_an_arm_can(tmp_path, capsys):
    rl.new_task("my_robot", tmp_path, robot="arm")
    mission.rehearse(tmp_path, steps=50)
    assert "with slip 0.1 alone" in capsys.readouterr().out and mission.page(tmp_path).exists()


def test_a_file_of_ones_own_is_never_overwritten(tmp_path):
    mission.drive(tmp_path, steps=50)
    path = tmp_path / mission.TASK
    mine = path.read_text(encoding="utf-8") + "# mine\n"
    path.write_text(mine, encoding="utf-8")
    mission.drive(tmp_path, steps=50)
    assert path.read_text(encoding="utf-8") == mine


@pytest.mark.parametrize("notes", ["", "[1, 2]", json.dumps({"drive": "done", "more": 1})])
def test_damaged_notes_are_as_good_as_none(notes, tmp_path):
    (tmp_path / mission.NOTES).write_text(notes, encoding="utf-8")
    assert mission.page(tmp_path).exists()


@pytest.mark.long
def test_the_agent_drives_a_served_robot(tmp_path, capsys):
    mission.serve(tmp_path, steps=10)
    assert "a step over ROS" in capsys.readouterr().out
