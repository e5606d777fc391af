"""Lesson 05's figures: similar states differ in one input, and the five lines are the paper's."""

import re

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_05.figures import (
    advice,
    five_lines,
    plot_five_lines,
    plot_similar_states,
)
from rlrobot_edu.widgets.kernels import bias_of

TASK = rl.load_task("worked_example")
STATES = TASK.states


# The paper's example in section 3.3: of each input of the state (1, 1, 90, T), the states whose Q it averages.
FIVE_LINES = {
    "bias_x(s)": ["0,1,90,T", "1,1,90,T"],
    "bias_y(s)": ["1,0,90,T", "1,1,90,T"],
    "bias_θ(s)": ["1,1,0,T", "1,1,90,T", "1,1,-90,T"],
    "bias_d(s)": ["1,1,90,T", "1,1,90,F"],
}
PAPERS_STATE = STATES.number((1, 1, 1, 1))


@pytest.fixture(scope="module")
def new_there() -> rl.Agent:
    """The robot of the lesson that comes to the paper's state for the first time."""
    agent = rl.Agent(TASK, "Q+SR", alpha=0.3, seed=138, loop_evasion=False)
    rl.learn(agent, rl.make_env(TASK, seed=138), steps=71, progress=False)
    return agent


def test_the_five_lines_are_the_papers():
    lines = [symbols for symbols, _ in five_lines(np.zeros((24, 3)), PAPERS_STATE, 0)]
    for line, (name, states) in zip(lines, FIVE_LINES.items(), strict=False):
        assert line.startswith(f"{name} = (") and line.endswith(f") / {len(states)}")
        shown = re.findall(r"Q\((.+?)\)", line.replace("−", "-"))
        assert sorted(shown) == sorted(states)
    assert lines[4] == f"bias(s) = ({' + '.join(FIVE_LINES)}) / 4"


@pytest.mark.parametrize("a", [0, 1, 2])
def test_the_numbers_of_the_five_lines_are_what_the_papers_lines_make_of_q(a):
    q = np.random.default_rng(3).normal(0, 5, (24, 3))
    means = []
    for states in FIVE_LINES.values():
        found = []
        for state in states:
            x, y, theta, d = state.split(",")
            bins = (int(x), int(y), ["0", "90", "-90"].index(theta), d == "T")
            found.append(q[np.ravel_multi_index(bins, (2, 2, 3, 2)), a])
        means.append(np.mean(found))
    shown = [
        float(numbers.rsplit("= ")[-1].replace("−", "-"))
        for _, numbers in five_lines(q, PAPERS_STATE, a)
    ]
    assert shown == pytest.approx([*means, np.mean(means)], abs=0.00501)
    assert shown[-1] == pytest.approx(bias_of(q, STATES.shape, PAPERS_STATE)[a], abs=0.00501)  # fmt: skip


def test_the_figure_of_the_papers_state_writes_the_five_lines(new_there):
    figure = plot_five_lines(new_there.q, PAPERS_STATE, 0)
    room, lines = figure.axes
    assert pose(room) == STATES.bins(PAPERS_STATE)
    written = [text.get_text() for text in lines.texts]
    for symbols, numbers in five_lines(new_there.q, PAPERS_STATE, 0):
        assert symbols in written and numbers in written
        assert symbols in figure.alt and numbers in figure.alt
    assert figure.finding == "The similar states warn of advance: bias −0.29"


def test_the_lesson_says_what_the_robot_knows_beside_the_papers_state(new_there):
    sets = STATES.siblings(PAPERS_STATE)
    similar = sorted({int(k) for states in sets.values() for k in states})
    assert new_there.visits[PAPERS_STATE].sum() == 0
    bumped = [k for k in similar if new_there.q[k, 0] < -0.5]
    assert len(bumped) == 3


def test_the_finding_says_whether_similar_states_recommend_or_warn():
    assert "recommend spin left: bias 1.20" in advice("spin left", 1.2)
    assert "warn of advance: bias −0.29" in advice("advance", -0.29)
    assert "say nothing of advance" in advice("advance", -0.0)


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
    assert finding == "Change one input alone, and you get 5 similar states"


def test_a_state_that_does_not_exist_is_named():
    with pytest.raises(ValueError, match="there is no state 24"):
        plot_similar_states(24)
