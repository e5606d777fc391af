"""Lesson 07a's figure: the register keeps the traces that are worth it."""

import pytest

from rlrobot_course.lesson_07a.figures import plot_register
from rlrobot_edu.learning.memory import trace_steps


@pytest.mark.parametrize(("gamma", "lam", "threshold"), [(0.9, 0.9, 0.01), (0.9, 0.5, 0.01), (0.99, 0.8, 0.1)])
def test_the_register_keeps_the_traces_above_the_threshold(gamma, lam, threshold):
    picture = plot_register(gamma, lam, threshold)
    _, kept, dropped, *_ = picture.axes[0].lines
    assert kept.get_ydata().min() > threshold > dropped.get_ydata().max()
    assert len(kept.get_ydata()) == trace_steps(gamma, lam, threshold) + 1
