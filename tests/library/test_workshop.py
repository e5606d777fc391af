"""New task files, and what a look at a task says."""

import ast
import importlib
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.workshop.blind import BLIND
from rlrobot_edu.workshop.check_task import _odd_inputs
from rlrobot_edu.workshop.information import information
from rlrobot_edu.workshop.trial import at_random

check_task_module = importlib.import_module("rlrobot_edu.workshop.check_task")
RNG = np.random.default_rng(0)
N = 2000
COINS, DICE = RNG.integers(2, size=N), RNG.integers(6, size=N)
NOTHING = np.zeros(N, dtype=int)


@pytest.mark.parametrize(
    ("x", "y", "z", "bits", "is_real"),
    [
        (COINS, COINS, NOTHING, 1.0, True),  # a coin tells all about itself, one bit
        (COINS, COINS, COINS, 0.0, False),  # and nothing to who knows it already
        (COINS, DICE, NOTHING, 0.0, False),
        (COINS ^ (DICE % 2), COINS, NOTHING, 0.0, False),  # nothing alone,
        (COINS ^ (DICE % 2), COINS, DICE, 1.0, True),  # all together with the die
    ],
)
def test_information_in_bits(x, y, z, bits, is_real):
    found = information(x, y, z, np.random.default_rng(1))
    assert found.bits == pytest.approx(bits, abs=0.02) and found.is_real == is_real


def test_many_kinds_of_few_samples_seem_to_tell_nothing():
    x, y = RNG.integers(30, size=300), RNG.integers(30, size=300)
    assert information(x, y, np.zeros(300, dtype=int), np.random.default_rng(1)).bits < 0.15


def test_a_new_task_works_as_it_stands(tmp_path):
    path = rl.new_task("follow_wall", tmp_path)
    task = rl.load_task(path)
    assert task.name == "follow_wall" and "Follow wall" in task.description
    with rl.make_env(task, seed=0) as env:
        rl.learn(rl.Agent(task, seed=0), env, steps=50, progress=False)
    with pytest.raises(FileExistsError, match="is there already"):
        rl.new_task("follow_wall", tmp_path)


@pytest.mark.parametrize("name", ["Wall", "my task", "../up", "", "9lives", None])
def test_not_every_name_is_that_of_a_task(name, tmp_path):
    with pytest.raises(ValueError, match="small letters"):
        rl.new_task(name, tmp_path)


def test_the_template_names_every_sensor_with_its_unit(tmp_path):
    text = rl.new_task("a", tmp_path).read_text(encoding="utf-8")
    assert "laser_rear_right" in text and "-3.14159 to 3.14159 rad" in text
    ast.parse(text)


def test_an_edited_file_is_read_anew(tmp_path):
    path = rl.new_task("mine", tmp_path)
    before = rl.load_task(path)
    path.write_text(path.read_text(encoding="utf-8").replace("cuts=[0.20]", "cuts=[0.20, 0.50]"), encoding="utf-8")
    assert (before.states.n, rl.load_task(path).states.n) == (4, 9)


@pytest.fixture(scope="module")
def odd_check(tmp_path_factory):
    """A task in which everything that can be odd is odd."""
    path = rl.new_task("odd", tmp_path_factory.mktemp("tasks"))
    text = path.read_text(encoding="utf-8")
    command = "def command(wheels):\n    return {**wheels, 'left_wheel': 0.0}\n\n\n"
    for old, new in {
        'InputVariable("laser_front_left", cuts=[0.20], unit="m")': 'InputVariable("laser_rear", cuts=[4.9], unit="m")',
        "rewards=[-2, -0.02, 10]": "rewards=[-2, -0.02, 5, 10]",
        "task = Task(": f"{command}task = Task(\n    command=command,",
        "0.07 else": "7 else",
    }.items():
        assert old in text
        text = text.replace(old, new)
    path.write_text(text, encoding="utf-8")
    return rl.check_task(path, steps=300)


def test_what_is_odd_is_found(odd_check):
    said = "\n".join(odd_check.findings)
    assert "laser_rear: bin 1 (4.9–5 m) was never reached" in said
    assert "laser_rear is always in the same bin" in said
    assert "the reward 5 was never given" in said and "the reward 10 was never given" in said
    assert "action 2 (left_wheel 1, right_wheel 0) does the same as action 0" in said
    assert "action 0 (left_wheel 0, right_wheel 0) changes nothing" in said
    assert "not significantly better than chance" in said


def test_a_check_is_shown_as_text_and_as_html(odd_check):
    text, page = repr(odd_check), odd_check._repr_html_()
    for finding in odd_check.findings:
        assert f"- {finding}" in text
    assert page.count("<table") == 4 and page.count("<li>") == len(odd_check.findings)


def test_a_good_task_is_learned(capsys):
    check = rl.check_task("worked_example", steps=200)
    assert not any("better than chance" in finding for finding in check.findings)
    assert repr(rl.check_task("worked_example", steps=200)) == repr(check), "one seed, one report"


def test_a_reward_that_can_be_had_without_looking_is_told():
    """With five speeds a circle pays 10 in each step; with the three of wander_1k none does."""
    circle, none = (
        [finding for finding in rl.check_task(task).findings if finding.endswith("it pays not to look.")]
        for task in ("wander_4k", "wander_1k")
    )
    assert "sees nothing" in circle[0] and "for ever earns 10.00" in circle[1] and none == []


def test_who_sees_nothing_learns_the_same_wherever_it_is():
    agent, env = rl.Agent("wander_1k", BLIND, seed=0, loop_evasion=False), rl.make_env("wander_1k", seed=0)
    history = rl.learn(agent, env, 300, progress=False)
    assert agent.q[0].any() and not agent.q[1:].any() and agent.visits[1:].any()
    assert np.isfinite(history.rewards).all()


def test_too_few_steps_say_nothing():
    with pytest.raises(ValueError, match="steps must be a whole number of at least 100"):
        rl.check_task("wander_simple", steps=5)


def test_a_random_trial_goes_on_after_the_end_of_an_episode():
    task = replace(rl.load_task("wander_simple"), episode_steps=20)
    trial = at_random(task, 100, np.random.SeedSequence(0))
    assert trial.transitions.truncated.sum() == 5 and trial.moved.any()


def test_the_commands(tmp_path):
    def run(*words):
        call = [sys.executable, "-m", "rlrobot_edu", *words]
        return subprocess.run(call, capture_output=True, text=True, cwd=tmp_path, timeout=600)

    made = run("new-task", "mine")
    assert made.returncode == 0 and "check-task mine.py" in made.stdout
    assert "is there already" in run("new-task", "mine").stderr
    (tmp_path / "mine.py").write_text("task = 1")
    wrong = run("check-task", "mine.py")
    assert wrong.returncode == 1 and "must define task = Task" in wrong.stderr and "Traceback" not in wrong.stderr


PARKING = '''"""Park in the middle of the room: paid there alone, and only while standing still."""

import math

from rlrobot_edu import InputVariable, OutputVariable, Task


def reward(before, after):
    """10 on the spot, which is met seldom; else a little less than nothing."""
    return 10 if abs(after["x"] - 0.7) < 0.06 and abs(after["y"] + 0.6) < 0.06 else -0.02


task = Task(
    robot="mobile_base", scene="square_2x2",
    inputs=[InputVariable("x", cuts=[-0.5, 0, 0.5], unit="m"), InputVariable("y", cuts=[-0.5, 0, 0.5], unit="m")],
    outputs=[OutputVariable("left_wheel", values=[-1, 1], unit="rad/s"),
             OutputVariable("right_wheel", values=[-1, 1], unit="rad/s")],
    rewards=[-0.02, 10], reward=reward,
)
'''


@pytest.mark.parametrize(("seed", "steps"), [(0, 1000), (0, 2000), (3, 2000)])
def test_of_two_inputs_that_tell_something_only_together_none_is_called_useless(tmp_path, seed, steps):
    (tmp_path / "parking.py").write_text(PARKING, encoding="utf-8")
    trial = at_random(rl.load_task(tmp_path / "parking.py"), steps, np.random.SeedSequence(seed).spawn(3)[0])
    assert 0.02 < np.mean(trial.transitions.r == 10) < 0.1, "often enough that a word could be said"
    findings = rl.check_task(tmp_path / "parking.py", steps=steps, seed=seed).findings
    assert not any("Is it needed?" in finding for finding in findings)


@pytest.mark.parametrize("share", [0.02, 0.1])
def test_of_a_useless_input_there_is_a_word_only_where_the_largest_reward_is_no_rarity(share):
    task, steps = rl.load_task("wander_simple"), 2000
    r = np.where(np.arange(steps) % round(1 / share) == 0, max(task.rewards), min(task.rewards))
    s = np.arange(steps) % task.states.n
    seen = Transitions(s, 0 * s, r, s, s < 0, s < 0)
    said = [finding for finding in _odd_inputs(task, [seen, seen], [0, 1]) if "Is it needed?" in finding]
    assert len(said) == (2 if share > 0.02 else 0)


def test_learners_chance_and_who_sees_nothing_have_random_numbers_of_their_own(monkeypatch):
    seeds = []
    real = check_task_module.repeat

    def repeat(*arguments, seed, **more):
        seeds.append(seed)
        return real(*arguments, seed=seed, **more)

    monkeypatch.setattr(check_task_module, "repeat", repeat)
    rl.check_task("wander_simple", steps=100)
    assert len(seeds) == len(set(seeds)) == 3
