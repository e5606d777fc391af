"""Lesson 00's figure: the lasers that count stand out, and what is written covers neither beams nor walls."""

import numpy as np

import rlrobot_edu as rl
from rlrobot_course.lesson_00.figures import free_place, plot_lasers

TASK = rl.load_task("wander_1k")


def test_the_finding_names_the_nearest_wall_among_the_lasers_that_count():
    env = rl.make_env(TASK, seed=0)
    env.reset()
    robot = env.unwrapped.robot
    readings = dict(robot.readings)
    lasers = [name for name in readings if name.startswith("laser")]
    counted = [variable.name for variable in TASK.inputs]
    for laser in lasers:
        readings[laser] = 2.0
    uncounted = next(name for name in lasers if name not in counted)
    readings[uncounted] = 0.1
    readings["laser_left"] = 1.25
    picture = plot_lasers(robot.scene(), readings, TASK.inputs)
    assert picture.finding.startswith(f"{len(counted)} of {len(lasers)} lasers count")
    assert "1.25 m" in picture.finding
    assert "(left)" in picture.finding


def test_a_reading_stands_on_the_side_of_its_beam_that_is_free():
    beam = np.array([(0.0, 0.0), (2.0, 0.0)])
    wall = np.array([(0.0, 0.5), (2.0, 0.5)])
    assert free_place(beam, [wall])[1] < 0
    assert free_place(beam, [-wall])[1] > 0
