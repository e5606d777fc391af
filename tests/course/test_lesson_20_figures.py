"""Lesson 20: the drivers drive as they say, pupils and copies do what was shown, and the figures tell it."""

import joblib
import numpy as np
import pytest
from scipy import stats

import rlrobot_edu as rl
from rlrobot_course.figures.rows import compared, heaped
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.lesson_20 import driver
from rlrobot_course.lesson_20.figures import plot_dots, plot_worth
from rlrobot_course.lesson_20.pupils import copies, pupils
from rlrobot_edu.experiments.repetitions import repetition
from rlrobot_edu.widgets.driving.pad import teleoperate

FAR = dict.fromkeys(
    (
        "laser_front",
        "laser_front_left",
        "laser_left",
        "laser_right",
        "laser_front_right",
    ),
    2.0,
)


@pytest.fixture(scope="module")
def lesson():
    return driver.drive(driver.careful, steps=120).recording


def test_the_careful_driver_turns_away_from_the_nearer_wall_and_slips_one_time_in_ten():
    def often(lasers):
        rng = np.random.default_rng(0)
        return (
            np.bincount([driver.careful(lasers, rng) for _ in range(2000)], minlength=9)
            / 2000
        )

    for lasers, a in (
        (FAR, 8),
        (FAR | {"laser_front_left": 0.2}, 6),
        (FAR | {"laser_front_right": 0.2}, 2),
    ):
        assert often(lasers)[a] == pytest.approx(1 - driver.SLIP * 8 / 9, abs=0.02)


def test_the_learners_lesson_comes_before_the_stand_in_and_is_kept(tmp_path):
    with rl.make_env("wander_1k", seed=0) as env:
        pad, turns = teleoperate(env), [6, 8, 8, 2] * (driver.ENOUGH // 4)
        assert driver.lesson_of(pad, tmp_path / "mine")[0] == "our stand-in"
        for a in turns:
            pad.press(a)
        pad.start_again()
        pad.press(8)
        who, lesson, filmed = driver.lesson_of(pad, tmp_path / "mine")
        assert who == "you" and lesson.a.tolist() == [*turns, 8] and filmed is pad
        who, kept, filmed = driver.lesson_of(teleoperate(env), tmp_path / "mine")
    assert who == "you, before" and kept.a.tolist() == [*turns, 8]
    assert (
        filmed.recording.s_next.tolist() == lesson.s_next.tolist()
        and filmed.film.gif() == pad.film.gif()
    )


def test_too_few_steps_are_said_to_be_too_few_and_nobody_films_them(tmp_path):
    with rl.make_env("wander_1k", seed=0) as env:
        pad = teleoperate(env)
        for _ in range(24):
            pad.press(6)
        who, lesson, filmed = driver.lesson_of(pad, tmp_path / "mine")
    assert who == "our stand-in (you drove 24 steps; a lesson takes 100)"
    assert (
        len(lesson) == 300
        and filmed.recording.a.tolist() == lesson.a.tolist()
        and not list(tmp_path.iterdir())
    )


def test_pupils_without_a_teacher_are_plain_repetitions_and_a_lesson_changes_them(
    lesson,
):
    with joblib.parallel_config("sequential"):
        alone, taught = (
            pupils(each, steps=60, repetitions=2) for each in (None, lesson)
        )
        same = [
            repetition("wander_1k", {"method": "TOSL+QBIASSR"}, {"steps": 60}, seed)
            for seed in np.random.SeedSequence(0).spawn(2)
        ]
    by_itself, again, with_lesson = (
        [h.rewards for h in runs] for runs in (alone, same, taught)
    )
    assert np.array_equal(by_itself, again) and not np.array_equal(
        by_itself, with_lesson
    )
    assert (taught[0].visits.sum(), alone[0].visits.sum()) == (60 + len(lesson), 60)


def test_who_copies_the_stubborn_driver_knows_one_button(lesson):
    ahead = driver.drive(driver.stubborn, steps=60).recording
    runs = copies(ahead, steps=60, repetitions=2)
    assert all(
        (run.a == driver.AHEAD).all() and (run.rewards == ahead.r).all() for run in runs
    )
    run = copies(lesson, steps=60, repetitions=1)[0]
    done = set(zip(lesson.s.tolist(), lesson.a.tolist(), strict=True))
    assert all(
        (s, a) in done
        for s, a in zip(run.s.tolist(), run.a.tolist(), strict=True)
        if s in lesson.s
    )


def test_the_interval_is_students():
    values = np.random.default_rng(0).normal(2, 3, 20)
    low, high = stats.t.interval(0.95, 19, values.mean(), stats.sem(values))
    assert mean_and_half(values) == pytest.approx(((low + high) / 2, (high - low) / 2))


def test_the_figures_show_their_numbers():
    groups = {"a": [3.0, 1.0, 2.0], "b": [5.0, 5.0, 8.0]}
    dots = plot_dots(groups, "b", "a", "steps")
    shown = [group.get_offsets()[:, 0].tolist() for group in dots.axes[0].collections]
    assert shown == [[1, 2, 3], [5, 5, 8]]
    assert dots.finding == "“b” earns more than “a”: 6.0 a step against 2.0"
    worth = {
        "careful": {"earned": 2.0, "Q": 1.5, "SARSA": -2.0},
        "clumsy": {"earned": 5.0, "Q": 57.0, "SARSA": 4.0},
    }
    picture = plot_worth(worth)
    marks = [line.get_xdata()[0] for line in picture.axes[0].lines if line.get_marker() in "Dso"]  # fmt: skip
    assert marks == [2.0, 1.5, -2.0, 5.0, 57.0, 4.0]
    assert picture.finding.startswith("Q values the clumsy lesson at 57, SARSA at 4")


def test_groups_that_chance_may_explain_are_too_close_to_tell():
    groups = {"a": [1.0, 5.0, 3.0], "b": [2.0, 4.0, 4.0]}
    assert "too close to tell" in compared(groups, "b", "a")
    assert compared({"a": [1.0, 1.1], "b": [9.0, 9.1]}, "a", "b").startswith(
        "“a” earns less"
    )


def test_dots_of_a_heap_do_not_lie_on_each_other():
    values = np.sort(np.random.default_rng(0).normal(size=40))
    heights = heaped(values, 0.3)
    for height in range(heights.max() + 1):
        assert (np.diff(values[heights == height]) >= 0.3).all()
    assert heaped(np.array([1.0, 1.0, 9.0]), 0.3).tolist() == [0, 1, 0]
