"""Lesson 14's worlds, measurements and figures say what the rows say."""

import numpy as np
import pytest

import rlrobot_edu as rl
from rlrobot_course.lesson_14 import exercises
from rlrobot_course.lesson_14.figures import (
    gaps_finding,
    plot_capture,
    plot_counts,
    plot_unknown,
)
from rlrobot_course.lesson_14.worlds import (
    Gap,
    RowWorld,
    measure_gap,
    part,
    rows_of,
    without_loops,
)

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
                    weights=[
                        count for s_next, _, _, count in outcomes if s_next == after
                    ],
                ),
            )
            for after in {outcome[0] for outcome in outcomes}
        }
        estimated = exercises.estimate(rows, s, a)
        assert estimated.keys() == expected.keys()
        assert all(
            estimated[after] == pytest.approx(expected[after]) for after in expected
        )


def test_even_draws_bring_back_every_row_once():
    rows = rows_of(part(RECORDING, slice(500)))
    s, a = rows[-1][:2]
    there = [
        (s_next, r) for s_row, a_row, r, s_next in rows if (s_row, a_row) == (s, a)
    ]
    assert [
        exercises.sample(rows, s, a, (i + 0.5) / len(there)) for i in range(len(there))
    ] == there


def test_a_world_of_rows_answers_with_rows_and_is_pessimistic_about_the_unknown():
    short = part(RECORDING, slice(300))
    world, seen = RowWorld(short, exercises.sample, seed=3), set(rows_of(short))
    s = world.reset()
    for a in np.random.default_rng(0).integers(4, size=200).tolist():
        tried = any(row[:2] == (s, a) for row in seen)
        s_next, r, *_ = world.step(a)
        assert (s, a, r, s_next) in seen if tried else (s_next, r) == (s, -10)
        s = s_next


def test_a_part_of_a_recording_has_these_rows_and_no_loop_is_left_without_the_suspects():
    five = rl.read_recording("wander_1k")
    assert rows_of(part(five, slice(5))) == rows_of(five)[:5]
    before = rl.SampleModel.from_recording(five).diagnose()
    rest = without_loops(five)
    assert len(five) - len(rest) == sum(loop.samples for loop in before.loops)
    assert not set(rows_of(rest)) & {
        row for row in rows_of(five) if any(row[:2] in x.pairs for x in before.loops)
    }


def test_who_drives_learns_no_more_and_a_gap_is_a_mean_with_its_interval():
    agent = rl.Agent(MODEL, seed=0)
    rl.learn(agent, rl.make_env(MODEL, seed=0), steps=500, progress=False)
    q = agent.q.copy()
    rl.evaluate(agent, rl.make_env(MODEL, seed=1), 500).rewards.mean()
    assert np.allclose(agent.q, q, atol=1e-6)
    gap = Gap(np.array([3.0, 5.0, 7.0]), np.array([1.0, 2.0, 3.0]))
    assert gap.mean == 3.0
    assert gap.half == pytest.approx(
        4.303 * 1.0 / 3**0.5, rel=1e-3
    )  # t of 2 degrees of freedom, differences 2, 3, 4


def test_agents_are_measured_in_their_model_and_on_the_robot():
    gap = measure_gap([MODEL] * 2, "wander_simple", lesson=100, exam=10)
    assert gap.model.shape == gap.robot.shape == (2,)
    assert ((gap.robot >= -10) & (gap.robot <= 10)).all()


def test_the_table_of_counts_names_what_was_never_tried():
    counts = plot_counts(MODEL, "ABCD", "wxyz")
    told = {text.get_text() for text in counts.axes[0].texts}
    assert told == {
        f"{n:,}" if n else "never" for n in MODEL.pair_count.ravel().tolist()
    }


def test_the_bars_of_the_unknown_are_the_best_values_and_hatched_where_never_tried():
    models = {
        x: rl.SampleModel.from_recording(RECORDING, unseen=x)
        for x in ("uniform", "stay")
    }
    picture = plot_unknown(models, 0, ["stop", "left", "right", "forward"], "here")
    for ax, model in zip(picture.axes, models.values(), strict=True):
        assert np.allclose(
            [bar.get_width() for bar in ax.patches], rl.value_iteration(model).q[0]
        )
        assert [bool(bar.get_hatch()) for bar in ax.patches] == (
            model.pair_count[0] == 0
        ).tolist()


def test_curves_and_gaps_are_those_that_were_measured():
    shares = np.array([[0.0, 1.0], [0.5, 1.0]])
    picture = plot_capture(shares, 10 * shares, recorded=5.7, block=500)
    assert np.allclose(picture.axes[0].lines[-1].get_ydata(), [25, 100])
    assert picture.finding.endswith("10.0 a step; the recorded robot earned 5.7")
    near = Gap(np.array([3.0, 5.0]), np.array([2.0, 4.5]))
    far = Gap(np.array([9.0, 9.0]), np.array([2.0, 3.0]))
    said = gaps_finding({"a": far, "b": near})
    assert said == "The model promises 0.8 a step too much with “b”, 6.5 with “a”"


def test_titles_of_counts_and_the_unknown_are_counted():
    never = np.count_nonzero(MODEL.pair_count == 0)
    assert plot_counts(MODEL, "ABCD", "wxyz").finding.startswith(f"{never} of 16 pairs")
    best = int(rl.value_iteration(MODEL).q[0].argmax())
    assert f"“{'wxyz'[best]}”" in plot_unknown({"m": MODEL}, 0, "wxyz", "here").finding
