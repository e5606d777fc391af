"""Lesson 05's figures: similar states differ in one input, and draws are counted; and its table of biases by hand."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_05.figures import plot_draws, plot_similar_states
from rlrobot_edu.widgets.kernels import bias_of

TASK = rl.load_task("worked_example")
STATES = TASK.states


def pose(ax) -> tuple:
    """Bins of what a small map shows: the coloured cell, the direction of its bar, and how thick that is."""
    (cell,) = [p for p in ax.patches if p.get_facecolor() != (1, 1, 1, 1)]
    x, y = (round(float(at) + 0.5) for at in cell.get_xy())
    bar = ax.lines[0]
    ahead = np.mean(bar.get_xydata(), axis=0) - (x, y)
    theta = {(1, 0): 0, (0, 1): 1, (0, -1): 2}[
        tuple(np.sign(ahead.round(6)).astype(int))
    ]
    return x, y, theta, int(bar.get_linewidth() > 2)


@pytest.mark.parametrize("s", [0, 13, 21])
def test_each_row_of_maps_is_a_set_and_the_state_itself_is_in_each(s):
    maps = np.array(plot_similar_states(s).axes).reshape(4, 3)
    for i, (row, states) in enumerate(
        zip(maps, STATES.siblings(s).values(), strict=True)
    ):
        shown = [ax for ax in row if ax.patches]
        assert [int(ax.get_title().split("state ")[1]) for ax in shown] == list(states)
        assert [pose(ax) for ax in shown] == [STATES.bins(k) for k in states]
        assert [pose(ax)[i] for ax in shown] == list(range(len(states))) and s in states
        assert [ax.title.get_weight() == "bold" for ax in shown] == [
            k == s for k in states
        ]


def test_the_finding_counts_the_similar_states_without_the_state_itself():
    finding = plot_similar_states(1).finding
    assert "5 similar states in 4 sets" in finding


def test_a_state_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="there is no state 24"):
        plot_similar_states(24)


def test_the_bars_of_the_draws_count_each_action():
    figure = plot_draws(
        {"Q(s)": [0, 1, 1, 2], "Q(s) + bias(s)": [1, 1, 1, 2]},
        ["advance", "left", "right"],
    )
    bars = [
        [bar.get_height() for bar in container]
        for container in figure.axes[0].containers
    ]
    assert bars == [[1, 2, 1], [0, 3, 1]]
    assert (
        "1 bumps without the bias, 0 with it" in figure.finding
        and "right 1" in figure.alt
    )


def test_the_table_by_hand_has_the_librarys_bias():
    notebook = Path(__file__).parents[2] / "notebooks/05_qbiassr.ipynb"
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    (cell,) = [x for x in cells if x["source"][0].startswith("**By hand.**")]
    rows = re.findall(
        r"^\| ([-−\d, ]+) \|.*\| (.+) \| (.+) \| (.+) \|$",
        "".join(cell["source"]),
        re.M,
    )
    assert len(rows) == 3
    for values, means, bias, total in rows:
        q = np.array([[float(x.replace("−", "-"))] for x in values.split(",")])
        assert bias_of(q, (2, 2), 0) == float(bias)
        assert q[0] + bias_of(q, (2, 2), 0) == float(total)
        by_first, by_second = (float(x) for x in means.split(" and "))
        assert (by_first, by_second) == (q[[0, 2]].mean(), q[[0, 1]].mean())
