"""Lesson 07's figure: how far a reward has spread."""

import numpy as np

from rlrobot_course.lesson_07.figures import plot_corridor


def test_the_picture_of_the_corridor_shows_every_value_and_says_how_far_it_got():
    table = np.array([[0.0, 0.0, 9.0], [0.0, 8.1, 9.0]])
    picture = plot_corridor({"SARSA": table, "SARSA(λ)": table + 1})
    assert picture.finding == (
        "The reward reaches the first cell with SARSA not in 2 drives, with SARSA(λ) in 1 drive"
    )
    table[1, 0] = 7.0
    assert plot_corridor({"SARSA": table}).finding.endswith("with SARSA in 2 drives")
    assert [len(ax.texts) for ax in picture.axes] == [6, 6]
