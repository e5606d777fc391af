"""What every view of a robot shares: its scenes, its path, and the sentence for readers who hear a page."""

import re

import pytest

import rlrobot_edu as rl
from rlrobot_edu.show.describe import (
    as_scenes,
    describe,
    key_words,
    path_of,
    rules_met,
    rules_of,
)

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


@pytest.mark.parametrize("name", ["arm_1k", "wander_1k", "navigation_1k"])
def test_the_rules_are_the_tasks_own_words_and_only_those_that_were_met_are_told(name):
    env = rl.make_env(name)
    rules = rules_of(env)
    words = " ".join(env.unwrapped.task.description.split())
    assert f"Rewards: {rules}." in words
    least, most = min(env.unwrapped.task.rewards), max(env.unwrapped.task.rewards)
    told = rules_met(rules, [float(most)])
    assert told.startswith("Rewards: ") and told.endswith(f": {most:g}.")
    assert f"{most:g}" not in rules_met(rules, [float(least)])
    assert rules_met(rules, [0.123]) == "" and rules_met("", [float(most)]) == ""
    env.close()


def test_the_key_of_an_arm_says_what_its_rewards_and_marks_mean():
    env = rl.make_env("arm_1k")
    env.reset()
    scene = env.unwrapped.robot.scene()
    told = key_words(scene, rules_of(env), [10.0, -1.0])
    assert told.startswith("It reaches for the yellow object. The pale field is ")
    assert "gripper within 0.05 m of the object: 10; further away" in told
    assert told.endswith(": −1.") and "laser" not in told
    base = rl.make_env("wander_1k")
    base.reset()
    assert "laser" in key_words(base.unwrapped.robot.scene(), "", [])
