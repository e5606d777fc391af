"""How close our physics is to V-REP's: the measure itself, and that the robot as it is now is nearer than as found."""

from functools import cache

import numpy as np
import pytest
from vrep_comparison import distance, joined, often_seen, same_choices, shares
from vrep_worlds import FOUND, NOW, PRESET, World

from rlrobot_edu.learning.transitions import Transitions


def rows(*transitions):
    s, a, s_next, r = map(np.array, zip(*transitions, strict=True))
    return Transitions(s, a, r, s_next, terminated=s < 0, truncated=s < 0)


def test_the_distance_is_the_total_variation_weighted_by_the_visits_of_the_reference():
    one = rows(*[(0, 0, 1, 10.0)] * 3, *[(1, 0, 1, -2.0)])
    two = rows(
        *[(0, 0, 1, 10.0)] * 1,
        *[(0, 0, 2, 10.0)] * 1,
        *[(1, 0, 2, -2.0)],
        (5, 5, 5, 10.0),
    )
    pairs = often_seen([one, two], least=1)
    assert pairs == {(0, 0), (1, 0)} and often_seen([one, two], least=2) == {(0, 0)}
    assert distance(one, one, pairs) == 0
    assert distance(one, two, pairs) == pytest.approx((3 * 0.5 + 1 * 1.0) / 4)
    assert distance(one, two, pairs, of=lambda s_next, r: r) == 0


@pytest.fixture(scope="module")
def lived(vrep):
    """What our robot lives through in a world, in two recordings; the page has six, and without physics 24."""
    return cache(
        lambda world: joined([same_choices(world, seed, vrep) for seed in (0, 1)])
    )


@pytest.mark.long
def test_robot_and_maze_of_the_papers_scene_bring_us_closer_to_vrep_and_lag_and_friction_no_further_away(
    vrep, lived
):
    """The limits are the noise of so few recordings above what the page says."""
    found, now, preset = map(lived, (FOUND, NOW, PRESET))
    pairs = often_seen([vrep, found, now, preset])
    assert len(pairs) > 40
    assert distance(vrep, now, pairs) < min(0.245, distance(vrep, found, pairs))
    assert distance(vrep, preset, pairs) < 0.245
    assert shares(now) == pytest.approx(shares(vrep), abs=0.03)
    assert (now.r == -10).mean() < 0.001 < (found.r == -10).mean()


@pytest.mark.long
def test_the_base_without_a_physics_engine_is_about_as_near_to_vrep_as_pymunks(
    vrep, lived
):
    """Within the noise of so few recordings."""
    now, kinematic = map(lived, (NOW, World(engine="kinematic")))
    pairs = often_seen([vrep, now, kinematic])
    assert len(pairs) > 40
    assert distance(vrep, kinematic, pairs) == pytest.approx(
        distance(vrep, now, pairs), abs=0.02
    )
