"""The robot that nobody has seen: what a secret decides, what is told of it, and what a drive is worth."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from itertools import pairwise

import joblib
import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course import __main__ as commands
from rlrobot_course.unknown_robot import commands as project_commands
from rlrobot_course.unknown_robot import scoring
from rlrobot_course.unknown_robot.body import SecretBody, rewards_of
from rlrobot_course.unknown_robot.scoring import Score, rulers, save_log, score
from rlrobot_course.unknown_robot.secret import unlock
from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.chassis import GIRAFF
from rlrobot_edu.robots.realism import Realism

TASK = "giraff_wander_1k"
SECRET = unlock("a secret of the tests")


def random_agent(seed=0):
    return rl.Agent(TASK, "Q+RANDOM", seed=seed)


def driven(secret=SECRET, steps=20, seed=0, agent=None):
    """A body that a random agent has driven."""
    body = SecretBody(TASK, secret, seed)
    rl.learn(
        agent or random_agent(),
        rl.make_env(TASK, link=body),
        steps=steps,
        progress=False,
    )
    return body


def test_a_secret_is_the_same_from_a_file_the_environment_or_said(
    tmp_path, monkeypatch
):
    (tmp_path / "secret.txt").write_text("a secret of the tests\n")
    monkeypatch.setenv("ROBOT", "a secret of the tests")
    assert unlock(f"file:{tmp_path / 'secret.txt'}") == unlock("env:ROBOT") == SECRET
    for empty in ("file:empty.txt", "env:NO_SUCH_NAME", " "):
        (tmp_path / "empty.txt").touch()
        monkeypatch.chdir(tmp_path)
        with pytest.raises(ValueError, match="no secret is there"):
            unlock(empty)
    with pytest.raises(FileNotFoundError):
        unlock("file:nowhere.txt")


def test_each_secret_has_all_weaknesses_in_sizes_and_a_wall_of_its_own_away_from_the_start():
    keys = np.random.default_rng(0)
    secrets = [SECRET._replace(key=keys.bytes(32)) for _ in range(200)]
    sizes = np.array([list(vars(secret.realism).values()) for secret in secrets])
    assert (sizes > 0).all() and set(sizes[:, 3]) == {1, 2, 3, 4}
    assert all(len(set(column)) == 200 for column in np.delete(sizes, 3, axis=1).T)
    arena = ARENAS["hexagon_giraff"]
    for secret in secrets:
        (wall,) = secret.with_wall(arena, GIRAFF.radius).walls[len(arena.walls) :]
        assert (
            min(np.hypot(*corner) for corner in wall.corners()) > GIRAFF.radius + 0.05
        )
        assert secret.with_wall(arena, GIRAFF.radius) == secret.with_wall(
            arena, GIRAFF.radius
        )


def test_the_rewards_in_the_log_are_those_of_the_true_readings():
    body, twin = driven(), SecretBody(TASK, SECRET, 0)
    env, true = rl.make_env(TASK, link=twin), [twin._base.readings]
    for _ in rl.steps(random_agent(), env, steps=20):
        true.append(twin._base.readings)
    assert body.log[9::10] == [twin.task.reward_for(*pair) for pair in pairwise(true)]
    assert all(
        twin.readings[name] != true[-1][name]
        for name in ("x", "y", "theta", "laser_left")
    )


def test_steps_are_counted_from_the_beginning_at_which_they_are_worth_most():
    log = np.zeros(40)
    log[[13, 23, 33]] = 5.0
    assert rewards_of(log, 10).tolist() == [0.0, 5.0, 5.0]
    assert rewards_of(log[4:], 10).tolist() == [5.0, 5.0]


def test_it_drives_no_faster_than_the_tasks_actions():
    slow, fast = SecretBody(TASK, SECRET, 0), SecretBody(TASK, SECRET, 0)
    for body, v in ((slow, 0.075), (fast, 10.0)):
        for _ in range(8):
            body.move(v, 0.0)
    assert fast.pose() == pytest.approx(slow.pose())
    assert slow.pose() != (0.0, 0.0, 0.0)


def test_a_log_is_scored_between_chance_and_the_best_found(tmp_path, monkeypatch):
    monkeypatch.setattr(scoring, "HOUR", 20.0)
    save_log(tmp_path / "drive.npz", body := driven(), SECRET)
    monkeypatch.setattr(scoring, "rulers", lambda task, secret: (-1.0, 3.0))
    result = score(tmp_path / "drive.npz", SECRET)
    assert result == Score(float(rewards_of(body.log[100:], 10).mean()), -1.0, 3.0)
    assert [Score(earned, -1.0, 3.0).points for earned in (-1.0, 3.0, -2.0, 4.0)] == [
        0,
        100,
        -25,
        125,
    ]


def test_a_log_that_is_changed_unsigned_or_too_short_has_no_score(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(scoring, "HOUR", 20.0)
    path = tmp_path / "drive.npz"
    save_log(path, driven(steps=10), SECRET)
    with pytest.raises(ValueError, match="has driven 10 s of its 20 s"):
        score(path, SECRET)
    with pytest.raises(ValueError, match="not signed"):
        score(path, unlock("another secret"))
    about, arrays = load_arrays(path, "drive", lambda about, arrays: (about, arrays))
    save_arrays(
        path, "drive", about, {"rewards": np.full_like(arrays["rewards"], 10.0)}
    )
    with pytest.raises(ValueError, match="not signed"):
        score(path, SECRET)


def test_a_task_with_episodes_has_no_unknown_robot():
    with pytest.raises(ValueError, match="has episodes"):
        SecretBody("navigation_1k", SECRET)


def test_random_actions_are_worth_0_and_the_best_driver_found_100(monkeypatch):
    """And nobody else is worth more; what each of them earned is measured as a learner's drive is."""
    drive, earned = scoring._drive, {}

    def driven_and_noted(task, secret, agent, seed, steps):
        mean, recording = drive(task, secret, agent, seed, steps)
        if seed == 0:  # the last drive of each, not its lessons
            earned[agent.method.name, agent.seed] = mean
        return mean, recording

    monkeypatch.setattr(scoring, "_drive", driven_and_noted)
    with joblib.parallel_config("threading"):
        random, found = rulers(rl.load_task(TASK), SECRET, seconds=20.0)
    assert len(earned) == 1 + scoring.PUPILS + 1
    points = {who: Score(mean, random, found).points for who, mean in earned.items()}
    assert points["Q+RANDOM", 0] == 0 and max(points.values()) == 100
    body = driven()
    assert Score(float(rewards_of(body.log, 10).mean()), random, found).points == 0


@pytest.mark.long
def test_under_other_noise_chance_is_still_worth_little_and_who_learned_in_the_robot_much():
    task, seconds = rl.load_task(TASK), 600.0
    random, found = rulers(task, SECRET, seconds)
    pupils = [rl.Agent(task, "TOSL+QBIASSR", seed=seed) for seed in range(3)]
    for pupil in pupils:
        driven(steps=1200, seed=20 + pupil.seed, agent=pupil)
    bodies = [
        driven(steps=600, seed=30, agent=agent) for agent in (random_agent(1), *pupils)
    ]
    chance, *knowing = (
        Score(float(rewards_of(body.log, 10).mean()), random, found).points
        for body in bodies
    )
    assert abs(chance) < 30 and 50 < max(knowing) < 150


@pytest.fixture
def served(tmp_path):
    """A secret robot in a process of its own, and its folder."""
    pytest.importorskip(
        "websockets", reason="rosbridge needs pip install 'rlrobot-edu[ros]'"
    )
    (tmp_path / "secret.txt").write_text("a secret of the tests")
    command = [
        sys.executable,
        "-m",
        "rlrobot_course",
        "serve-robot",
        TASK,
        "--port",
        "0",
        "--simulated-time",
    ]
    with subprocess.Popen(
        [*command, "--secret", "file:secret.txt"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        yield process, tmp_path
        process.kill()


@pytest.mark.long
def test_a_learner_drives_it_over_rosbridge_and_nothing_that_is_told_names_its_secret(
    served,
):
    process, folder = served
    said = process.stdout.readline()
    address = re.search(r"ws://127\.0\.0\.1:\d+", said)[0]
    command_line = f"/proc/{process.pid}/cmdline"
    if os.path.exists(command_line):
        with open(command_line) as file:
            assert "a secret" not in file.read()
    link = rl.RobotLink(address=address, confirmed=True, simulated_time=True)
    env = rl.make_env(TASK, link=link)
    rl.learn(random_agent(), env, steps=61, progress=False)
    env.close()
    deadline = time.monotonic() + 60
    while not (folder / "drive.npz").exists() and time.monotonic() < deadline:
        time.sleep(0.1)
    about, arrays = load_arrays(
        folder / "drive.npz", "drive", lambda about, arrays: (about, arrays)
    )
    assert (
        about.keys() == {"task", "signature"}
        and arrays.keys() == {"rewards"}
        and len(arrays["rewards"]) == 600
    )
    process.send_signal(signal.SIGINT)
    told = said + process.communicate(timeout=60)[0] + json.dumps(about)
    weak = [
        f"{value:.3g}"
        for name, value in vars(SECRET.realism).items()
        if name != "delay"
    ]
    assert not [size for size in weak if size in told]
    assert sorted(path.name for path in folder.iterdir()) == ["drive.npz", "secret.txt"]


def test_the_log_of_an_earlier_drive_is_not_overwritten(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "drive.npz").touch()
    with pytest.raises(SystemExit, match="log of an earlier drive"):
        commands.main(["serve-robot", TASK, "--secret", "a secret of the tests"])


def test_the_command_tells_the_score(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(
        project_commands, "score", lambda log, secret: Score(1.0, 0.0, 4.0)
    )
    commands.main(["score", "drive.npz", "--secret", "a secret of the tests"])
    assert "score: 25 " in capsys.readouterr().out


def test_an_ideal_served_robot_is_as_before():
    with rl.ServedRobot(TASK, port=0, realism=Realism(), simulated_time=True) as robot:
        assert robot.where["address"].startswith("ws://127.0.0.1:")
