"""New task files, and what a look at a task says."""

import ast
import importlib
from dataclasses import replace

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu import InputVariable
from rlrobot_edu.robots.arm.arm_body import joints
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS
from rlrobot_edu.tools.blind import BLIND
from rlrobot_edu.tools.trial import acting, at_random

check_task_module = importlib.import_module("rlrobot_edu.tools.check_task")


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


@pytest.mark.parametrize("robot", ROBOTS)
def test_there_is_a_file_to_begin_with_for_each_robot(robot, tmp_path):
    path = rl.new_task("mine", tmp_path, robot=robot)
    task, text = rl.load_task(path), path.read_text(encoding="utf-8")
    assert task.robot == robot and "Each number must stand in `rewards`" in text
    assert all(f"#   {name} " in text for name in ROBOTS[robot].sensors | ROBOTS[robot].commands)
    engine = "kinematic" if "kinematic" in ROBOTS[robot].engines else None
    with rl.make_env(task, seed=0, engine=engine) as env:
        rl.learn(rl.Agent(task, seed=0), env, steps=30, progress=False)


def test_a_file_for_a_robot_that_there_is_not_is_refused(tmp_path):
    with pytest.raises(ValueError, match="did you mean 'arm'"):
        rl.new_task("mine", tmp_path, robot="amr")
    assert not [*tmp_path.iterdir()]


def test_the_card_and_the_file_say_where_the_joints_of_the_arm_stop(tmp_path):
    for robot in ("arm", "mobile_manipulator"):
        assert {name: (stop.low, stop.high) for name, stop in ROBOTS[robot].stops.items()} == {
            name: joints()[name].limits for name in JOINTS
        }
    text = rl.new_task("reach", tmp_path, robot="arm").read_text(encoding="utf-8")
    assert "#   biceps             0.4 to 1.03 rad" in text and '"biceps": 0.0' in text


def test_who_leaves_a_joint_out_is_told_to_hold_it_still_with_a_fixed_number():
    task = replace(rl.load_task("arm_1k"), command=None)
    with pytest.raises(ValueError, match=r"arm, biceps, forearm \(a fixed number for what is to hold still\)"):
        task.command_for(0)


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
    assert "laser_rear: bin 1 (4.9–5 m) was never reached; it read 0." in said
    assert "laser_rear is always in the same bin" in said
    assert "the reward 5 was never given" in said and "the reward 10 was never given" in said
    assert "action 2 (left_wheel 1, right_wheel 0) does the same as action 0" in said
    assert "action 0 (left_wheel 0, right_wheel 0) changes nothing" in said
    assert "not significantly better than chance" in said


def test_a_check_is_shown_as_text_and_as_html(odd_check):
    text, page = repr(odd_check), odd_check._repr_html_()
    for finding in odd_check.findings:
        assert f"- {finding}" in text
    assert page.count("<table") == 5 and page.count("<li>") == len(odd_check.findings)


def test_a_good_task_is_learned(capsys):
    check = rl.check_task("worked_example", steps=200)
    assert not any("better than chance" in finding for finding in check.findings)
    assert repr(rl.check_task("worked_example", steps=200)) == repr(check), "one seed, one report"


@pytest.mark.long
def test_a_reward_that_can_be_had_without_looking_is_told():
    """With five speeds a circle pays 10 in each step; with the three of wander_1k none does."""
    circle, none = (
        [finding for finding in rl.check_task(task, 600).findings if finding.endswith("it pays not to look.")]
        for task in ("wander_4k", "wander_1k")
    )
    assert "sees nothing" in circle[0] and "for ever earns 10.00" in circle[1] and none == []
    assert all("(p = " in finding for finding in circle)


def test_it_pays_not_to_look_only_where_the_difference_is_more_than_luck():
    def found(blind):
        agents, chance = np.arange(8.0), np.arange(8.0) - 100
        final = {check_task_module.METHOD: agents, check_task_module.CHANCE: chance}
        return [*check_task_module._odd_learning(final | {check_task_module.SEES_NOTHING: blind}, 100)]

    assert found(np.arange(8.0) + 0.5) == []
    (finding,) = found(np.arange(8.0) + 9)
    assert finding.endswith("after 100 steps (p = 7.8e-05): it pays not to look.")


def test_one_action_for_ever_is_measured_as_agents_are(monkeypatch):
    """Over a whole run of the same length, by as many robots; here every action pays 10 from the 60th step on."""
    paid = []
    real = check_task_module.acting

    def acting(task, actions, seed):
        trial = real(task, actions, seed)
        trial.transitions.r[:] = np.where(np.arange(len(actions)) < 60, 0.0, 10.0)
        paid.append(len(actions))
        return trial

    monkeypatch.setattr(check_task_module, "acting", acting)
    check = rl.check_task("wander_simple", steps=100)
    *_, (who, mean, spread) = check.learner.rows
    assert who.endswith("for ever") and (mean, spread) == (4.0, 0.0) and paid == [25] * 4 + [100] * 8


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


def test_a_trial_knows_how_far_each_reading_went():
    task = rl.load_task("wander_simple")
    trial = acting(task, [3] * 20, 0)
    with rl.make_env(task, seed=0) as env:
        seen = [env.reset()[1]["readings"], *(env.step(3)[4]["readings"] for _ in range(20))]
    for name, (low, high) in trial.read.items():
        read = [readings[name] for readings in seen]
        assert (low, high) == pytest.approx((min(read), max(read)), abs=1e-4)


def test_the_report_shows_readings_beside_their_cuts(odd_check):
    rows = {row[0]: row for row in odd_check.readings.rows}
    _, unit, low, high, least, most, cuts = rows["laser_rear"]
    assert (unit, least, most, cuts) == ("m", "0", "5", "4.9") and float(low) < float(high) < 4.9
    assert rows["laser_front"][-1] == "" and rows.keys() == ROBOTS["mobile_base"].sensors.keys()


def parking():
    """Park in a corner, and begin anew after a minute: a place is x and y together."""

    def away(readings):
        return np.hypot(readings["x"] - 0.5, readings["y"] + 0.5)

    def reward(before, after):
        gained = away(before) - away(after)
        return 10 if away(after) < 0.25 else 1 if gained > 0.02 else -1 if gained < -0.02 else -0.4

    inputs = [InputVariable(name, cuts=[-0.25, 0.25], unit="m") for name in ("x", "y")]
    return replace(
        rl.load_task("wander_simple"),
        inputs=[*inputs, InputVariable("theta", sectors=8, unit="rad")],
        rewards=[-1, -0.4, 1, 10],
        reward=reward,
        command=None,
        episode_steps=60,
    )


@pytest.mark.long
def test_of_inputs_without_which_agents_earn_less_none_is_called_useless():
    check = rl.check_task(parking(), steps=1000)
    earned = {row[0]: row[1] for row in check.learner.rows}
    assert all(earned[f"TOSL+QBIASSR without {name}"] < earned["TOSL+QBIASSR"] - 1 for name in ("x", "y", "theta"))
    assert not any("Is it needed?" in finding for finding in check.findings)


@pytest.mark.long
def test_an_input_that_only_makes_learning_slow_is_asked_about():
    """Heading tells nothing in a square; in many sectors it makes many states."""
    task = rl.load_task("wander_simple")
    compass = replace(task, inputs=[*task.inputs, InputVariable("theta", sectors=64, unit="rad")])
    asked = [finding for finding in rl.check_task(compass, steps=1000).findings if "Is it needed?" in finding]
    assert len(asked) == 1 and "without theta" in asked[0]


def test_all_kinds_of_learners_have_random_numbers_of_their_own(monkeypatch):
    seeds = []
    real = check_task_module.repeat

    def repeat(*arguments, seed, **more):
        seeds.append(seed)
        return real(*arguments, seed=seed, **more)

    monkeypatch.setattr(check_task_module, "repeat", repeat)
    rl.check_task("wander_simple", steps=100)
    assert len(seeds) == len(set(seeds)) == 5, "those that look, at random, blind, and without each of two inputs"
