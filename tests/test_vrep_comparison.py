"""How close our physics is to V-REP's: the measure itself, and that the robot as it is now is nearer than as found."""

import numpy as np
import pytest
from joblib import Parallel, delayed
from vrep_comparison import BEFORE, PIONEER, distance, often_seen, same_choices, shares

from rlrobot_edu.learning.transitions import Transitions


def rows(*transitions):
    s, a, s_next, r = map(np.array, zip(*transitions, strict=True))
    return Transitions(s, a, r, s_next, terminated=s < 0, truncated=s < 0)


def test_the_distance_is_the_total_variation_weighted_by_the_visits_of_the_reference():
    one = rows(*[(0, 0, 1, 10.0)] * 3, *[(1, 0, 1, -2.0)])
    two = rows(*[(0, 0, 1, 10.0)] * 1, *[(0, 0, 2, 10.0)] * 1, *[(1, 0, 2, -2.0)], (5, 5, 5, 10.0))
    pairs = often_seen([one, two], least=1)
    assert pairs == {(0, 0), (1, 0)} and often_seen([one, two], least=2) == {(0, 0)}
    assert distance(one, one, pairs) == 0
    assert distance(one, two, pairs) == pytest.approx((3 * 0.5 + 1 * 1.0) / 4)
    assert distance(one, two, pairs, of=lambda s_next, r: r) == 0


def test_our_robot_meets_walls_as_the_one_in_vrep_does(vrep):
    run = delayed(same_choices)
    before, now = Parallel(n_jobs=-1)(run(chassis, 0, vrep) for chassis in (BEFORE, PIONEER))
    pairs = often_seen([vrep, before, now])
    assert len(pairs) > 40
    assert distance(vrep, now, pairs) < 0.3
    assert distance(vrep, now, pairs) < distance(vrep, before, pairs) - 0.03
    assert shares(now) == pytest.approx(shares(vrep), abs=0.1)
