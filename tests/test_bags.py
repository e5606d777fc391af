"""Drives in bags of ROS 1 and ROS 2 become the transitions that the robot lived through, and nothing else."""

import math
import sys
from dataclasses import replace

import numpy as np
import pytest
from bags import FORMATS, SECOND, TOPICS, drive, full_scan, write_bag

import rlrobot_edu as rl

pytest.importorskip("rosbags.highlevel", reason="rosbags is missing: pip install 'rlrobot-edu[ros]'")
TASK = "giraff_wander_simple"


def assert_same(one: rl.Recording, two: rl.Recording) -> None:
    for a, b in zip(one.transitions, two.transitions, strict=True):
        np.testing.assert_array_equal(a, b)


@pytest.fixture(scope="module")
def driven():
    return drive(TASK, 150)


@pytest.mark.parametrize("form", FORMATS)
def test_each_format_gives_the_transitions_that_the_robot_lived_through(driven, tmp_path, form):
    events, lived = driven
    recording = rl.recording_from_bag(write_bag(tmp_path, form, events), TASK)
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
    assert_same(rl.recording_from_bag(path, TASK, odom="robot/odom", scan="/scan", cmd_vel="/robot/cmd_vel"), lived)
    assert_same(
        rl.recording_from_bag(path / "mcap.mcap", TASK, odom="robot/odom", scan="scan", cmd_vel="/robot/cmd_vel/"),
        lived,
    )


@pytest.mark.parametrize("task", ["wander_simple", "wander_1k"])
def test_a_base_whose_lasers_stand_off_the_scanners_lines_lives_through_the_same(tmp_path, task):
    events, lived = drive(task, 60, see=full_scan)
    recording = rl.recording_from_bag(write_bag(tmp_path, "sqlite3", events), task)
    np.testing.assert_array_equal(recording.r, lived.r)
    commands = [[lived.task.command_for(a) for a in who.a] for who in (recording, lived)]
    assert commands[0] == commands[1]
    bins = [np.stack(np.unravel_index(who.s, lived.source.states.shape)) for who in (recording, lived)]
    assert (bins[0] != bins[1]).mean() < 0.01  # a wall just at the limit of a bin, seen by a ray half a degree wide
