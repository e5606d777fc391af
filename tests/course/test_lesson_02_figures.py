"""Lesson 02's figures: spreading values against a search through the map."""

import gymnasium
import numpy as np
from matplotlib.text import Annotation

from rlrobot_course.lesson_02.figures import ARROWS, plot_returns, plot_sweep, plot_ways

LAKE = gymnasium.make("FrozenLake-v1", map_name="8x8", is_slippery=False).unwrapped
GAMMA = 0.9


def distances():
    """Steps to the goal from every square, without the holes: a search that begins at the goal."""
    steps, edge = {63: 0}, [63]
    for s in edge:
        y, x = divmod(s, 8)
        for right, down in ARROWS.values():
            i, j = y + down, x + right
            if (
                0 <= i < 8
                and 0 <= j < 8
                and LAKE.desc[i, j] != b"H"
                and 8 * i + j not in steps
            ):
                steps[8 * i + j] = steps[s] + 1
                edge.append(8 * i + j)
    return steps


DISTANCES = distances()
# after k sweeps all squares at most k steps away know their value
SWEEPS = {
    k: np.array(
        [
            GAMMA ** (DISTANCES[s] - 1) if 0 < DISTANCES.get(s, 0) <= k else 0.0
            for s in range(64)
        ]
    )
    for k in (0, 1, 2, 5)
}


def test_a_picture_shows_its_sweep():
    values = list(SWEEPS.values())
    for i, v in enumerate(values):
        figure = plot_sweep(values, i, LAKE.desc)
        assert f"{np.count_nonzero(v)} of 64 squares" in figure.finding
        ax = figure.axes[0]
        assert np.array_equal(ax.images[0].get_array(), v.reshape(8, 8))
        numbers = {
            text.get_position(): text.get_text()
            for text in ax.texts
            if text.get_text() not in "SG"
        }
        shown = {(s % 8, s // 8): f"{x:.2f}".lstrip("0") for s, x in enumerate(v) if x}
        assert numbers == shown


def test_a_bar_is_the_reward_and_what_counts_of_it():
    rewards = [10.0, -2.0, 4.0]
    ax = plot_returns({"a policy": rewards}, [0.5], shown=3).axes[0]
    assert [bar.get_height() for bar in ax.patches] == [*rewards, 10, -1, 1]
    assert ax.get_title().endswith("G = 10.00")


def test_the_finding_says_how_far_the_returns_are_apart():
    policies = {"one": [1.0, 0.0], "other": [0.0, 4.0]}
    finding = plot_returns(policies, [0.5, 1.0], shown=2).finding
    assert finding == "The returns are apart by 1.00 with γ = 0.5, by 3.00 with γ = 1.0"


def test_arrows_lead_to_squares_that_are_nearer_to_the_goal():
    v = np.array(
        [
            0.0 if s not in DISTANCES or s == 63 else GAMMA ** (DISTANCES[s] - 1)
            for s in range(64)
        ]
    )
    q = np.zeros((64, 4))
    for s in range(64):
        for a in range(4):
            _, s_next, r, terminated = LAKE.P[s][a][0]
            q[s, a] = r + (0 if terminated else GAMMA * v[s_next])
    figure = plot_ways(q, LAKE.desc)
    assert figure.finding.startswith("All ")
    assert "of" in plot_ways(-q, LAKE.desc).finding.split()
    arrows = [
        (text.xyann, text.xy)
        for text in figure.axes[0].texts
        if isinstance(text, Annotation)
    ]
    assert {x + 8 * y for (x, y), _ in arrows} == set(DISTANCES) - {63}
    for (x, y), (to_x, to_y) in arrows:
        after = 8 * round(y + (to_y - y) / 0.45) + round(x + (to_x - x) / 0.45)
        assert DISTANCES[after] == DISTANCES[8 * y + x] - 1
