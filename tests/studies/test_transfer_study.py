"""The study of transfer: what it compares, and that a carry can be measured at all."""

import numpy as np
import pytest
import transfer as study


def test_a_way_is_compared_with_learning_from_scratch_over_the_first_steps_alone():
    rewards = np.zeros((4, 2, 6))
    rewards[:, 1, :2] = [[1, 2], [2, 3], [3, 4], [4, 5]]
    said, p, better = study.compared(rewards, 1, 2)
    assert (
        said == "3.00 ± 2.05" and better == 1 and p == pytest.approx(0.0211, abs=1e-4)
    )  # t(0.975, 3) = 3.182
    assert study.compared(rewards, 0, 6)[2] == 0.5
    assert "first 100 steps" not in str(study.table(study.CARRIES[1], rewards, 1))


def test_every_way_of_beginning_is_measured_with_random_numbers_of_its_own():
    carry = study.CARRIES[2]
    rewards, share = study.once(carry, 0, steps=12, source_steps=30)
    assert rewards.shape == (len(study.WAYS), 12) and 0 < share < 1
    assert np.array_equal(study.once(carry, 0, 12, 30)[0], rewards)
    assert len({tuple(way) for way in rewards.tolist()}) > 1
