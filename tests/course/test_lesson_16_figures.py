"""Lesson 16: its files are kept, its faults are refused or found."""

import pytest

import rlrobot_edu as rl
from rlrobot_course.exercises.design import paid_by
from rlrobot_course.lesson_16 import check, exercises
from rlrobot_course.lesson_16.exercises import CLUES
from rlrobot_course.lesson_16.files import edit, fresh_folder, refusal
from rlrobot_course.lesson_16.situations import PAIRS
from rlrobot_edu.tools.new_task import new_task


@pytest.fixture
def path(tmp_path):
    return new_task("follow_wall", fresh_folder(tmp_path / "files"))


def test_files_of_an_earlier_run_are_kept(path):
    path.write_text("mine")
    again = fresh_folder(path.parent)
    assert not path.exists() and (again / "before" / path.name).read_text() == "mine"
    fresh_folder(again)
    assert (again / "before" / path.name).read_text() == "mine", (
        "an empty run takes nothing away"
    )


def test_an_edit_changes_one_place_or_nothing(path):
    text = path.read_text(encoding="utf-8")
    copy = edit(path, {"cuts=[0.2, 0.5]": "cuts=[0.3, 0.5]"}, to="copy.py")
    assert copy.read_text(encoding="utf-8") != text == path.read_text(encoding="utf-8")
    for old in ("no such text", "laser_front_left"):
        with pytest.raises(ValueError, match="not once"):
            edit(path, {old: ""})


def test_a_refusal_names_the_file_without_its_folder(path):
    said = refusal(
        edit(path, {"rewards=[-2, -0.02, 10]": "rewards=[-2, 10]"}, to="faulty.py")
    )
    assert said.startswith("faulty.py: reward returned -0.02")


def test_situations_are_readings_of_the_robot():
    card = rl.make_env("wander_1k").unwrapped.robot.reset()
    for pair in PAIRS:
        for _, before, after in pair:
            assert before.keys() == after.keys() == card.keys()


def test_a_reward_of_ones_own_becomes_a_task():
    task = paid_by(rl.load_task("wander_1k"), exercises.follow_reward, PAIRS)
    assert set(task.rewards) == {-0.6, -0.4, 10}


def test_every_wrong_guess_of_the_faults_has_a_clue_that_helps():
    for mistake in check.faults.mistakes[1:]:
        clue = CLUES.index(mistake.hint)
        assert mistake.wrong[clue] != exercises.faults[clue]
        assert mistake.wrong[:clue] == exercises.faults[:clue]
