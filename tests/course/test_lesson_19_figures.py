"""Lesson 19's figure: what one reward has paid of each value."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_19.figures import plot_shares, shares_of


@pytest.mark.parametrize("lam", [0.0, 0.5, 0.9])
def test_what_all_steps_have_paid_together_is_q(lam):
    agent = rl.Agent("worked_example", "SL+SR", lam=lam, seed=0, loop_evasion=False)
    steps = list(rl.steps(agent, rl.make_env("worked_example", seed=0), 30))
    paid = sum(shares_of(steps, t, "worked_example", lam) for t in range(1, 31))
    np.testing.assert_allclose(paid, agent.q, atol=1e-12)


def test_the_map_of_who_was_paid_has_a_row_for_each_state_that_the_reward_reached():
    agent = rl.Agent("worked_example", "SL+SR", seed=0, loop_evasion=False)
    steps = list(rl.steps(agent, rl.make_env("worked_example", seed=0), 30))
    picture = plot_shares(steps, 21, "worked_example", (0, 0.9))
    reached = np.flatnonzero(shares_of(steps, 21, "worked_example", 0.9).any(axis=1))
    assert [
        int(label.get_text()) for label in picture.axes[0].get_yticklabels()
    ] == reached.tolist()
    n = np.count_nonzero(shares_of(steps, 21, "worked_example", 0.9))
    assert picture.finding.endswith(f"has a share: 1 with λ = 0, {n} with λ = 0.9")
