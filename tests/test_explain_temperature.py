"""Curves, bars and slider of the temperature."""

import base64

import numpy as np
import pytest
from rlrobot_edu.course.lesson_03.temperature import TemperatureSlider, plot_temperature


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
    data, metadata = widget._repr_mimebundle_()
    first = base64.b64decode(data["image/png"])
    assert first == widget.widget.children[-1].value and "At T = 1:" in metadata["image/png"]["alt"]
    assert data["text/plain"] == TemperatureSlider([3.0, 1.0], 5.0)._repr_mimebundle_()[0]["text/plain"]
    widget.slider.value = 10.0
    data, metadata = widget._repr_mimebundle_()
    assert base64.b64decode(data["image/png"]) != first and "At T = 10:" in metadata["image/png"]["alt"]
