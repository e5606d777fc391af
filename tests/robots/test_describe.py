"""What every view of a robot shares: its scenes, its path, and the sentence for readers who hear a page."""

import re

import pytest

import rlrobot_edu as rl
from rlrobot_edu.show.describe import as_scenes, describe, path_of

KINDS = [
    ("wander_1k", "room", "robot"),
    ("giraff_wander_1k", "room", "robot"),
    ("arm_1k", "table", "gripper"),
    ("mobile_arm_2k", "room", "robot"),
]


@pytest.mark.parametrize("engine", ["kinematic", None])
@pytest.mark.parametrize(("task", "place", "mover"), KINDS)
def test_the_sentence_says_what_the_robot_senses(task, place, mover, engine):
    if engine == "kinematic" and task.startswith("giraff"):
        engine = "pymunk"
    env = rl.make_env(task, engine=engine)
    _, info = env.reset()
    scene = env.unwrapped.robot.scene()
    sentence = describe(scene)
    assert sentence.startswith(f"A {place} of ")
    said = re.search(rf"the {mover} at x = (\S+), y = (\S+), heading", sentence)
    x, y = map(float, said.groups())
    sensed = info["readings"]
    if mover == "gripper":
        assert (x, y) == pytest.approx(
            (sensed["gripper_x"], sensed["gripper_y"]), abs=0.04
        )
    else:
        assert (x, y) == pytest.approx((sensed["x"], sensed["y"]), abs=0.06)
    assert path_of([scene])[0, :2] == pytest.approx((x, y), abs=0.06)
    env.close()


@pytest.mark.parametrize("wrong", [3, None, "room", [], [3], {}])
def test_what_is_no_scene_is_refused_in_one_sentence(wrong):
    with pytest.raises(ValueError, match="a picture needs an environment with a robot"):
        as_scenes(wrong)
