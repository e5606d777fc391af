"""Learning curves in several panels."""

from types import SimpleNamespace

import numpy as np
import pytest
from rlrobot_edu.course.lesson_03.side_by_side import plot_side_by_side


def test_each_panel_has_its_curves_and_the_alt_text_their_ends():
    groups = [[SimpleNamespace(average_reward=np.array([0.0, end]), method="m")] for end in (1.5, -2.5)]
    figure = plot_side_by_side({"one": groups, "two": groups[::-1], "three": groups}, ["A", "B"], "title", columns=3)
    assert [ax.get_title() for ax in figure.axes] == ["one", "two", "three"]
    assert [line.get_ydata()[-1] for line in figure.axes[1].lines] == [-2.5, 1.5]
    assert figure.alt.endswith("one: A 1.50, B -2.50; two: A -2.50, B 1.50; three: A 1.50, B -2.50.")
    with pytest.raises(ValueError, match="2 curves"):
        plot_side_by_side({"one": groups}, ["A"], "title", columns=1)
