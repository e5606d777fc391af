"""A task as a Gymnasium environment, and the robot of the worked example."""

import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import rlrobot_edu as rl
from rlrobot_edu.robots.cell_robot import CellRobot
from rlrobot_edu.task.task_file import available_tasks

TASKS = available_tasks()
BLIND = """
from rlrobot_edu import InputVariable, OutputVariable, Task

task = Task(
    robot="mobile_base", scene="square_2x2", inputs=[InputVariable("laser_front", cuts=[0.5], unit="m")],
    outputs=[OutputVariable("speed", values=[1, 2])], command=lambda v: {"left_wheel": v["speed"], "right_wheel": 1},
    rewards=[1], reward=lambda before, after: 1, episode_steps=5,
)
"""


@pytest.fixture
def my_task(tmp_path):
    path = tmp_path / "blind.py"
    path.write_text(BLIND)
    return path


@pytest.mark.parametrize("name", TASKS)
def test_gymnasium_finds_nothing_wrong_with_the_environment_of_any_task(name):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make(f"rlrobot/{name}-v0").unwrapped)


def test_gymnasium_makes_a_task_from_its_registered_name_alone():
    code = "import gymnasium; print(gymnasium.make('rlrobot_edu:rlrobot/wander_1k-v0').reset(seed=0)[1]['state'])"
    fresh = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert fresh.stdout.strip() == "1023"
    assert (
        gymnasium.make("rlrobot/wander_1k-v0", render_mode=None).unwrapped.task.name
        == "wander_1k"
    )


def run(env, steps=200):
    """States, rewards and readings of a run with fixed actions."""
    actions = np.random.default_rng(1).integers(env.action_space.n, size=steps)
    _, info = env.reset()
    seen = [(info["state"], info["readings"])]
    for action in actions:
        _, reward, _, _, info = env.step(action)
        seen.append((info["state"], reward, info["readings"]))
    return seen


def test_another_seed_moves_the_box_of_the_worked_example_differently():
    assert run(rl.make_env("worked_example", seed=0)) != run(
        rl.make_env("worked_example", seed=1)
    )


@pytest.mark.parametrize("name", TASKS)
def test_observation_state_and_readings_say_the_same(name):
    env = rl.make_env(name, seed=0)
    for action in range(env.action_space.n):
        env.reset()
        observation, reward, terminated, truncated, info = env.step(action)
        assert tuple(observation) == env.task.states.bins(info["state"])
        assert info["state"] == env.state == env.task.states.encode(info["readings"])
        assert reward in env.task.rewards
        assert not terminated and not truncated


def test_an_observation_is_the_callers_own(my_task):
    env = rl.make_env(my_task)
    observation, info = env.reset()
    observation[:] = 99
    info["readings"].clear()
    assert env.step(0)[0].max() <= 1
    assert env.reset()[0].max() <= 1


def test_an_episode_is_cut_off_after_its_steps_and_starts_anew_at_a_reset(my_task):
    env = rl.make_env(my_task)
    for _ in range(2):
        env.reset()
        assert [env.step(0)[2:4] for _ in range(5)] == [(False, False)] * 4 + [
            (False, True)
        ]


@pytest.mark.parametrize("reading", [5.5, -0.1, float("nan")])
def test_a_reading_out_of_range_is_reported_with_the_task_file_and_the_sensor(
    my_task, reading, monkeypatch
):
    env = rl.make_env(my_task)
    env.reset()
    monkeypatch.setattr(env.robot, "act", lambda command: {"laser_front": reading})
    with pytest.raises(ValueError, match="laser_front") as report:
        env.step(0)
    assert str(report.value).startswith(str(my_task))


@pytest.mark.parametrize("fails", ["reset", "act"])
def test_after_a_reading_out_of_range_only_a_reset_helps(my_task, fails, monkeypatch):
    env = rl.make_env(my_task)
    env.reset()
    env.step(0)
    with monkeypatch.context() as broken:
        broken.setattr(env.robot, fails, lambda _: {"laser_front": -1.0})
        with pytest.raises(ValueError, match="laser_front"):
            env.reset() if fails == "reset" else env.step(0)
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(0)
    env.reset()
    env.step(0)


@pytest.mark.parametrize("speed", ["9", "'fast'", "v['sped']"])
def test_a_task_whose_command_the_robot_cannot_carry_out_is_refused_with_its_file(
    my_task, speed
):
    my_task.write_text(BLIND.replace('v["speed"]', speed))
    with pytest.raises(ValueError, match="action 0") as refusal:
        rl.make_env(my_task)
    assert str(my_task) in str(refusal.value)


def test_an_action_that_does_not_exist_and_a_step_before_the_reset_are_refused():
    env = rl.make_env("wander_simple")
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(0)
    env.reset()
    for action in (-1, 4):
        with pytest.raises(ValueError, match="actions are the integers 0 to 3"):
            env.step(action)


def test_a_world_opens_no_window_of_its_own():
    with pytest.raises(ValueError, match="plot_scene"):
        rl.make_env("wander_simple", render_mode="human")


def test_an_unknown_engine_is_refused_and_the_known_ones_named():
    for make in (
        rl.make_env,
        lambda name, engine: gymnasium.make(f"rlrobot/{name}-v0", engine=engine),
    ):
        with pytest.raises(
            ValueError, match=r"no engine 'steam'\. It has: pymunk, pybullet, kinematic"
        ):
            make("wander_simple", engine="steam")


def test_the_cell_robot_never_leaves_its_cells_nor_enters_the_box_and_knows_what_is_ahead():
    rng = np.random.default_rng(0)
    robot = CellRobot("four_cells", 1.0)
    before = robot.reset(rng)
    ahead = {0: (1, 0), 90: (0, 1), -90: (0, -1)}
    moves = [
        {"advance": 1, "spin": 0},
        {"advance": 0, "spin": 90},
        {"advance": 0, "spin": -90},
    ]
    for move in np.random.default_rng(1).integers(3, size=2000):
        after = robot.act(moves[move])
        advanced = (after["X"], after["Y"]) != (before["X"], before["Y"])
        assert after["theta"] == min(
            max(before["theta"] + moves[move]["spin"], -90), 90
        )
        assert advanced == (move == 0 and not before["d"])
        assert after["bumped"] == (move == 0 and before["d"])
        solids = {solid.name: solid.pose[:2, 3] for solid in robot.scene().solids}
        distance = solids["box"] - solids["robot/body"]
        neighbour = (
            after["X"] + ahead[after["theta"]][0],
            after["Y"] + ahead[after["theta"]][1],
        )
        in_front = np.allclose(distance, ahead[after["theta"]])
        assert after["d"] == (in_front or not set(neighbour) <= {0, 1})
        assert np.abs(distance).max() > 0.5
        before = after


@pytest.mark.parametrize(
    "command", [{"advance": 1}, {"advance": 0.5, "spin": 0}, {"advance": 0, "spin": 45}]
)
def test_the_cell_robot_refuses_half_moves(command):
    with pytest.raises(ValueError, match="advance"):
        CellRobot("four_cells", 1.0).act(command)


@pytest.mark.parametrize("engine", ["", 0, [], "pymunkk"])
def test_only_none_leaves_the_choice_of_an_engine_to_the_robot(engine):
    with pytest.raises(
        ValueError, match=r"has no engine .* It has: pymunk, pybullet, kinematic"
    ):
        rl.make_env("wander_1k", engine=engine)


@pytest.mark.parametrize("task", ["wander_1k", "arm_1k"])
def test_the_settings_that_a_refusal_lists_are_named_once(task):
    with pytest.raises(ValueError, match="has no setting 'colour'") as refusal:
        rl.make_env(task, engine="kinematic", colour="red")
    names = str(refusal.value).partition("It has: ")[2].split(", ")
    assert "realism" in names and len(set(names)) == len(names)


@pytest.mark.parametrize(
    ("name", "setting", "near"),
    [("wander_1k", "engin", "engine"), ("wander_1k", "chasis", "chassis")],
)
def test_an_unknown_setting_is_refused_at_once_and_the_nearest_is_named(
    name, setting, near
):
    with pytest.raises(
        ValueError,
        match=f"'mobile_base' has no setting '{setting}'; did you mean '{near}'?",
    ):
        rl.make_env(name, **{setting: 1})
