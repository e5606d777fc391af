"""Right answers in another form than the solution's, and wrong ones that look right: what a beginner wrote."""

import math

import numpy as np
import pytest

from rlrobot_course.lesson_11 import challenge as sensors
from rlrobot_course.lesson_12 import check as navigation
from rlrobot_course.lesson_13 import check as arm
from rlrobot_course.lesson_14 import check as models
from rlrobot_course.lesson_16 import check as own_task
from rlrobot_course.lesson_17 import check as beyond
from rlrobot_course.lesson_18 import challenge as reality
from rlrobot_course.lesson_18 import check as real


def by_episodes(env, q, seen, choose, update, pick, steps):
    n = 0
    while n < steps:
        s, done = env.reset(), False
        while not done and n < steps:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            update(q, s, a, r, s_next, terminated)
            seen[s, a] = (r, s_next, terminated)
            for pair in pick(seen):
                update(q, *pair, *seen[pair])
            s, done, n = s_next, terminated or truncated, n + 1


def resets_when_going_on(env, q, seen, choose, update, pick, steps):
    done = True
    for _ in range(steps):
        if done:
            s = env.reset()
        a = choose(q, s)
        s_next, r, terminated, truncated = env.step(a)
        update(q, s, a, r, s_next, terminated)
        seen[s, a] = (r, s_next, terminated)
        for pair in pick(seen):
            update(q, *pair, *seen[pair])
        s, done = s_next, terminated or truncated


@pytest.mark.parametrize("loop", [by_episodes, resets_when_going_on])
def test_dyna_may_reset_at_the_head_of_its_loop(loop):
    assert beyond.dyna(loop)


def test_a_wall_behind_does_not_hide_one_as_near_ahead():
    def by_index(ranges, angle_min, increment):
        met = [r for r in ranges if 0 < r < math.inf]
        ahead = [
            r for r in met if math.cos(angle_min + ranges.index(r) * increment) >= 0.5
        ]
        return min(ahead, default=math.inf) if met else math.nan

    assert "enumerate" in real.nearest_ahead(by_index).hint


@pytest.mark.filterwarnings("error")
def test_infinity_and_nan_in_a_wrong_answer_warn_of_nothing():
    assert not real.nearest_ahead(lambda ranges, angle_min, increment: math.inf)
    assert not real.nearest_ahead(lambda ranges, angle_min, increment: min(ranges))


def test_a_dict_that_is_asked_is_not_refused_for_its_brackets_and_the_rows_of_the_pair_are_shown():
    def lists(rows, s, a):
        found = {}
        for s_row, a_row, r, s_next in rows:
            if (s_row, a_row) == (s, a):
                found.setdefault(s_next, []).append(r)
        return found

    verdict = models.estimate(lists)
    assert not verdict and "curly" not in verdict.hint
    assert (
        "rows of this pair: (0, 1, -2.0, 1), (0, 1, 10.0, 1)" in verdict.called
        and "0.57143" in verdict.rows[0][1]
    )


def test_a_reward_without_a_return_is_shown_where_it_returned_nothing():
    def reward(before, after):
        if after <= 0.05:
            return 10
        if before - after > 0.02:
            return 1

    verdict = arm.arm_reward(reward)
    assert (
        verdict.rows == (("reward", "a number", "None"),) and "return" in verdict.hint
    )


@pytest.mark.parametrize("forbidden", [-np.inf, np.nan])
def test_a_reward_that_is_not_finite_follows_no_wall(forbidden):
    def reward(before, after):
        near = min(
            after["laser_front"], after["laser_front_right"], after["laser_right"]
        )
        moved = np.hypot(after["x"] - before["x"], after["y"] - before["y"])
        return (
            forbidden
            if near < 0.05
            else 10
            if moved > 0.07 and 0.10 < after["laser_right"] <= 0.40
            else 0
        )

    assert own_task.follow_reward(reward).id == "no_number"


def test_two_answers_where_one_tuple_is_asked_are_told_so():
    assert "check((10, 55))" in f"check{navigation.targets(10, 55).hint.split(': ')[1]}"


def test_a_challenge_refuses_a_free_ride():
    assert "a guard lets" in reality.challenge(lambda readings, a: 0).text
    assert "a guard lets" in reality.challenge(lambda readings, a: 2.5).text
    assert "x is none of the eight lasers" in sensors.challenge({"x": [0.0]}).text
