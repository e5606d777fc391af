"""Lesson 14's world and its figure say what the rows say."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_14 import exercises
from rlrobot_course.lesson_14.figures import plot_estimates
from rlrobot_course.lesson_14.worlds import RowWorld, rows_of
from rlrobot_course.lesson_14a.worlds import part

RECORDING = rl.read_recording("wander_simple")
MODEL = rl.SampleModel.from_recording(RECORDING)


def test_counting_rows_and_the_library_s_model_agree_in_every_pair():
    rows = rows_of(RECORDING)
    for s, a in np.ndindex(MODEL.n_states, MODEL.n_actions):
        outcomes, n = MODEL.outcomes(s, a), int(MODEL.pair_count[s, a])
        expected = {
            after: (
                sum(count for s_next, _, _, count in outcomes if s_next == after) / n,
                np.average(
                    [r for s_next, r, _, _ in outcomes if s_next == after],
                    weights=[count for s_next, _, _, count in outcomes if s_next == after],
                ),
            )
            for after in {outcome[0] for outcome in outcomes}
        }
        estimated = exercises.estimate(rows, s, a)
        assert estimated.keys() == expected.keys()
        assert all(estimated[after] == pytest.approx(expected[after]) for after in expected)


def test_even_draws_bring_back_every_row_once():
    rows = rows_of(part(RECORDING, slice(500)))
    s, a = rows[-1][:2]
    there = [(s_next, r) for s_row, a_row, r, s_next in rows if (s_row, a_row) == (s, a)]
    assert [exercises.sample(rows, s, a, (i + 0.5) / len(there)) for i in range(len(there))] == there


def test_a_world_of_rows_answers_with_rows_and_is_pessimistic_about_the_unknown():
    short = part(RECORDING, slice(300))
    world, seen = RowWorld(short, exercises.sample, seed=3), set(rows_of(short))
    s = world.reset()
    for a in np.random.default_rng(0).integers(4, size=200).tolist():
        tried = any(row[:2] == (s, a) for row in seen)
        s_next, r, *_ = world.step(a)
        assert (s, a, r, s_next) in seen if tried else (s_next, r) == (s, -10)
        s = s_next


def test_estimates_scatter_within_the_funnel_and_single_samples_are_all_or_nothing():
    picture = plot_estimates(np.arange(1000) % 2 == 0, sizes=[1, 400], estimates=200)
    one, many = (line.get_ydata() for line in picture.axes[0].lines if len(line.get_ydata()) == 200)
    assert set(one) == {0.0, 1.0}
    assert (abs(many - 0.5) <= 0.05).mean() > 0.9
