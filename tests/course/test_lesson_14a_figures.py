"""Lesson 14a's measurements and figures say what the rows say."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_14.worlds import rows_of
from rlrobot_course.lesson_14a.figures import (
    plot_capture,
    plot_counts,
    plot_coverage,
    plot_unknown,
)
from rlrobot_course.lesson_14a.worlds import Gap, measure_gap, part, without_loops

RECORDING = rl.read_recording("wander_simple")
MODEL = rl.SampleModel.from_recording(RECORDING)


def test_a_part_of_a_recording_has_these_rows_and_no_loop_is_left_without_the_suspects():
    five = rl.read_recording("wander_1k")
    assert rows_of(part(five, slice(5))) == rows_of(five)[:5]
    before = rl.SampleModel.from_recording(five).diagnose()
    rest = without_loops(five)
    assert len(five) - len(rest) == sum(loop.samples for loop in before.loops)
    assert not set(rows_of(rest)) & {row for row in rows_of(five) if any(row[:2] in x.pairs for x in before.loops)}


def test_who_drives_learns_no_more_and_a_gap_is_a_mean_with_its_interval():
    agent = rl.Agent(MODEL, seed=0)
    rl.learn(agent, rl.make_env(MODEL, seed=0), steps=500, progress=False)
    q = agent.q.copy()
    rl.evaluate(agent, rl.make_env(MODEL, seed=1), 500).rewards.mean()
    assert np.allclose(agent.q, q, atol=1e-6)
    gap = Gap(np.array([3.0, 5.0, 7.0]), np.array([1.0, 2.0, 3.0]))
    assert gap.mean == 3.0
    assert gap.half == pytest.approx(4.303 * 1.0 / 3**0.5, rel=1e-3)  # t of 2 degrees of freedom, differences 2, 3, 4


def test_agents_are_measured_in_their_model_and_on_the_robot():
    gap = measure_gap([MODEL] * 2, "wander_simple", lesson=100, exam=10)
    assert gap.model.shape == gap.robot.shape == (2,)
    assert ((gap.robot >= -10) & (gap.robot <= 10)).all()


def test_the_table_of_counts_and_the_map_name_what_was_never_tried():
    counts = plot_counts(MODEL, "ABCD", "wxyz")
    told = {text.get_text() for text in counts.axes[0].texts}
    assert told == {f"{n:,}" if n else "never" for n in MODEL.pair_count.ravel().tolist()}
    maze = rl.SampleModel.from_recording(rl.read_recording("wander_1k"))
    picture = plot_coverage(maze, ["x0", "x1", "x2", "x3", "x4"])
    panels = [ax for ax in picture.axes if ax.get_title()]
    drawn = np.array([ax.images[0].get_array().filled(0) for ax in panels])
    tried = (maze.pair_count > 0).sum(axis=1)
    assert len(panels) == 4 and drawn.sum() == tried.sum()
    for s in np.flatnonzero(tried)[::17]:
        x0, x1, x2, x3, x4 = np.unravel_index(s, maze.shape)
        assert drawn[x0, 4 * x1 + x2, 4 * x4 + x3] == tried[s]


def test_the_bars_of_the_unknown_are_the_best_values_and_hatched_where_never_tried():
    models = {x: rl.SampleModel.from_recording(RECORDING, unseen=x) for x in ("uniform", "stay")}
    picture = plot_unknown(models, 0, ["stop", "left", "right", "forward"], "here")
    for ax, model in zip(picture.axes, models.values(), strict=True):
        assert np.allclose([bar.get_width() for bar in ax.patches], rl.value_iteration(model).q[0])
        assert [bool(bar.get_hatch()) for bar in ax.patches] == (model.pair_count[0] == 0).tolist()


def test_curves_and_gaps_are_those_that_were_measured():
    shares = np.array([[0.0, 1.0], [0.5, 1.0]])
    picture = plot_capture(shares, 10 * shares, recorded=5.7, block=500)
    assert np.allclose(picture.axes[0].lines[-1].get_ydata(), [25, 100])
