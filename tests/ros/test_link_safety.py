"""What keeps a robot behind a link from harm, point by point; most of it against a robot that is only its messages."""

import builtins
import math
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from functools import partial

import fake_robot
import pytest
from bags import scan
from fake_robot import AHEAD, FREE, LEFT, NEAR, NOTHING, OMEGA, RIGHT, V
from hypothesis import given, settings
from hypothesis import strategies as st
from waiting import eventually

import rlrobot_edu as rl
from rlrobot_edu.robots.chassis import GIRAFF, PIONEER
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_ros import RobotLink, ServedRobot
from rlrobot_ros.live import controller, session
from rlrobot_ros.live.rosbridge import Rosbridge
from rlrobot_ros.live.safety import room_ahead, within
from rlrobot_ros.live.simulated_body import SimulatedBody
from rlrobot_ros.messages import LASER_SCAN
from rlrobot_ros.scan import GAP, Mounting

robot, env = fake_robot.robot, fake_robot.env  # fixtures


def test_a_step_says_its_motion_ten_times_a_second_for_its_whole_time(
    env, robot, monkeypatch
):
    env.reset()
    rest, rests = time.sleep, []
    begin = time.monotonic()
    with monkeypatch.context() as watched:
        watched.setattr(
            controller.time,
            "sleep",
            lambda seconds: rest(seconds) or rests.append(seconds),
        )
        env.step(AHEAD)
    assert time.monotonic() - begin >= 0.999
    assert set(robot.motions()) == {(V, 0.0)} and len(rests) == len(robot.told)
    assert max(rests) <= 0.1  # how long they really were is the machine's


def test_after_its_last_step_the_robot_is_told_to_stop(env, robot):
    env.reset()
    env.step(AHEAD)
    eventually(lambda: robot.motions()[-1] == (0.0, 0.0))


def test_close_stops_the_robot_and_ends_the_connection(env, robot):
    env.reset()
    env.step(AHEAD)
    env.close()
    assert robot.motions()[-1] == (0.0, 0.0) and robot.is_closed


def test_a_link_that_nobody_holds_any_more_stops_the_robot(robot):
    link = RobotLink(confirmed=True)
    env = rl.make_env("giraff_wander_simple", link=link)
    env.reset()
    env.step(AHEAD)
    robot.told.clear()
    del env, link
    eventually(lambda: robot.motions()[-1:] == [(0.0, 0.0)] and robot.is_closed)


def test_an_exception_within_a_step_stops_the_robot(env, robot, monkeypatch):
    env.reset()
    env.step(LEFT)

    def fail(seconds):
        raise RuntimeError("of whatever kind")

    monkeypatch.setattr(controller.time, "sleep", fail)
    with pytest.raises(RuntimeError):
        env.step(AHEAD)
    assert robot.motions()[-2:] == [(V, 0.0), (0.0, 0.0)]


def test_an_exception_between_steps_stops_the_robot(env, robot):
    env.reset()
    with pytest.raises(ZeroDivisionError):
        for _ in range(2):
            env.step(AHEAD)
            1 / 0  # noqa: B018
    eventually(lambda: robot.motions()[-1] == (0.0, 0.0))


def press_ctrl_c_when_it_drives(robot):
    """Start a thread that presses Ctrl-C as soon as the robot drives ahead."""

    def press():
        eventually(lambda: (V, 0.0) in robot.motions())
        signal.raise_signal(signal.SIGINT)

    thread = threading.Thread(target=press)
    thread.start()
    return thread


def test_ctrl_c_within_a_step_stops_the_robot(env, robot):
    env.reset()
    env.step(LEFT)  # compiles nothing any more

    thread = press_ctrl_c_when_it_drives(robot)
    with pytest.raises(KeyboardInterrupt):
        for _ in range(60):
            env.step(AHEAD)
    assert robot.motions()[-1] == (0.0, 0.0)
    thread.join()


def test_ctrl_c_within_a_step_of_learning_stops_the_robot_at_once(env, robot):
    agent = rl.Agent(env, "Q+GREEDY", seed=0)
    agent.q[:, AHEAD] = 1.0
    rl.learn(agent, env, 1, progress=False)
    robot.told.clear()

    thread = press_ctrl_c_when_it_drives(robot)
    with pytest.raises(KeyboardInterrupt):
        rl.learn(agent, env, 60, progress=False, resume=True)
    thread.join()
    assert robot.motions()[-1] == (0.0, 0.0)
    assert agent.visits.sum() == 1, "it did not wait for the end of the step"
    with pytest.raises(ValueError, match="was interrupted within a step"):
        rl.learn(agent, env, 60, progress=False, resume=True)


def test_nothing_moves_before_a_person_has_said_yes(robot, monkeypatch):
    env = rl.make_env("giraff_wander_simple", link=RobotLink())
    asked = []
    monkeypatch.setattr(
        builtins, "input", lambda question: asked.append(question) or "no"
    )
    env.reset()
    with pytest.raises(PermissionError, match="the answer was 'no'"):
        env.step(AHEAD)
    assert not robot.told and "emergency stop" in asked[0]
    env.step(0)  # to stand still needs no leave
    monkeypatch.setattr(
        builtins, "input", lambda question: asked.append(question) or "yes"
    )
    env.step(AHEAD)
    env.step(AHEAD)
    assert len(asked) == 2 and (V, 0.0) in robot.motions()
    env.close()


def test_where_nobody_can_be_asked_nothing_moves_and_the_error_says_what_to_do(
    robot, monkeypatch
):
    env = rl.make_env("giraff_wander_simple", link=RobotLink())

    def no_keyboard(question):
        raise EOFError

    monkeypatch.setattr(builtins, "input", no_keyboard)
    env.reset()
    with pytest.raises(PermissionError, match=r"RobotLink\(…, confirmed=True\)"):
        env.step(AHEAD)
    assert not robot.told
    env.close()


def test_a_new_connection_asks_again(robot, monkeypatch):
    env = rl.make_env("giraff_wander_simple", link=RobotLink())
    asked = []
    monkeypatch.setattr(
        builtins, "input", lambda question: asked.append(question) or "yes"
    )
    for n in (1, 2):
        env.reset()
        env.step(LEFT)
        env.close()
        assert len(asked) == n


def test_a_dry_run_says_nothing_at_all_and_counts_what_it_would_have_said(robot):
    link = RobotLink(dry_run=True)
    env = rl.make_env("giraff_wander_simple", link=link)
    env.reset()
    env.step(AHEAD)
    with pytest.raises(ConnectionError, match="not open"):
        _ = RobotLink().report
    env.close()
    report = link.report  # it can be read also now
    assert not robot.told and robot.topics == ["odom", "laser_scan"]
    assert report.commands and "this is a dry run" in str(report)


@pytest.mark.parametrize("what", ["odometry and scan", "odometry", "scan"])
def test_a_robot_that_falls_silent_is_stopped_within_half_a_second_and_then_goes_on(
    env, robot, what, monkeypatch
):
    monkeypatch.setattr(controller, "MAX_AGE", fake_robot.MAX_AGE)
    env.reset()
    env.step(LEFT)
    robot.told.clear()
    link = env.unwrapped.robot
    paused = link.report.pauses  # on a busy machine it may have had to, before
    if what == "odometry and scan":
        robot.is_silent = True
    else:
        monkeypatch.setattr(
            robot, "pose" if what == "odometry" else "scan", lambda stamp: None
        )
    silent_since = time.monotonic()
    thread = threading.Thread(target=env.step, args=[AHEAD])
    thread.start()
    eventually(
        lambda: link.report.pauses > paused and robot.motions()[-1:] == [(0.0, 0.0)]
    )
    assert all(t - silent_since < 0.5 + 0.3 for t, v, _ in robot.told if v), (
        "it was driven on into the dark"
    )
    time.sleep(0.3)
    assert robot.motions()[-1] == (0.0, 0.0) and thread.is_alive()
    if what == "odometry and scan":
        robot.is_silent = False
    else:
        monkeypatch.delattr(robot, "pose" if what == "odometry" else "scan")
    thread.join(60)
    assert not thread.is_alive() and (V, 0.0) in robot.motions()


def test_late_messages_count_as_old_though_the_clocks_do_not_agree(
    env, robot, monkeypatch
):
    monkeypatch.setattr(controller, "MAX_AGE", fake_robot.MAX_AGE)
    env.reset()
    env.step(LEFT)
    robot.delay = 0.8
    robot.told.clear()
    thread = threading.Thread(target=env.step, args=[AHEAD])
    thread.start()
    eventually(lambda: robot.motions()[-1:] == [(0.0, 0.0)])
    robot.delay = 0.0
    thread.join(60)
    assert not thread.is_alive() and env.unwrapped.robot.report.pauses


def test_a_robot_that_stays_silent_ends_the_step_with_what_is_wrong(
    env, robot, monkeypatch
):
    env.reset()
    robot.is_silent = True
    monkeypatch.setattr(controller, "PATIENCE", 0.3)
    monkeypatch.setattr(controller, "MAX_AGE", fake_robot.MAX_AGE)
    with pytest.raises(
        TimeoutError,
        match=r"'odom' is \d+\.\d s old; the last message of 'laser_scan' is",
    ):
        env.step(AHEAD)
    assert robot.motions()[-1] == (0.0, 0.0)


def test_a_robot_whose_clock_is_set_back_is_stopped_told_why_and_driven_after_a_reset(
    env, robot, monkeypatch
):
    env.reset()
    env.step(LEFT)
    robot.delay = 100.0
    with (
        monkeypatch.context() as hasty,
        pytest.raises(TimeoutError, match="was the robot's clock set back"),
    ):
        hasty.setattr(controller, "PATIENCE", 1.0)
        hasty.setattr(controller, "MAX_AGE", fake_robot.MAX_AGE)
        env.step(AHEAD)
        env.step(AHEAD)
    assert robot.motions()[-1] == (0.0, 0.0)
    robot.told.clear()
    env.reset()
    env.step(AHEAD)
    assert (V, 0.0) in robot.motions()


def test_a_scan_that_shows_nothing_at_all_lets_nothing_move(env, robot, monkeypatch):
    env.reset()
    for rays in (NOTHING, [0.0] * 8, [math.nan] * 8):
        robot.show(rays)
        robot.told.clear()
        with (
            monkeypatch.context() as hasty,
            pytest.raises(TimeoutError, match="is the scanner on, uncovered"),
        ):
            hasty.setattr(controller, "PATIENCE", 0.5)
            env.step(AHEAD)
        assert set(robot.motions()) <= {(0.0, 0.0)}
        robot.rays = FREE
        env.reset()


def test_there_is_no_forward_motion_while_something_is_near_ahead(env, robot):
    robot.rays = NEAR
    env.reset()
    env.step(AHEAD)
    assert set(robot.motions()) == {(0.0, 0.0)}
    robot.told.clear()
    env.step(LEFT)
    assert set(robot.motions()) >= {(0.0, OMEGA)}  # turning is not forward
    report = env.unwrapped.robot.report
    assert report.held_back and report.pauses == 0


def test_what_is_behind_or_far_ahead_holds_nothing_back(env, robot):
    robot.rays = [0.23 + 0.19, *[0.25] * 0, 0.6, 0.3, 0.3, 0.3, 0.3, 0.3, 0.6]
    env.reset()
    env.step(AHEAD)
    assert set(robot.motions()) == {(V, 0.0)}


def test_a_task_that_wants_more_than_the_limits_is_refused_before_anything_is_sent(
    robot,
):
    with pytest.raises(
        ValueError,
        match=r"giraff_wander_simple\.py: action 3 drives at 0\.0375 m/s .* max_speed=",
    ):
        rl.make_env("giraff_wander_simple", link=RobotLink(max_speed=0.03))
    with pytest.raises(ValueError, match="action 1 drives at"):
        rl.make_env("giraff_wander_simple", link=RobotLink(max_turn=0.1))
    assert not robot.topics


@given(
    st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.floats(0.01, 10), st.floats(0.01, 10)
)
def test_no_motion_exceeds_a_limit_and_its_curve_stays(v, omega, max_speed, max_turn):
    slow, turn = within(v, omega, max_speed, max_turn)
    assert abs(slow) <= max_speed * (1 + 1e-12) and abs(turn) <= max_turn * (1 + 1e-12)
    assert slow * omega == pytest.approx(turn * v, rel=1e-9, abs=1e-9)
    if abs(v) <= max_speed and abs(omega) <= max_turn:
        assert (slow, turn) == (v, omega)


def test_a_command_above_the_limits_is_slowed_down_on_its_curve(robot):
    link = RobotLink(confirmed=True, max_speed=0.05)
    env = rl.make_env("giraff_wander_simple", link=link)
    env.reset()
    link.act({"left_wheel": 2.0, "right_wheel": 1.0})  # 0.1125 m/s
    env.close()
    v, omega = robot.motions()[0]
    assert v == pytest.approx(0.05) and omega == pytest.approx(
        -0.075 / 0.46 * 0.05 / 0.1125
    )


def time_to_stop(v: float, room: float) -> bool:
    """Lesson 18: the scan is 0.5 s old, the command acts 0.3 s late, and the brakes give 0.5 m/s²."""
    left = room - v * (0.5 + 0.3)
    return left >= 0 and v <= math.sqrt(2 * 0.5 * left) + 1e-9


def test_the_largest_speed_of_a_link_suits_its_safety_distance():
    limits = RobotLink()._settings.limits
    assert time_to_stop(limits.max_speed, limits.safety_distance)


@pytest.mark.parametrize("speed", [0.05, 0.17, 0.19, 0.25, 0.5, 1.0])
@pytest.mark.parametrize("spare", [-0.01, 0.01])
def test_whatever_limits_are_given_a_robot_that_drives_can_stop_in_the_room_ahead(
    robot, speed, spare
):
    needed = max(0.18, speed * 0.8 + speed**2)
    assert time_to_stop(speed, needed)
    robot.rays = [GIRAFF.radius + needed + spare] * 8
    fast = GIRAFF._replace(wheel_radius=1.0)
    link = RobotLink(confirmed=True, max_speed=1.0, max_turn=9.0, chassis=fast)
    env = rl.make_env("giraff_wander_simple", link=link)
    env.reset()
    link.act({"left_wheel": speed, "right_wheel": speed})
    told = max(v for _, v, _ in robot.told)
    assert told == pytest.approx(speed if spare > 0 else 0.0)
    env.close()


def test_a_task_that_is_faster_than_the_default_allows_must_say_so(robot):
    with pytest.raises(
        ValueError, match=r"at 0\.195 m/s .* limits of 0\.18 m/s .*max_"
    ):
        rl.make_env("wander_1k", link=RobotLink())
    rl.make_env("wander_1k", link=RobotLink(max_speed=0.2)).close()


@pytest.mark.parametrize("bad", [0, -1, math.nan, math.inf, "1", None])
@pytest.mark.parametrize("name", ["max_speed", "max_turn", "safety_distance"])
def test_a_limit_must_be_a_positive_number(name, bad):
    with pytest.raises(ValueError, match=f"{name} must be a positive number"):
        RobotLink(**{name: bad})


def test_room_ahead_is_the_distance_of_the_nearest_thing_from_the_circle_around_the_robot():
    rays = scan([2.0, 0.9, 0.3, 0.3, 0.3, 0.3, 0.3, 1.1])
    assert room_ahead(rays, GIRAFF, Mounting()) == pytest.approx(0.9 - 0.23)
    assert room_ahead(rays, GIRAFF, Mounting(yaw=math.pi)) == pytest.approx(0.3 - 0.23)
    assert room_ahead(rays, GIRAFF, Mounting(yaw=-math.pi / 4)) == pytest.approx(
        0.3 - 0.23
    )
    assert room_ahead(
        scan([1.0, 1.0, 1.0], -0.1, 0.1), PIONEER, Mounting(x=0.1)
    ) == pytest.approx(math.hypot(0.145 + math.cos(0.1), math.sin(0.1)) - 0.265)
    assert (
        room_ahead(scan([math.inf, 1.0], 0.0, math.pi), GIRAFF, Mounting()) == math.inf
    )
    assert math.isnan(
        room_ahead(scan([1.0, 1.0], 2.0, 0.1), GIRAFF, Mounting())
    )  # it looks elsewhere
    assert (
        room_ahead(scan([-math.inf, 1.0], 0.0, 0.1), GIRAFF, Mounting()) < 0
    )  # too near to be measured
    assert room_ahead(scan([0.04, 1.0], 0.0, 0.1), GIRAFF, Mounting()) < 0
    assert (
        room_ahead(scan([-math.inf, 1.0], 0.0, 0.1), GIRAFF, Mounting(x=-0.04)) < 0
    )  # behind the middle, too
    assert math.isnan(
        room_ahead(scan([1.0] * 320, 0.35, math.radians(1)), GIRAFF, Mounting())
    )  # not straight ahead


def whole_turn(ranges) -> object:
    return scan(ranges, 0.0, 2 * math.pi / len(ranges))


LOST = [math.nan, 0.0, 99.0]


@pytest.mark.parametrize("lost", LOST)
@pytest.mark.parametrize(
    "side",
    [
        lambda i: i < 180,
        lambda i: i >= 180,
        lambda i: not 100 < i < 260,
        lambda i: i < 8,
    ],
)
def test_where_a_part_of_the_scanner_ahead_is_dead_nothing_is_known_to_be_free(
    lost, side
):
    ranges = [lost if side(i) else 2.0 for i in range(360)]
    assert math.isnan(room_ahead(whole_turn(ranges), GIRAFF, Mounting()))
    behind = whole_turn([2.0] * 100 + [lost] * 160 + [2.0] * 100)
    assert room_ahead(behind, GIRAFF, Mounting()) == pytest.approx(2.0 - 0.23)


@pytest.mark.parametrize("lost", LOST)
def test_more_than_half_of_the_rays_ahead_must_say_something_however_narrow_the_gaps(
    lost,
):
    for period, is_known in ((2, True), (3, False)):
        ranges = [2.0 if i % period == 0 else lost for i in range(720)]
        assert (
            math.isnan(room_ahead(whole_turn(ranges), GIRAFF, Mounting()))
            is not is_known
        )


@pytest.mark.parametrize(
    ("lost", "far"), [(0.0, 0.0), (math.nan, math.nan), (99.0, 11.0)]
)
def test_a_scanner_that_says_otherwise_than_others_that_nothing_is_in_range_is_told_so(
    lost, far
):
    ranges = [lost] * 90 + [2.0] * 180 + [lost] * 90
    assert room_ahead(whole_turn(ranges), GIRAFF, Mounting(far=far)) == math.inf
    assert math.isnan(
        room_ahead(whole_turn([lost] * 360), GIRAFF, Mounting(far=far))
    )  # it may be covered, even so
    ranges = [
        lost if i % 2 else 0.5 for i in range(360)
    ]  # rays that are lost between good ones are not far
    assert room_ahead(whole_turn(ranges), GIRAFF, Mounting(far=far)) == pytest.approx(
        0.5 - 0.23
    )


distances = st.sampled_from([0.1, 0.3, 0.45, 0.9, 3.0, math.inf])


@settings(max_examples=60, deadline=None)
@given(
    st.lists(distances, min_size=360, max_size=360),
    st.sets(st.integers(0, 359)),
    st.sets(st.integers(0, 359)),
)
def test_a_ray_that_gets_lost_makes_nothing_known_and_hides_nothing_wider_than_the_gaps(
    ranges, lost, also
):
    def room(without) -> float:
        said = [math.nan if i in without else r for i, r in enumerate(ranges)]
        return room_ahead(whole_turn(said), GIRAFF, Mounting())

    before, after = room(lost), room(lost | also)
    if math.isnan(before):
        assert math.isnan(after)  # what stopped the robot goes on stopping it
    gap = (
        math.ceil(GAP / math.radians(1)) + 1
    )  # so many rays in a row: one of them at least must be known
    ahead = [ranges[i % 360] for i in range(-60, 61)]
    nearest = min(max(ahead[i : i + gap]) for i in range(122 - gap))
    for seen in (before, after):
        assert math.isnan(seen) or seen <= nearest - 0.23 + 1e-6


@settings(max_examples=60, deadline=None)
@given(
    st.lists(distances, min_size=8, max_size=40),
    st.floats(-math.pi, math.pi),
    st.data(),
)
def test_a_lost_ray_that_did_not_look_at_the_nearest_thing_changes_at_most_that_all_is_unknown(
    ranges, yaw, data
):
    before = room_ahead(whole_turn(ranges), GIRAFF, Mounting(yaw=yaw))
    i = data.draw(st.integers(0, len(ranges) - 1))
    after = room_ahead(
        whole_turn([*ranges[:i], math.nan, *ranges[i + 1 :]]), GIRAFF, Mounting(yaw=yaw)
    )
    assert math.isnan(after) or not math.isnan(before)
    if ranges[i] > min(ranges[i - 1], ranges[(i + 1) % len(ranges)]):
        assert (
            math.isnan(after) or after <= before
        )  # a nearer neighbour stands in for it


@pytest.mark.parametrize("dead", [math.nan, 0.0, 99.0])
def test_a_robot_whose_scanner_is_dead_ahead_does_not_move_and_says_why(
    env, robot, monkeypatch, dead
):
    robot.rays = [2.0] * 360
    env.reset()
    robot.show([dead if math.cos(math.radians(i)) > -0.2 else 2.0 for i in range(360)])
    robot.told.clear()
    monkeypatch.setattr(controller, "PATIENCE", 0.5)
    with pytest.raises(
        TimeoutError,
        match=r"121 of the 121 rays ahead say nothing \(0, NaN, or above range_max\), 121 of",
    ):
        env.step(AHEAD)
    assert set(robot.motions()) <= {(0.0, 0.0)}
    report = env.unwrapped.robot.report
    assert report.pauses == 1 and "121 of the 121 rays ahead say nothing" in str(report)


def test_a_served_robot_with_half_a_dead_scanner_is_not_driven(monkeypatch):
    look, dead = SimulatedBody.look, threading.Event()

    def look_with_dead_rays(body):
        ranges = look(body)
        if dead.is_set():
            return [r if 90 < i < 270 else math.nan for i, r in enumerate(ranges)]
        return ranges

    monkeypatch.setattr(SimulatedBody, "look", look_with_dead_rays)
    with ServedRobot("giraff_wander_simple", port=0, simulated_time=True) as served:
        body = served._body
        link = RobotLink(served.address, confirmed=True, simulated_time=True)
        env = rl.make_env("giraff_wander_simple", link=link)
        env.reset()
        env.step(AHEAD)
        here = body.pose()[0]
        assert here > 0.03
        dead.set()
        monkeypatch.setattr(controller, "PATIENCE", 1.0)
        for _ in range(3):
            with pytest.raises(TimeoutError, match="nothing is known of laser_front"):
                env.step(AHEAD)
        assert (
            body.pose()[0] <= here + 0.004
        )  # a tenth of a second, in which the first dead scan came
        env.close()


def test_a_scan_that_shows_less_than_at_the_reset_is_not_used_but_for_what_is_near_ahead(
    env, robot
):
    robot.rays = [2.0] * 360
    env.reset()
    link = env.unwrapped.robot
    before = link.readings
    robot.fall_silent()

    def short(ranges):
        message = robot.scan(time.monotonic() + 1000.0)
        message.ranges = ranges
        robot.say(LASER_SCAN, message)

    short([3.0] * 5)
    assert link.readings == before and link.report.unreadable == 1
    assert (
        "a scan of 5 rays in which nothing is known of laser_front_left"
        in link.report.complaint
    )
    assert link._session.sensors.room == pytest.approx(2.0 - 0.23)
    short([0.3] * 5)
    assert link.readings == before and link._session.sensors.room == pytest.approx(
        0.3 - 0.23
    )


def test_a_laser_that_a_reward_may_ask_for_stays_out_if_it_was_unknown_at_the_reset(
    env, robot
):
    rays = [2.0] * 100 + [0.0] * 160 + [2.0] * 100  # the robot's own mast, behind it
    robot.rays = rays
    env.reset()
    link = env.unwrapped.robot
    assert "laser_rear" not in link.readings and "laser_front" in link.readings
    robot.show([1.0] * 360)
    assert "laser_rear" not in link.readings and link.report.unreadable == 0
    beams = link.scene().beams
    assert (
        beams[LASERS.index("laser_rear")][0] == beams[LASERS.index("laser_rear")][1]
    ).all()  # nothing free is drawn


def test_a_link_can_be_neither_copied_nor_sent_away():
    import copy
    import pickle

    link = RobotLink()
    for way in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="there is one robot"):
            way(link)


@pytest.mark.parametrize("end", ["SIGKILL", "SIGTERM", "SIGINT", "exit", "exception"])
def test_however_the_process_ends_the_robot_is_stopped(end):
    """What counts is that it is told so: its own watchdog would stop it in the end, too."""
    if not hasattr(signal, end) and end.startswith("SIG"):
        pytest.skip(f"no {end} on this system")
    with ServedRobot("wander_1k", port=0) as served:
        heard = []
        listener = Rosbridge(served.address)
        listener.subscribe(
            "cmd_vel", "geometry_msgs/Twist", lambda twist: heard.append(twist.linear.x)
        )
        last = {"exit": "import sys; sys.exit()", "exception": "1 / 0"}.get(end, "")
        program = f"""
            import rlrobot_edu as rl
            from rlrobot_ros import RobotLink
            env = rl.make_env("wander_1k", link=RobotLink({served.address!r}, max_speed=0.2, confirmed=True))
            env.reset()
            while True:
                env.step(8)  # both wheels forward
                print("moving", flush=True)
                {last}
        """
        process = subprocess.Popen(
            [sys.executable, "-c", textwrap.dedent(program)],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        try:
            assert process.stdout.readline() == "moving\n"
            if end.startswith("SIG"):
                os.kill(process.pid, getattr(signal, end))
            process.wait(120)
            eventually(lambda: heard and heard[-1] == 0.0)
            assert max(heard) > 0.09
        finally:
            process.kill()
            process.stdout.close()
            process.wait()
        listener.close()


DRIVER = """
    import sys
    import rlrobot_edu as rl
    from rlrobot_ros import RobotLink
    env = rl.make_env("giraff_wander_simple", link=RobotLink(sys.argv[1], confirmed=True))
    env.reset()
    while True:
        env.step(1)
        print("moving", flush=True)
"""


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="no SIGSTOP on this system")
def test_while_the_process_does_not_run_the_robot_is_stopped_and_then_goes_on():
    with ServedRobot("giraff_wander_simple", port=0) as served:
        heard = []
        listener = Rosbridge(served.address)
        listener.subscribe(
            "cmd_vel",
            "geometry_msgs/Twist",
            lambda twist: heard.append(abs(twist.angular.z)),
        )
        process = subprocess.Popen(
            [sys.executable, "-c", textwrap.dedent(DRIVER), served.address],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        try:
            assert process.stdout.readline() == "moving\n"
            os.kill(process.pid, signal.SIGSTOP)
            eventually(lambda: heard[-2:] == [0.0, 0.0])
            heard.clear()
            os.kill(process.pid, signal.SIGCONT)
            eventually(lambda: any(heard))
        finally:
            process.kill()
            process.stdout.close()
            process.wait()
        listener.close()


def test_the_guardian_ends_with_the_link_and_leaves_nothing_behind():
    psutil = pytest.importorskip("psutil")
    before = {child.pid for child in psutil.Process().children(recursive=True)}
    with ServedRobot("giraff_wander_simple", port=0) as served:
        env = rl.make_env(
            "giraff_wander_simple",
            link=RobotLink(served.address, confirmed=True),
        )
        env.reset()
        env.step(RIGHT)
        assert {
            child.pid for child in psutil.Process().children(recursive=True)
        } - before
        env.close()
        assert (
            not {child.pid for child in psutil.Process().children(recursive=True)}
            - before
        )


def test_when_the_connection_is_lost_the_guardian_stops_the_robot_over_its_own(
    env, robot, monkeypatch
):
    ended = []
    monkeypatch.setattr(
        fake_robot.FakeGuardian, "close", lambda guardian: ended.append(guardian)
    )
    env.reset()
    env.step(LEFT)
    assert not ended
    robot.lost = "the connection to the fake robot is lost"
    with pytest.raises(ConnectionError):
        env.step(AHEAD)
    assert ended  # that makes it stop the robot, see above


def test_without_a_second_connection_nothing_moves(robot, monkeypatch):
    class Unreachable:
        def __init__(self, *settings):
            raise ConnectionError("no second connection that would stop the robot")

    monkeypatch.setattr(session, "Guardian", Unreachable)
    env = rl.make_env("giraff_wander_simple", link=RobotLink(confirmed=True))
    env.reset()
    with pytest.raises(ConnectionError, match="no second connection"):
        env.step(AHEAD)
    assert not robot.told
    env.close()


def test_a_kernel_that_is_killed_or_interrupted_stops_the_robot():
    """As JupyterLab does it: Stop, and then a shutdown that does not ask."""
    manager = pytest.importorskip("jupyter_client.manager")
    pytest.importorskip("ipykernel")
    with ServedRobot("wander_1k", port=0) as served:
        heard = []
        listener = Rosbridge(served.address)
        listener.subscribe(
            "cmd_vel", "geometry_msgs/Twist", lambda twist: heard.append(twist.linear.x)
        )
        kernel, client = manager.start_new_kernel()
        run = partial(
            client.execute_interactive,
            allow_stdin=False,
            output_hook=lambda message: None,
        )
        try:
            link = f"RobotLink({served.address!r}, max_speed=0.2"
            run(
                "import rlrobot_edu as rl; from rlrobot_ros import RobotLink; "
                f"env = rl.make_env('wander_1k', link={link})); env.reset()"
            )
            reply = run("env.step(8)")
            assert reply["content"]["ename"] == "PermissionError" and not heard
            run(
                f"env.close(); env = rl.make_env('wander_1k', link={link}, confirmed=True)); env.reset()"
            )
            for end in (
                kernel.interrupt_kernel,
                lambda: kernel.shutdown_kernel(now=True),
            ):
                heard.clear()
                # what waits while an interrupt ends a cell is not executed
                eventually(lambda: run("1")["content"]["status"] == "ok")
                client.execute("while True: env.step(8)")
                eventually(lambda: any(heard))
                end()
                eventually(lambda: heard[-1] == 0.0)
        finally:
            client.stop_channels()
            kernel.shutdown_kernel(now=True)
            listener.close()
