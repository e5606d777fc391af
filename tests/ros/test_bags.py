"""Drives in bags of ROS 1 and ROS 2 become the transitions that the robot lived through, and nothing else."""

import contextlib
import math
import re
import sqlite3
import sys
from dataclasses import replace

import numpy as np
import pytest
from bags import FORMATS, SECOND, drive, full_scan, scan, write_bag
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_ros import recording_from_bag

pytest.importorskip(
    "rosbags.highlevel", reason="rosbags is missing: pip install rosbags"
)
TASK = "giraff_wander_simple"


def assert_same(one: rl.Recording, two: rl.Recording) -> None:
    for a, b in zip(one.transitions, two.transitions, strict=True):
        np.testing.assert_array_equal(a, b)


@pytest.fixture(scope="module")
def driven():
    return drive(TASK, 150)


@pytest.mark.parametrize("form", FORMATS)
def test_each_format_gives_the_transitions_that_the_robot_lived_through(
    driven, tmp_path, form
):
    events, lived = driven
    recording = recording_from_bag(write_bag(tmp_path, form, events), TASK)
    assert_same(recording, lived)
    report = recording.report
    assert (report.steps, report.stretches, report.dropped) == (150, 1, 0)
    assert report.messages == {"/odom": 151, "/laser_scan": 151, "/cmd_vel": 150}
    recording.save(tmp_path / "saved")
    assert_same(rl.read_recording(tmp_path / "saved", task=TASK), lived)
    model = rl.SampleModel.from_recording(recording)
    assert model.count.sum() == 150


def test_a_stamped_twist_and_other_names_say_the_same(driven, tmp_path):
    events, lived = driven
    topics = {"odom": "/robot/odom", "scan": "/scan", "cmd_vel": "/robot/cmd_vel"}
    path = write_bag(tmp_path, "mcap", events, topics, stamped=True)
    assert_same(
        recording_from_bag(
            path, TASK, odom="robot/odom", scan="/scan", cmd_vel="/robot/cmd_vel"
        ),
        lived,
    )
    assert_same(
        recording_from_bag(
            path / "mcap.mcap",
            TASK,
            odom="robot/odom",
            scan="scan",
            cmd_vel="/robot/cmd_vel/",
        ),
        lived,
    )


@pytest.mark.parametrize("task", ["wander_simple", "wander_1k"])
def test_a_base_whose_lasers_stand_off_the_scanners_lines_lives_through_the_same(
    tmp_path, task
):
    events, lived = drive(task, 60, see=full_scan)
    recording = recording_from_bag(write_bag(tmp_path, "sqlite3", events), task)
    np.testing.assert_array_equal(recording.r, lived.r)
    commands = [
        [lived.task.command_for(a) for a in who.a] for who in (recording, lived)
    ]
    assert commands[0] == commands[1]
    bins = [
        np.stack(np.unravel_index(who.s, lived.source.states.shape))
        for who in (recording, lived)
    ]
    assert (
        (bins[0] != bins[1]).mean() < 0.01
    )  # a wall just at the limit of a bin, seen by a ray half a degree wide


def recorded(tmp_path, events, task=TASK, **options):
    return recording_from_bag(write_bag(tmp_path, "mcap", events), task, **options)


def test_commands_that_are_late_or_said_ten_times_a_second_mean_the_same(
    driven, tmp_path
):
    events, lived = driven
    rng = np.random.default_rng(1)
    late = [
        (t + int(rng.integers(SECOND // 25)) * (kind == "cmd_vel"), kind, said)
        for t, kind, said in events
    ]
    often = [
        (t + i * SECOND // 10, kind, said)
        for t, kind, said in late
        for i in range(10 if kind == "cmd_vel" else 1)
    ]
    for i, told in enumerate((late, sorted(often, key=lambda event: event[0]))):
        (tmp_path / str(i)).mkdir()
        recording = recorded(tmp_path / str(i), told)
        assert_same(recording, lived)
        assert recording.report.stretches == 1


def test_a_twist_like_no_action_is_dropped_and_counted(driven, tmp_path):
    events, lived = driven
    strange = {
        3: {"v": 0.5, "omega": 0.0},
        7: {"v": 0.5, "omega": 0.0},
        20: {"v": 0.0, "omega": math.nan},
    }
    strange[30] = {**events[3 * 30 + 2][2], "aside": 0.3}
    events = [
        (t, kind, strange.get(i // 3, said) if kind == "cmd_vel" else said)
        for i, (t, kind, said) in enumerate(events)
    ]
    recording = recorded(tmp_path, events)
    kept = np.setdiff1d(np.arange(150), list(strange))
    for name in ("s", "a", "r", "s_next"):
        np.testing.assert_array_equal(
            getattr(recording, name), getattr(lived, name)[kept]
        )
    assert np.flatnonzero(recording.truncated).tolist() == [2, 5, 17, 26]
    report = recording.report
    assert (report.dropped, report.stretches, report.unexplained[0.5, 0.0]) == (4, 5, 2)
    assert "no action is like 0.5 m/s and 0 rad/s" in str(report)


@pytest.mark.parametrize("wrong", [0.05, -0.05])
def test_the_tolerance_says_how_far_a_twist_may_be_from_an_action(
    driven, tmp_path, wrong
):
    events, lived = driven
    off = wrong * max(said["v"] for _, kind, said in events if kind == "cmd_vel")
    events = [
        (t, kind, {**said, "v": said["v"] + off} if kind == "cmd_vel" else said)
        for t, kind, said in events
    ]
    path = write_bag(tmp_path, "ros1", events)
    assert_same(recording_from_bag(path, TASK, tolerance=0.06), lived)
    with pytest.raises(
        ValueError,
        match="holds no step of giraff_wander_simple: 150 Twists that no action explains",
    ):
        recording_from_bag(path, TASK, tolerance=0.04)


def test_messages_that_stay_out_make_gaps_and_no_steps(driven, tmp_path):
    events, lived = driven
    gone = {"odom": range(10, 15), "cmd_vel": range(40, 50), "scan": range(80, 83)}
    events = [
        event for i, event in enumerate(events) if i // 3 not in gone.get(event[1], ())
    ]
    recording = recorded(tmp_path, events)
    report = recording.report
    assert report.stretches == 4
    assert report.steps + report.stale + report.cut_short + 9 == 150
    # a step that was kept was lived through, but for readings one message older at the edge of a gap
    assert set(zip(recording.a, recording.s_next, strict=True)) <= set(
        zip(lived.a, lived.s_next, strict=True)
    ) | set(zip(lived.a, lived.s, strict=True))


def test_a_command_in_the_middle_of_a_step_cuts_it_short(driven, tmp_path):
    events, _ = driven
    halves = {"v": 0.0, "omega": 0.0}, {"v": 0.0375, "omega": 0.0}
    start = [event for event in events[:60] if event[1] != "cmd_vel"]
    told = [
        (start[0][0] + i * SECOND // 2, "cmd_vel", halves[i % 2]) for i in range(10)
    ]
    told += [(start[0][0] + 5 * SECOND, "cmd_vel", halves[0])]
    recording = recorded(tmp_path, sorted(start + told, key=lambda event: event[0]))
    assert recording.report.cut_short >= 10 and len(recording) >= 1
    assert set(recording.a) == {0}


def test_a_message_that_says_nothing_is_counted(driven, tmp_path):
    events, _ = driven
    events = list(events)
    events[30] = (events[30][0], "odom", {"x": math.nan, "y": 0.0, "theta": 0.0})
    recording = recorded(tmp_path, events)
    report = recording.report
    assert (report.unreadable, report.unknown, len(recording)) == (
        1,
        2,
        148,
    )  # of the steps before and after it
    assert "unreadable messages of /odom" in str(
        report
    ) and "the pose (nan, 0.0, 0.0) is no place" in str(report)


@pytest.fixture(scope="module")
def seen():
    """A drive with a whole scanner, and its recording's rows."""
    events, _ = drive(TASK, 60, see=lambda robot: full_scan(robot, 360))
    return events


def rows(recording):
    return list(
        zip(recording.s, recording.a, recording.r, recording.s_next, strict=True)
    )


def is_in_order(some, all_of_them) -> bool:
    """Whether `some` come in this order among all of them."""
    rest = iter(all_of_them)
    return all(one in rest for one in some)


SPOILT = {
    "odom": [{"x": math.nan}, {"y": math.inf}, {"theta": math.nan}, {"x": 1e300}, {"y": -3e8}, {"x": 30.0}],
    "scan": [
        {"angle_increment": 0.0}, {"ranges": np.zeros(0, np.float32)}, {"ranges": np.full(5, 0.3, np.float32)},
        {"ranges": np.full(360, np.nan, np.float32)}, {"ranges": np.zeros(360, np.float32)},
        {"ranges": np.full(360, 99.0, np.float32)}, {"range_max": math.nan}, {"range_max": 0.0},
        {"angle_min": math.inf},
    ],
    "cmd_vel": [{"v": math.nan}, {"omega": math.nan}, {"aside": math.nan}, {"v": 1e300}, {"omega": -math.inf}],
}  # fmt: skip


@settings(max_examples=15, deadline=None)
@given(st.data())
def test_whatever_part_of_the_messages_is_spoilt_no_row_changes_and_all_that_is_lost_is_counted(
    seen, tmp_path_factory, data
):
    whole = recorded(tmp_path_factory.mktemp("whole"), seen)
    spoilt = list(seen)
    for i in data.draw(
        st.lists(st.integers(0, len(seen) - 1), min_size=1, max_size=120, unique=True)
    ):
        time, kind, said = seen[i]
        spoilt[i] = (time, kind, said | data.draw(st.sampled_from(SPOILT[kind])))
    try:
        recording = recorded(tmp_path_factory.mktemp("spoilt"), spoilt)
    except ValueError as error:
        assert re.search(
            "holds no step|no readable message|never measures anything", str(error)
        )
        return
    assert is_in_order(rows(recording), rows(whole))
    report = recording.report
    assert (
        report.steps
        + report.unknown
        + report.jumps
        + report.stale
        + report.cut_short
        + report.dropped
        >= 60
    )


@pytest.mark.parametrize("nothing", [0.0, math.nan, 99.0])
def test_lost_rays_between_good_ones_leave_the_rows_as_they_are_or_drop_them(
    seen, tmp_path, nothing
):
    whole, rng = recorded(tmp_path, seen), np.random.default_rng(0)
    lossy = [
        (t, kind, said | {"ranges": np.where(rng.random(360) < 0.25, nothing, said["ranges"]).astype(np.float32)})
        if kind == "scan" else (t, kind, said)
        for t, kind, said in seen
    ]  # fmt: skip
    (tmp_path / "lossy").mkdir()
    recording = recorded(tmp_path / "lossy", lossy)
    report = recording.report
    assert is_in_order(rows(recording), rows(whole))
    assert len(recording) + report.unknown == 60 and len(recording) > 40
    assert (
        0.2 < report.lost / report.rays < 0.3
        and "rays that measured nothing" in str(report)
    )


def test_one_short_scan_costs_its_two_steps_and_not_the_bag(seen, tmp_path):
    whole = recorded(tmp_path, seen)
    short = [
        (
            t,
            kind,
            said | {"ranges": said["ranges"][:5]}
            if (i, kind) == (91, "scan")
            else said,
        )
        for i, (t, kind, said) in enumerate(seen)
    ]
    (tmp_path / "short").mkdir()
    recording = recorded(tmp_path / "short", short)
    assert (len(recording), recording.report.partial, recording.report.unknown) == (
        58,
        1,
        2,
    )
    assert rows(recording) == rows(whole)[:29] + rows(whole)[31:]


def test_a_message_whose_bytes_are_damaged_is_counted_and_the_others_are_read(
    driven, tmp_path
):
    path = write_bag(tmp_path, "sqlite3", driven[0])
    with contextlib.closing(sqlite3.connect(path / "sqlite3.db3")) as base:
        numbers = [
            number
            for (number,) in base.execute(
                "SELECT id FROM messages ORDER BY timestamp, id"
            )
        ]
        base.executemany(
            "UPDATE messages SET data = substr(data, 1, 20) WHERE id = ?",
            [(numbers[i],) for i in (30, 61)],
        )
        base.commit()
    report = recording_from_bag(path, TASK).report
    assert (
        report.unreadable == 2
        and report.steps == 150 - report.unknown
        and report.unknown in (3, 4)
    )


def test_a_bag_of_which_nothing_is_left_says_how_much_was_lost(driven, tmp_path):
    dead = [
        (
            t,
            kind,
            {**said, "ranges": np.zeros(8, np.float32)} if kind == "scan" else said,
        )
        for t, kind, said in driven[0]
    ]
    with pytest.raises(
        ValueError,
        match=r"needs laser_front_left, laser_front_right, where .* anything \(1208 of all its 1208 rays\); say",
    ):
        recorded(tmp_path, dead)
    lost = [
        (t, kind, {**said, "x": math.nan} if kind == "odom" else said)
        for t, kind, said in driven[0]
    ]
    (tmp_path / "lost").mkdir()
    with pytest.raises(
        ValueError, match=r"no readable message of /odom among 151: the pose \(nan, "
    ):
        recorded(tmp_path / "lost", lost)
    far = recording_from_bag(tmp_path / "mcap", TASK, mounting=(0, 0, 0, False, 0.0))
    assert (
        len(far) == 150 and len(set(far.s)) == 1
    )  # told that 0 means far, it is free all round


def test_a_place_that_the_robot_cannot_have_reached_makes_no_reward(driven, tmp_path):
    moved = [
        (t, kind, {**said, "x": said["x"] + 3.0} if kind == "odom" and i > 90 else said)
        for i, (t, kind, said) in enumerate(driven[0])
    ]
    recording = recorded(tmp_path, moved)
    assert (recording.report.jumps, len(recording)) == (1, 149)


def test_actions_with_the_same_motion_become_the_plainest():
    from rlrobot_ros.motions import Motions

    task = rl.load_task("wander_1k")
    stop = Motions(task, 0.1).action(0.0, 0.0)
    assert task.actions.decode(stop) == {"left_wheel": 0.0, "right_wheel": 0.0}
    assert Motions(rl.load_task(TASK), 0.1).action(0.0, 0.0) == 0


def test_a_scanner_that_does_not_see_what_the_task_needs_is_named(driven, tmp_path):
    events, _ = driven
    ahead = [
        (t, kind, {**said, "ranges": said["ranges"][:3]} if kind == "scan" else said)
        for t, kind, said in events
    ]
    with pytest.raises(
        ValueError,
        match=r"mcap: giraff_wander_simple needs laser_front_right, where the scanner does",
    ):
        recorded(tmp_path, ahead)
    turned = recording_from_bag(
        tmp_path / "mcap", TASK, mounting=(0.0, 0.0, -math.pi / 4, False)
    )
    assert len(turned) == 150 and "laser_rear" in turned.report.missing


def test_a_missing_or_foreign_topic_is_named_with_those_there_are(driven, tmp_path):
    path = write_bag(
        tmp_path, "ros1", driven[0], {"odom": "/odom", "scan": "/base/scan"}
    )
    with pytest.raises(
        ValueError,
        match=r"scan='laser_scan' must name a topic .* in this bag are: /base/scan \(sensor",
    ):
        recording_from_bag(path, TASK)
    with pytest.raises(
        ValueError,
        match=r"cmd_vel='cmd_vel' must name a topic of type geometry_msgs/msg/Twist or ",
    ):
        recording_from_bag(path, TASK, scan="base/scan")
    with pytest.raises(
        ValueError,
        match=r"scan='odom' must name a topic of type sensor_msgs/msg/LaserScan; .*Odom",
    ):
        recording_from_bag(path, TASK, scan="odom")


@pytest.mark.parametrize("form", FORMATS)
def test_a_damaged_bag_is_refused_in_one_sentence(driven, tmp_path, form):
    path = write_bag(tmp_path, form, driven[0][:90])
    whole = (
        path
        if path.is_file()
        else next(file for file in path.iterdir() if file.suffix != ".yaml")
    )
    data = whole.read_bytes()
    rng = np.random.default_rng(0)
    for i in range(12):
        cut = bytearray(data[: len(data) * i // 12])
        hit = bytearray(data)
        for at in rng.integers(len(data), size=40):
            hit[at] = rng.integers(256)
        for damaged in (cut, hit):
            whole.write_bytes(damaged)
            try:
                recording_from_bag(path, TASK)
            except ValueError as error:
                assert str(error).startswith(str(path)) and "\n" not in str(error)


def test_what_is_no_bag_is_refused(tmp_path):
    (tmp_path / "empty").mkdir()
    (tmp_path / "text.bag").write_text("no bag")
    for name in ("empty", "text.bag"):
        with pytest.raises(ValueError, match="not a whole bag of ROS 1 or ROS 2"):
            recording_from_bag(tmp_path / name, TASK)
    with pytest.raises(FileNotFoundError, match="no such bag"):
        recording_from_bag(tmp_path / "none.bag", TASK)


def lost(about):
    about.unlink()


def without_its_storage(about):
    text = about.read_text()
    for storage in ("sqlite3", "mcap"):
        text = text.replace(f"storage_identifier: {storage}", "storage_identifier: ''")
    about.write_text(text)


def of_the_files_former_name(about):
    (file,) = (file for file in about.parent.iterdir() if file != about)
    file.rename(file.with_stem("renamed"))


def cut_off(about):
    text = about.read_text()
    about.write_text(text[: len(text) // 2])


def of_a_later_version(about):
    text = about.read_text()
    about.write_text(text.replace("version: 9", "version: 99"))


def emptied(about):
    about.write_text("")


@pytest.mark.parametrize("form", ["sqlite3", "mcap"])
@pytest.mark.parametrize("spoil", [
    lost, without_its_storage, of_the_files_former_name, cut_off, of_a_later_version, emptied,
])  # fmt: skip
def test_a_bag_whose_description_is_lost_or_wrong_is_read_from_its_files(
    driven, tmp_path, form, spoil
):
    path = write_bag(tmp_path, form, driven[0])
    spoil(path / "metadata.yaml")
    (file,) = (file for file in path.iterdir() if file.suffix != ".yaml")
    for given_path in (path, file):
        assert_same(recording_from_bag(given_path, TASK), driven[1])


def test_all_files_of_a_bag_without_description_are_read_by_time(driven, tmp_path):
    path = tmp_path / "whole"
    path.mkdir()
    events = driven[0]
    # a tenth file comes before the second one by name
    for number in range(12):
        part = events[number * len(events) // 12 : (number + 1) * len(events) // 12]
        folder = tmp_path / str(number)
        folder.mkdir()
        file = write_bag(folder, "sqlite3", part) / "sqlite3.db3"
        file.rename(path / f"drive_{number}.db3")
    assert_same(recording_from_bag(path, TASK), driven[1])


def test_a_bag_of_which_a_file_is_missing_is_not_read_as_if_it_were_whole(
    driven, tmp_path
):
    path = write_bag(tmp_path, "mcap", driven[0])
    about = path / "metadata.yaml"
    text = about.read_text()
    about.write_text(text.replace("- mcap.mcap\n", "- mcap.mcap\n  - gone.mcap\n", 1))
    assert "gone" in about.read_text()
    with pytest.raises(ValueError, match=r"not a whole bag .* missing"):
        recording_from_bag(path, TASK)


@pytest.mark.parametrize("option", [
        {"tolerance": -1}, {"tolerance": math.nan},
        {"mounting": (0, 0)}, {"mounting": None}, {"mounting": (0, 0, math.nan, False)}, {"mounting": "base"},
    ])  # fmt: skip
def test_options_that_cannot_be_are_refused(driven, tmp_path, option):
    with pytest.raises(ValueError, match=next(iter(option))):
        recorded(tmp_path, driven[0][:30], **option)


def test_a_task_without_wheels_is_refused(tmp_path):
    with pytest.raises(
        ValueError, match="cmd_vel commands wheels alone, and arm_1k the robot 'arm'"
    ):
        recording_from_bag(tmp_path, "arm_1k")


def test_without_rosbags_one_sentence_says_what_to_install(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "rosbags.highlevel", None)
    with pytest.raises(ImportError, match="run pip install rosbags;"):
        recording_from_bag(tmp_path, TASK)


@pytest.mark.parametrize("form", FORMATS)
def test_messages_that_were_written_in_any_order_are_read_in_that_of_their_times(
    driven, tmp_path, form
):
    events, lived = driven
    shuffled = [events[i] for i in np.random.default_rng(2).permutation(len(events))]
    assert_same(recording_from_bag(write_bag(tmp_path, form, shuffled), TASK), lived)


def slow_minute(set_by=0, moment=30, publishers=((0.0375, 0.0),), speed=0.019):
    """A minute of a robot that gets half as far as it is told to, while its recorder's clock is set.

    set_by: seconds that the clock gains at this moment; publishers: what each of them commands ten times a second
    """
    events = []
    for i in range(1200):
        second = i / 20
        sent = 100 * SECOND + i * SECOND // 20
        time = sent + (set_by * SECOND if second >= moment else 0)
        place = {"x": speed * second, "y": 0.0, "theta": 0.0, "sent": sent}
        events.append((time, "odom", place))
        if i % 4 == 0:
            seen = vars(scan([1.5] * 360, 0.0, 2 * math.pi / 360))
            events.append((time + 1, "scan", {**seen, "sent": sent}))
        if i % 2 == 0:
            for number, (v, omega) in enumerate(publishers):
                at = time + 2 + number * SECOND // 1000
                events.append((at, "cmd_vel", {"v": v, "omega": omega}))
    return events


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("set_by", [-40, -5, -2, 3])
def test_a_recorders_clock_that_is_set_makes_no_reward_and_is_reported(
    tmp_path, form, set_by
):
    path = write_bag(tmp_path, form, slow_minute(set_by))
    recording = recording_from_bag(path, TASK)
    assert set(recording.r) == {-0.02}
    assert len(recording) >= 58 - 2 * abs(min(set_by, 0)) and set(recording.a) == {3}
    assert recording.report.disordered or set_by > 0
    if set_by < 0:
        assert "a clock was set" in str(recording.report)


@pytest.mark.parametrize("form", ["sqlite3", "mcap"])
def test_a_clock_that_is_set_between_two_files_of_a_bag_makes_no_reward(tmp_path, form):
    events = slow_minute(-5)
    half = len(events) // 2
    path = write_bag(tmp_path, form, events[:half])
    (tmp_path / "second").mkdir()
    second = write_bag(tmp_path / "second", form, events[half:])
    (first_file,) = (file for file in path.iterdir() if file.suffix != ".yaml")
    (second_file,) = (file for file in second.iterdir() if file.suffix != ".yaml")
    second_file.rename(path / f"second_{first_file.name}")
    about = path / "metadata.yaml"
    text = about.read_text()
    listed = f"- {first_file.name}\n"
    assert listed in text
    indent = text.split(listed)[0].rsplit("\n", 1)[1]
    both = f"{listed}{indent}- second_{first_file.name}\n"
    about.write_text(text.replace(listed, both, 1))
    recording = recording_from_bag(path, TASK)
    assert recording.report.messages["/odom"] == 1200
    assert set(recording.r) == {-0.02} and len(recording) >= 48
    assert recording.report.disordered


AHEAD, STAND, TURN = (0.0375, 0.0), (0.0, 0.0), (0.0, 0.163)


@pytest.mark.parametrize(
    "publishers", [(AHEAD, STAND), (AHEAD, TURN), (TURN, STAND), (AHEAD, (0.3, 0.0))]
)
def test_a_bag_with_two_publishers_of_commands_is_refused_with_the_cause(
    tmp_path, publishers
):
    with pytest.raises(ValueError, match="two publishers seem to send commands at"):
        recorded(tmp_path, slow_minute(publishers=publishers))


def test_one_driver_is_not_taken_for_two_publishers(driven, tmp_path):
    assert recorded(tmp_path, driven[0]).report.to_and_fro == 0
    tapped = []
    for time, kind, said in slow_minute():
        if kind == "cmd_vel" and time // (SECOND * 2 // 5) % 2:
            said = {"v": 0.0, "omega": 0.0}
        tapped.append((time, kind, said))
    (tmp_path / "tapped").mkdir()
    with pytest.raises(ValueError, match="hold each command for whole steps") as caught:
        recorded(tmp_path / "tapped", tapped)
    assert "publishers" not in str(caught.value)


def without_scans_in_time(event):
    time, kind, said = event
    return (time + (100 * SECOND if kind == "scan" else 0), kind, said)


def away(event):
    time, kind, said = event
    if kind == "odom":
        said = {**said, "x": 200 * said["x"]}
    return time, kind, said


def unlike_any_action(event):
    time, kind, said = event
    if kind == "cmd_vel":
        said = {"v": 0.05, "omega": -0.29}
    return time, kind, said


def with_clocks_at_odds(event):
    time, kind, said = event
    return time, kind, {**said, "sent": 2 * said.get("sent", time)}


@pytest.mark.parametrize(("spoilt", "advice"), [
    (without_scans_in_time, "record odometry, scan and commands at the same time"),
    (away, "is this the robot's own odometry"),
    (unlike_any_action, r"no action is like 0\.05 m/s and -0\.29 rad/s; the actions are .*, 0 m/s and 0 rad/s: choose"),
    (with_clocks_at_odds, "record again without setting a clock"),
])  # fmt: skip
def test_a_bag_without_a_step_is_refused_with_what_was_lost_and_what_to_do(
    tmp_path, spoilt, advice
):
    events = sorted(map(spoilt, slow_minute()), key=lambda event: event[0])
    with pytest.raises(ValueError, match=advice) as caught:
        recorded(tmp_path, events)
    assert "holds no step" in str(caught.value)
    assert not re.search(r"[ ,]0 [a-zA-Z]+ ", str(caught.value).split(";")[0])


def test_an_older_bag_of_ros_2_that_does_not_explain_its_messages_is_read(
    driven, tmp_path
):
    path = write_bag(tmp_path, "sqlite3", driven[0])
    with contextlib.closing(sqlite3.connect(path / "sqlite3.db3")) as base:
        base.execute("DELETE FROM message_definitions")
        base.commit()
    assert_same(recording_from_bag(path, TASK), driven[1])


def test_a_reward_that_asks_for_a_laser_out_of_view_says_so(driven, tmp_path):
    ahead = [
        (t, k, {**said, "ranges": said["ranges"][:3]} if k == "scan" else said)
        for t, k, said in driven[0]
    ]
    path = write_bag(tmp_path, "mcap", ahead)
    task = replace(rl.load_task(TASK), reward=lambda before, after: after["laser_rear"])
    with pytest.raises(
        ValueError,
        match=r"mcap: .*reward failed: there is no 'laser_rear'; did you mean .*There are laser_front, ",
    ):
        recording_from_bag(path, task, mounting=(0, 0, -math.pi / 4, False))


def test_a_goal_ends_an_episode_as_in_the_environment(driven, tmp_path):
    events, lived = driven
    task = replace(
        lived.task,
        goal=lambda readings: readings["laser_front_left"] < 0.25,
        goal_steps=2,
    )
    recording = recorded(tmp_path, events, task)
    near = np.array([lived.source.states.bins(s)[0] == 0 for s in lived.s_next])
    ends, in_a_row = [], 0
    for is_near in near:
        in_a_row = in_a_row + 1 if is_near else 0
        ends.append(in_a_row >= 2)
        in_a_row *= not ends[-1]
    assert recording.terminated.tolist() == ends and sum(ends) > 3
    cut = recording_from_bag(tmp_path / "mcap", replace(lived.task, episode_steps=40))
    assert np.flatnonzero(cut.truncated).tolist() == [39, 79, 119]
