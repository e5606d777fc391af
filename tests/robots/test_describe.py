"""What every view of a robot shares: its scenes, its path, and the sentence for readers who hear a page."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest

import rlrobot_edu as rl
from rlrobot_edu.show.describe import (
    as_scenes,
    describe,
    gap_of,
    key_words,
    path_of,
    rules_met,
    rules_of,
    task_of,
)
from rlrobot_edu.show.story import AT_OBJECT, caption, nearest_step

TASKS = sorted(
    path.stem for path in Path(rl.load_task("arm_1k").path).parent.glob("*.py")
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
    assert f": {most:g}" not in rules_met(rules, [float(least)])
    env.close()


@pytest.mark.parametrize("name", TASKS)
def test_every_reward_of_every_task_is_explained_by_one_of_its_rules(name):
    """All that a task may pay, and what a short drive does pay: nothing is told as a bare number."""
    env = rl.make_env(name, seed=0)
    rules = rules_of(env)
    assert rules
    drive = rl.film(rl.Agent(name, seed=0), env, steps=30)
    for rewards in (drive.rewards, env.unwrapped.task.rewards):
        told = rules_met(rules, rewards)
        assert told.startswith("Rewards: ") and "Also" not in told
        for reward in set(rewards):
            assert f"{reward:g}".replace("-", "−") in told
    env.close()


def test_a_reward_that_no_rule_explains_is_told_with_its_number_of_steps():
    rules = "at the goal: 10; else −0.02"
    rewards = [10.0, -0.02, 5.0, 5.0, 10.0]
    assert rules_met(rules, rewards) == f"Rewards: {rules}. Also +5 in 2 steps."
    assert rules_met("", [1.0, 1.0, -0.4]) == (
        "Rewards: +1 in 2 steps, −0.4 in 1 step."
    )
    many = rules_met("", [float(i) for i in range(1, 7)])
    assert many.endswith("+4 in 1 step, 2 other amounts.")
    # a number in a condition is no reward, and a minus may be short
    assert rules_met("moved 10 m: -2", [-2.0, 10.0]).endswith(
        ": -2. Also +10 in 1 step."
    )
    assert rules_met("at the goal: 10", []) == ""


def test_the_point_of_a_number_does_not_end_the_name_of_a_task():
    env = SimpleNamespace(
        unwrapped=SimpleNamespace(
            task=SimpleNamespace(description="Park at x = 0.5, and stay. It is slow.")
        )
    )
    assert task_of(env) == "Park at x = 0.5, and stay"


@pytest.mark.parametrize("name", ["arm_1k", "arm_4k"])
def test_an_arm_reaches_its_object_in_the_step_that_is_first_paid_for_it(name):
    agent, env = rl.Agent(name, "Q+EG", seed=3), rl.make_env(name, seed=3)
    rl.learn(agent, env, steps=3000, progress=False)
    film = rl.film(agent, env, steps=60)
    assert 10.0 in film.rewards
    first = film.rewards.index(10.0)
    assert nearest_step(film.frames) == first
    assert f"reached in step {first + 1}" in film.finding
    at = [gap_of(scene) <= AT_OBJECT for scene in film.frames]
    assert at == [reward == 10.0 for reward in film.rewards]
    told = caption(film.frames, film.rewards, first)
    assert f"Step {first + 1}: reaches the object, reward +10, sum " in told


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
