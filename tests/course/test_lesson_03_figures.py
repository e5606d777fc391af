"""Lesson 03's figures and its slider: what they draw is what was counted, sampled and learned."""

import gymnasium
import numpy as np
import pytest

from rlrobot_edu.course.lesson_03.figures import count_visits, plot_draw, plot_visits
from rlrobot_edu.course.lesson_03.temperature_slider import TemperatureSlider, plot_temperature


def test_visits_are_counted_where_steps_end_and_the_map_names_the_cells():
    lake = gymnasium.make("FrozenLake-v1", is_slippery=False)  # action 0 is left, 1 is down
    left, down = count_visits(lake, np.argmax, episodes=2), count_visits(lake, lambda q_s: 1, episodes=3)
    assert left[0] == left.sum() == 2 * 100, "into the wall until time is up"
    assert [down[s] for s in (4, 8, 12)] == [3, 3, 3] and down.sum() == 9, "three steps down into the hole"
    figure = plot_visits(lake, {"left": left, "down": down}, "title")
    assert "left: 1 of 16 squares seen, the goal 0 times; down: 3 of 16" in figure.alt
    texts = [text.get_text() for text in figure.axes[1].texts]
    assert texts[0] == "start\nnever" and texts[12] == "hole\n33.3 %" and len(texts) == 16


def test_the_segment_under_the_point_is_the_action_that_is_sampled():
    for u, sampled in ((0.0, 1), (0.49, 1), (0.5, 2), (0.99, 2)):
        figure = plot_draw([0.0, 0.5, 0.5], u)
        assert f"draws action {sampled}" in figure.alt
        strong = [bar for bar in figure.axes[0].patches if bar.get_alpha() == 1]
        assert len(strong) == 1 and strong[0].get_x() <= u < strong[0].get_x() + strong[0].get_width()


def test_the_bars_show_the_softmax_and_the_curves_end_at_greedy_and_at_random():
    figure = plot_temperature([2.0, 0.0, 1.0], 2.0)
    heights = [bar.get_height() for bar in figure.axes[1].patches]
    assert sum(heights) == pytest.approx(1)
    assert heights[0] / heights[1] == pytest.approx(np.e), "two apart at a temperature of two"
    curves = np.array([line.get_ydata() for line in figure.axes[0].lines[:3]])
    assert np.allclose(curves[:, 0], [1, 0, 0], atol=1e-4) and np.allclose(curves[:, -1], 1 / 3, atol=1e-3)
    assert "At T = 2: action 0 0.506" in figure.alt


def test_the_slider_has_a_still_twin_that_follows_it():
    widget = TemperatureSlider([2.0, 0.0], temperature=1.0)
    data = widget._repr_mimebundle_()
    first = data["text/html"]
    assert first == widget.widget.children[-1].value and "At T = 1:" in first
    assert data["text/plain"] == TemperatureSlider([3.0, 1.0], 5.0)._repr_mimebundle_()["text/plain"]
    widget.slider.value = 10.0
    data = widget._repr_mimebundle_()
    assert data["text/html"] != first and "At T = 10:" in data["text/html"]
