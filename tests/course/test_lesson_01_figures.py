"""Lesson 01's figures: bins as the task itself has them, and robots that drive about or do not."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_01.drive import Drive
from rlrobot_course.lesson_01.figures import (
    counted_bins,
    plot_bins,
    plot_cells,
    plot_drives,
)

INPUTS = rl.load_task("wander_1k").inputs
READINGS = {
    variable.name: reading
    for variable, reading in zip(INPUTS, (0.1, 0.27, 0.6, 0.8, 4.9), strict=True)
}


def test_every_row_names_the_bin_of_its_reading():
    ax = plot_bins(INPUTS, READINGS).axes[0]
    words = [text.get_text() for text in ax.texts if "→" in text.get_text()]
    assert [int(word.split()[-1]) for word in words] == [0, 0, 2, 2, 3]
    assert [label.get_text() for label in ax.get_yticklabels()] == [
        variable.name for variable in INPUTS
    ]


def test_a_bar_ends_in_the_bin_that_its_row_names():
    ax = plot_bins(INPUTS, READINGS).axes[0]
    bars = [bar for bar in ax.patches if bar.get_height() < 0.5]
    assert [bar.get_width() for bar in bars] == [
        0.1,
        0.27,
        0.6,
        0.8,
        1.6,
    ]  # the last is cut off at the edge


def test_an_input_without_cut_points_is_refused():
    with pytest.raises(ValueError, match="'theta' has no cut points"):
        plot_bins([rl.InputVariable("theta", sectors=8)], {"theta": 0})


def test_the_finding_counts_the_readings_in_each_bin():
    finding = plot_bins(INPUTS, READINGS).finding
    assert finding == "2 of 5 readings fall into bin 0, 2 into bin 2, 1 into bin 3"
    assert counted_bins([3]) == "1 of 1 readings falls into bin 3"


def drive_of(*ways):
    """A drive whose steps move the robot so far [m], one after the other, in a room of wander_simple."""
    env = rl.make_env("wander_simple", seed=0)
    env.reset()
    scene, start = env.unwrapped.robot.scene(), env.unwrapped.robot.readings
    places = np.cumsum([0.0, *ways])
    readings = [{**start, "x": float(x), "y": 0.0} for x in places]
    return Drive([scene] * len(readings), readings, [0.0] * len(ways))


def test_the_finding_names_the_robots_that_drive_about():
    stands, drives = drive_of(0.1, 0.0, 0.0), drive_of(0.1, 0.2, 0.0)
    some = plot_drives({"one": stands, "two": drives})
    assert some.finding == "1 of 2 robots drives about: two"
    none = plot_drives({"one": stands, "other": stands})
    assert none.finding == "None of the 2 robots drives about"
    both = plot_drives({"one": drives, "other": drives})
    assert both.finding == "All 2 robots drive about"


def test_the_picture_of_the_cells_says_where_robot_and_box_are():
    env = rl.make_env("worked_example", seed=0)
    env.reset()
    robot = env.unwrapped.robot
    finding = plot_cells(robot.scene(), robot.readings).finding
    here = "({X:g}, {Y:g})".format(**robot.readings)
    assert f"stands in cell {here}" in finding
    assert f"the box in cell {here}" not in finding
