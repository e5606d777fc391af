"""New task files, and what a look at a task says."""

import ast
import importlib
import re
from dataclasses import replace

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_edu import InputVariable, OutputVariable
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.arm.arm_body import joints
from rlrobot_edu.task.robot_cards import JOINTS, ROBOTS
from rlrobot_edu.tools.blind import BLIND
from rlrobot_edu.tools.check_task import check_task
from rlrobot_edu.tools.new_task import new_task
from rlrobot_edu.tools.trial import acting, learning

check_task_module = importlib.import_module("rlrobot_edu.tools.check_task")


def test_a_new_task_works_as_it_stands(tmp_path):
    path = new_task("follow_wall", tmp_path)
    task = rl.load_task(path)
    assert task.name == "follow_wall" and "Follow wall" in task.description
    with rl.make_env(task, seed=0) as env:
        rl.learn(rl.Agent(task, seed=0), env, steps=50, progress=False)
    with pytest.raises(FileExistsError, match="is there already"):
        new_task("follow_wall", tmp_path)


@pytest.mark.parametrize("name", ["Wall", "my task", "../up", "", "9lives", None])
def test_not_every_name_is_that_of_a_task(name, tmp_path):
    with pytest.raises(ValueError, match="small letters"):
        new_task(name, tmp_path)


def test_the_template_names_every_sensor_with_its_unit(tmp_path):
    text = new_task("a", tmp_path).read_text(encoding="utf-8")
    assert "laser_rear_right" in text and "-3.14159 to 3.14159 rad" in text
    ast.parse(text)


@pytest.mark.parametrize("robot", ROBOTS)
def test_there_is_a_file_to_begin_with_for_each_robot(robot, tmp_path):
    path = new_task("mine", tmp_path, robot=robot)
    task, text = rl.load_task(path), path.read_text(encoding="utf-8")
    assert task.robot == robot and "`rewards` below must list each number" in text
    assert all(
        f"#   {name} " in text
        for name in ROBOTS[robot].sensors | ROBOTS[robot].commands
    )
    engine = "kinematic" if "kinematic" in ROBOTS[robot].engines else None
    with rl.make_env(task, seed=0, engine=engine) as env:
        rl.learn(rl.Agent(task, seed=0), env, steps=30, progress=False)


def test_the_file_says_where_x_is_0_and_how_far_the_floor_reaches(tmp_path):
    told = new_task("mine", tmp_path).read_text(encoding="utf-8").replace("\n    #", "")
    sizes = {
        "square_2x2": "1 m to each side in",
        "maze_6x6": "2.9 m in",
        "maze_4x4_goal": "2 m in",
    }
    for scene, size in sizes.items():
        assert f"{size} {scene}" in told
        assert np.abs(ARENAS[scene].bounds) == pytest.approx(
            float(size.split()[0]), abs=0.06
        )
    assert np.abs(ARENAS["hexagon_giraff"].bounds).tolist() == [0.75, 0.5, 0.75, 0.5]
    assert (
        "reaches 0.75 m along x and 0.5 m along y"
        in new_task("b", tmp_path, robot="giraff").read_text()
    )
    assert set(np.abs(ARENAS["table_room"].bounds)) == {1.5}
    assert (
        "reaches 1.5 m to each side"
        in new_task("c", tmp_path, robot="mobile_manipulator").read_text()
    )


def test_a_file_for_a_robot_that_there_is_not_is_refused(tmp_path):
    with pytest.raises(ValueError, match="did you mean 'arm'"):
        new_task("mine", tmp_path, robot="amr")
    assert not [*tmp_path.iterdir()]


def test_the_card_and_the_file_say_where_the_joints_of_the_arm_stop(tmp_path):
    for robot in ("arm", "mobile_manipulator"):
        assert {
            name: (stop.low, stop.high) for name, stop in ROBOTS[robot].stops.items()
        } == {name: joints()[name].limits for name in JOINTS}
    text = new_task("reach", tmp_path, robot="arm").read_text(encoding="utf-8")
    assert "#   biceps             0.4 to 1.03 rad" in text and '"biceps": 0.0' in text


def test_who_leaves_a_joint_out_is_told_to_hold_it_still_with_a_fixed_number():
    task = replace(rl.load_task("arm_1k"), command=None)
    with pytest.raises(
        ValueError,
        match=r"arm, biceps, forearm \(a fixed number for what is to hold still\)",
    ):
        task.command_for(0)


def test_an_edited_file_is_read_anew(tmp_path):
    path = new_task("mine", tmp_path)
    before = rl.load_task(path)
    path.write_text(
        path.read_text(encoding="utf-8").replace("cuts=[0.20]", "cuts=[0.20, 0.50]"),
        encoding="utf-8",
    )
    assert (before.states.n, rl.load_task(path).states.n) == (4, 9)


@pytest.fixture(scope="module")
def odd_check(tmp_path_factory):
    """A task in which everything that can be odd is odd."""
    path = new_task("odd", tmp_path_factory.mktemp("tasks"))
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
    return check_task(path, steps=300)


def test_what_is_odd_is_found(odd_check):
    said = "\n".join(odd_check.findings)
    assert "laser_rear: bin 1 (4.9–5 m) was never reached; it read 0." in said
    assert "laser_rear is always in the same bin" in said
    assert (
        "the reward 5 was never given" in said
        and "the reward 10 was never given" in said
    )
    assert "action 2 (left_wheel 1, right_wheel 0) does the same as action 0" in said
    assert "action 0 (left_wheel 0, right_wheel 0) changes nothing" in said
    assert "Q+RANDOM earns" in said and "looking is not shown to pay" in said


def test_a_check_is_shown_as_text_and_as_html(odd_check):
    text, page = repr(odd_check), odd_check._repr_html_()
    for finding in odd_check.findings:
        assert f"- {finding}" in text
    assert page.count("<table") == 5 and page.count("<li>") == len(odd_check.findings)


def test_a_check_says_whether_learning_is_compiled(odd_check, tmp_path):
    assert "are plain functions" in repr(odd_check).splitlines()[0]
    assert "are plain functions" in odd_check._repr_html_()
    path = new_task("power", tmp_path)
    text = path.read_text(encoding="utf-8").replace("moved > 0.07", "moved ** 2 > 0.07")
    path.write_text(text, encoding="utf-8")
    said = check_task_module._speed(rl.load_task(path))
    assert re.search(r"plain loop: power.py:\d+: “moved \*\* 2” is not plain", said)
    assert check_task_module._speed(rl.load_task("worked_example")) == ""


def test_a_good_task_is_learned(capsys):
    check = check_task("worked_example", steps=200)
    assert not any("not shown to pay" in finding for finding in check.findings)
    assert repr(check_task("worked_example", steps=200)) == repr(check), (
        "one seed, one report"
    )


@pytest.mark.long
def test_a_reward_that_can_be_had_without_looking_is_told():
    """With five speeds a circle pays 10 in each step; with the three of wander_1k none does."""
    circle, none = (
        [
            finding
            for finding in check_task(task, 600).findings
            if finding.endswith("it pays not to look.")
        ]
        for task in ("wander_4k", "wander_1k")
    )
    assert (
        "sees nothing" in circle[0]
        and "for ever earns 10.00" in circle[1]
        and none == []
    )
    assert all("(p = " in finding for finding in circle)


def compared(pairs=10, **earned):
    """What a report says of agents that earned these rewards, beside the default method.

    They had 100 steps in a task with so many pairs of state and action.
    """
    final = {
        check_task_module.METHOD: np.arange(8.0),
        check_task_module.CHANCE: np.arange(8.0) - 100,
        **earned,
    }
    rows = [
        (who, x.mean(), x.std(), *check_task_module._against(x, np.arange(8.0)))
        for who, x in final.items()
    ]
    rows[0] = (*rows[0][:3], "", None)
    return [*check_task_module._odd_learning(rows, 100, pairs, "do this")]


def test_looking_pays_only_where_agents_are_significantly_above_the_best_robot_that_does_not_look():
    assert compared(blind=np.arange(8.0) - 9) == []
    for blind in (
        np.arange(8.0),
        np.arange(8.0) - 1,
        np.arange(8.0) + 1,
        np.full(8, 3.5),
    ):
        finding, advice = compared(blind=blind)
        assert (
            finding.endswith(": looking is not shown to pay.") and advice == "do this"
        )
    finding, advice = compared(blind=np.arange(8.0) + 9)
    assert (
        finding.endswith("after 100 steps (p = 7.8e-05): it pays not to look.")
        and advice == "do this"
    )


def test_an_input_is_needed_only_where_agents_without_it_earn_significantly_less():
    without = check_task_module.WITHOUT
    (finding,) = compared(
        **{f"{without}x": np.arange(8.0) - 9, f"{without}y": np.arange(8.0) - 1}
    )
    assert finding.startswith(
        "y is not shown to be needed: without it agents earn 2.50, with it 3.50 after 100 steps"
    )
    (finding,) = compared(**{f"{without}y": np.arange(8.0) + 9})
    assert (
        finding.startswith("y hinders so far: ")
        and "(p = 7.8e-05). Give more steps first; leave it out only if" in finding
    )
    both = {f"{without}x": np.arange(8.0) - 1, f"{without}y": np.arange(8.0) + 9}
    assert len(compared(**both)) == 2
    # After too few steps, neither can be told, and nothing else is said of them.
    (finding,) = compared(pairs=11, **both)
    assert finding == (
        "too few steps to tell whether x, y can be spared: 100 for 11 pairs of state and action."
    )
    assert compared(pairs=11, **{f"{without}x": np.arange(8.0) - 9}) == []
    unlearned = {
        check_task_module.CHANCE: np.arange(8.0),
        f"{without}y": np.arange(8.0),
    }
    assert [finding[:14] for finding in compared(**unlearned)] == [
        "Q+RANDOM earns",
        "do this",
    ]


def square(pays, **changed):
    """A robot in a square that is paid for what `pays` says of its readings, whatever it did."""
    wheels = [
        OutputVariable(f"{side}_wheel", values=[-1, 1], unit="rad/s")
        for side in ("left", "right")
    ]
    lasers = [
        InputVariable(name, cuts=[0.3], unit="m")
        for name in ("laser_front", "laser_left")
    ]
    known = {
        "inputs": lasers,
        "outputs": wheels,
        "rewards": [-0.4, 10],
        "command": None,
    }
    reward = {"reward": lambda before, after: 10 if pays(after) else -0.4}
    return replace(rl.load_task("wander_simple"), **{**known, **reward, **changed})


@pytest.mark.long
def test_a_task_that_one_action_repeated_solves_as_well_is_not_blessed():
    """It is paid for looking to one side, which a robot that turns for ever does half of the time."""
    check = check_task(square(lambda readings: readings["theta"] > 0.2), steps=300)
    assert "for ever earns" in check.findings[-2] and check.findings[-2].endswith(
        "looking is not shown to pay."
    )
    assert check.findings[-1].startswith(
        "give more steps, pay for what only a robot that looks can do"
    )
    assert {row[3] for row in check.learner.rows[1:]} == {"not shown"}


@pytest.mark.long
def test_a_reward_that_is_met_too_seldom_is_named_with_the_times_and_the_state():
    """It is paid in one far corner."""
    check = check_task(
        square(lambda readings: readings["x"] < -0.6 and readings["y"] < -0.2),
        steps=300,
    )
    *_, (_, _, drawn, _, _), (reward, who, learned, share, state) = check.rewards.rows
    assert (reward, who, share) == (
        "10",
        "while learning",
        f"{learned / 300:.1%}",
    ) and 0 <= drawn < 15 > learned > 0
    times = f"{drawn} of 300 steps at random, {learned} while learning, most often from: {state}"
    assert check.findings[-1].startswith(
        f"the reward 10 is rare, a likely reason: {times}. Pay for what leads there"
    )
    assert state.startswith("laser_front 0.3–5 m, laser_left ")


def test_all_steps_are_counted_among_the_rewards(odd_check):
    for robot in ("at random", "while learning"):
        assert (
            sum(steps for _, who, steps, *_ in odd_check.rewards.rows if who == robot)
            == 300
        )
    assert all(
        bool(state) == bool(steps) for _, _, steps, _, state in odd_check.rewards.rows
    )


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
    check = check_task("wander_simple", steps=100)
    *_, (who, mean, spread, *_) = check.learner.rows
    assert (
        who.endswith("for ever")
        and (mean, spread) == (4.0, 0.0)
        and paid == [25] * 4 + [100] * 8
    )


def test_who_sees_nothing_learns_the_same_wherever_it_is():
    agent, env = (
        rl.Agent("wander_1k", BLIND, seed=0, loop_evasion=False),
        rl.make_env("wander_1k", seed=0),
    )
    history = rl.learn(agent, env, 300, progress=False)
    assert agent.q[0].any() and not agent.q[1:].any() and agent.visits[1:].any()
    assert np.isfinite(history.rewards).all()


def test_too_few_steps_say_nothing():
    with pytest.raises(
        ValueError, match="steps must be a whole number of at least 100"
    ):
        check_task("wander_simple", steps=5)


def test_a_random_trial_goes_on_after_the_end_of_an_episode():
    task = replace(rl.load_task("wander_simple"), episode_steps=20)
    trial = learning(task, 100, np.random.SeedSequence(0), "Q+RANDOM")
    assert trial.transitions.truncated.sum() == 5 and trial.moved.any()


def test_a_trial_knows_how_far_each_reading_went():
    task = rl.load_task("wander_simple")
    trial = acting(task, [3] * 20, 0)
    with rl.make_env(task, seed=0) as env:
        seen = [
            env.reset()[1]["readings"],
            *(env.step(3)[4]["readings"] for _ in range(20)),
        ]
    for name, (low, high) in trial.read.items():
        read = [readings[name] for readings in seen]
        assert (low, high) == pytest.approx((min(read), max(read)), abs=1e-4)


def test_the_report_shows_readings_beside_their_cuts(odd_check):
    rows = {row[0]: row for row in odd_check.readings.rows}
    _, unit, low, high, least, most, cuts = rows["laser_rear"]
    assert (unit, least, most, cuts) == ("m", "0", "5", "4.9") and float(low) < float(
        high
    ) < 4.9
    assert (
        rows["laser_front"][-1] == ""
        and rows.keys() == ROBOTS["mobile_base"].sensors.keys()
    )


def parking():
    """Park in a corner and stand there, and begin anew after a minute: a place is x and y together."""

    def away(readings):
        return np.hypot(readings["x"] - 0.5, readings["y"] + 0.5)

    def reward(before, after):
        gained = away(before) - away(after)
        return (
            10
            if away(after) < 0.25
            else 1
            if gained > 0.02
            else -1
            if gained < -0.02
            else -0.4
        )

    inputs = [InputVariable(name, cuts=[-0.25, 0.25], unit="m") for name in ("x", "y")]
    return replace(
        rl.load_task("wander_simple"),
        inputs=[*inputs, InputVariable("theta", sectors=8, unit="rad")],
        outputs=[
            OutputVariable(f"{side}_wheel", values=[-1, 0, 1], unit="rad/s")
            for side in ("left", "right")
        ],
        rewards=[-1, -0.4, 1, 10],
        reward=reward,
        command=None,
        episode_steps=60,
    )


@pytest.mark.long
def test_of_inputs_without_which_agents_earn_less_none_is_called_useless():
    check = check_task(parking(), steps=1000)
    earned = {row[0]: row[1] for row in check.learner.rows}
    assert all(
        earned[f"TOSL+QBIASSR without {name}"] < earned["TOSL+QBIASSR"] - 1
        for name in ("x", "y", "theta")
    )
    assert not any(
        "hinders" in finding or "to look" in finding for finding in check.findings
    )


def test_after_too_few_steps_no_input_is_called_useless():
    """All three are needed, see the test above; 300 steps cannot tell."""
    findings = check_task(parking(), steps=300).findings
    about_inputs = [
        text for text in findings if "without it" in text or "spare" in text
    ]
    for text in about_inputs:
        assert text.startswith("too few steps to tell whether ")
        assert text.endswith(" can be spared: 300 for 648 pairs of state and action.")
    assert len(about_inputs) <= 1 and "eave it out" not in " ".join(findings)


@pytest.mark.long
def test_of_an_input_that_only_makes_learning_slow_few_steps_tell_nothing():
    """Heading tells nothing in a square; in many sectors it makes many states."""
    task = rl.load_task("wander_simple")
    compass = replace(
        task, inputs=[*task.inputs, InputVariable("theta", sectors=64, unit="rad")]
    )
    asked = [
        text for text in check_task(compass, steps=1000).findings if "theta" in text
    ]
    (due,) = asked
    assert due.startswith("too few steps to tell whether ") and due.endswith(
        "theta can be spared: 1000 for 1024 pairs of state and action."
    )


@pytest.mark.long
def test_an_input_that_no_reward_depends_on_is_not_shown_to_be_needed():
    task = rl.load_task("wander_simple")
    rear = replace(
        task, inputs=[*task.inputs, InputVariable("laser_rear", cuts=[0.3], unit="m")]
    )
    check = check_task(rear, steps=400)
    asked = [
        finding for finding in check.findings if "is not shown to be needed" in finding
    ]
    assert len(asked) == 1 and asked[0].startswith("laser_rear ")


def test_all_kinds_of_learners_have_random_numbers_of_their_own(monkeypatch):
    seeds = []
    real = check_task_module.run

    def run(jobs, **more):
        seeds.extend(job.args[-1] for job in jobs.values())
        return real(jobs, **more)

    monkeypatch.setattr(check_task_module, "run", run)
    check_task("wander_simple", steps=100)
    kinds = 5  # those that look, at random, blind, and without each of two inputs
    distinct = {(seed.entropy, seed.spawn_key) for seed in seeds}
    assert len(seeds) == len(distinct) == kinds * check_task_module.LEARNERS
