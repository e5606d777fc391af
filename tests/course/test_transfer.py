"""Transfer: which bin and which action is which, and that nothing but experience is carried over."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_course.lesson_21.actions import action_weights, motion
from rlrobot_course.lesson_21.bins import overlap
from rlrobot_course.lesson_21.transfer import carried_over, transfer

LEFT, RIGHT = "left_wheel", "right_wheel"

CUTS = st.lists(st.integers(1, 49), min_size=1, max_size=8, unique=True).map(
    lambda tenths: rl.InputVariable(
        "laser_front", [n / 10 for n in sorted(tenths)], "m", low=0.0, high=5.0
    )
)


def task_with(inputs, name="mine", **changed):
    """wander_1k, or what is `changed` of it, with other inputs."""
    return replace(rl.load_task("wander_1k"), inputs=inputs, name=name, **changed)


def lasers(**cuts):
    return [rl.InputVariable(f"laser_{name}", its, "m") for name, its in cuts.items()]


def experienced(task, seed=0, share=0.6, **settings):
    """An agent with random values in a `share` of its pairs, visited now and then."""
    agent, rng = rl.Agent(task, **settings), np.random.default_rng(seed)
    agent.visits[:] = rng.integers(1, 9, agent.q.shape) * (
        rng.random(agent.q.shape) < share
    )
    agent.q[:] = np.where(agent.visits > 0, rng.normal(20, 10, agent.q.shape), 0.0)
    return agent


def action(task, left, right):
    speeds = {LEFT: left, RIGHT: right}
    return next(a for a in range(task.actions.n) if task.actions.decode(a) == speeds)


def sources(target, source):
    """What stands for an action of `target`, as weights by the wheels' speeds in `source`."""
    weights = action_weights(target, source)

    def stands_for(left, right):
        row = weights[action(target, left, right)]
        return {
            tuple(source.actions.decode(b).values()): round(row[b], 9)
            for b in np.flatnonzero(row).tolist()
        }

    return stands_for


# --- bins ---------------------------------------------------------------------------------------------------------


@given(CUTS, CUTS)
@settings(max_examples=40, deadline=None)
def test_the_parts_of_every_bin_are_those_of_a_fine_ruler_and_sum_to_one(
    target, source
):
    weights = overlap(target, source)
    assert weights.sum(axis=1) == pytest.approx(np.ones(target.n_bins))
    n = 3000
    counted = np.zeros_like(weights)
    for reading in target.low + (np.arange(n) + 0.5) * (target.high - target.low) / n:
        counted[target.bin(reading), source.bin(reading)] += 1
    counted /= counted.sum(axis=1, keepdims=True)
    assert weights == pytest.approx(counted, abs=0.04)


@given(CUTS)
@settings(max_examples=40, deadline=None)
def test_the_same_bins_are_one_another_exactly(variable):
    assert np.array_equal(overlap(variable, variable), np.eye(variable.n_bins))


# --- actions ------------------------------------------------------------------------------------------------------


def test_every_action_of_wander_1k_is_found_in_wander_4k_and_the_new_ones_between_them():
    one, four = rl.load_task("wander_1k"), rl.load_task("wander_4k")
    stands_for = sources(four, one)
    for left, right in ((left, right) for left in (-1, 0, 1) for right in (-1, 0, 1)):
        assert stands_for(left, right) == {(left, right): 1.0}
    stand = {
        (-1, 0): 1 / 6,
        (0, -1): 1 / 6,
        (0, 0): 1 / 6,
    }  # half of it, for all three are no motion
    half = {pair: round(weight, 9) for pair, weight in stand.items()}
    assert stands_for(-0.5, -0.5) == {
        (1, 1): 1.0
    }  # both backward: forward at double speed
    assert stands_for(-0.5, 0) == {pair: pytest.approx(1 / 3) for pair in stand}
    assert stands_for(0.5, 0.5) == half | {(1, 1): 0.5}
    assert stands_for(0.5, -0.5) == half | {(1, -1): 0.5}
    assert stands_for(0, 0.5) == half | {(0, 1): 0.5}
    assert stands_for(1, 0.5) == {(1, 0): 0.5, (1, 1): 0.5}
    assert stands_for(-0.5, 1) == {(-1, 1): 0.5, (0, 1): 0.5}


def test_wheels_are_compared_by_how_the_robot_moves():
    pioneer, giraff = rl.load_task("wander_1k"), rl.load_task("giraff_wander_1k")
    assert motion(pioneer, action(pioneer, 1, 1)) == pytest.approx((0.0975, 0))
    assert motion(pioneer, action(pioneer, -1, -1)) == pytest.approx((0.195, 0))
    turn = (0, 0.075 / 0.46)
    assert motion(giraff, action(giraff, -0.5, 0.5)) == pytest.approx(turn)
    assert sources(giraff, pioneer)(0.5, 0.5)[1, 1] == pytest.approx(0.0375 / 0.0975)
    too_fast = sources(pioneer, giraff)
    assert too_fast(-1, -1) == {} == too_fast(1, -1)
    slow = replace(pioneer, step_time=2.0)
    assert motion(slow, action(pioneer, 1, 1))[0] == pytest.approx(0.195)


# --- the whole ----------------------------------------------------------------------------------------------------


def test_to_the_same_task_it_is_the_same_q_to_the_bit_and_nothing_else_is_carried_over():
    source = rl.Agent(
        "wander_simple", "SL+EG", seed=1, alpha=0.3, epsilon=0.2, accumulating=True
    )
    rl.learn(source, rl.make_env("wander_simple", seed=1), steps=200, progress=False)
    before = source.q.copy()
    agent = transfer(source, "wander_simple", seed=2)
    assert np.array_equal(agent.q, before)
    known = carried_over(source, agent.task)[1]
    assert np.array_equal(known, source.visits > 0)
    assert not agent.visits.any() and not agent.e.any() and agent.pending is None
    assert (agent.method, agent.parameters) == (source.method, source.parameters)
    again = transfer(agent, "wander_simple")
    assert np.array_equal(again.q, before)  # what is known without visits goes on
    rl.learn(agent, rl.make_env("wander_simple", seed=2), steps=20, progress=False)
    assert np.array_equal(source.q, before) and agent.visits.sum() == 20


@given(st.lists(st.integers(1, 20), max_size=4), st.integers(0, 99))
@settings(max_examples=20, deadline=None)
def test_finer_bins_and_a_further_input_copy_exactly(more, seed):
    coarse = task_with(lasers(front=[0.27, 0.8], left=[0.5]))
    fine = task_with(
        lasers(
            left=[0.5, 1.0],
            front=sorted({0.27, 0.8, *(n / 5 + 0.01 for n in more)}),
            rear=[0.3],
        )
    )
    source = experienced(coarse, seed)
    agent = transfer(source, fine)
    for s in range(fine.states.n):
        readings = {name: bin.reading for name, bin in fine.states.decode(s).items()}
        assert agent.q[s] == pytest.approx(source.q[coarse.states.encode(readings)])


def test_merged_bins_are_means_over_what_was_visited():
    source = experienced(task_with(lasers(front=[1.0, 2.0], left=[0.5, 0.7])), seed=3)
    agent = transfer(source, task_with(lasers(left=[0.5, 0.7], front=[1.5])))
    known = source.visits.reshape(3, 3, 9) > 0
    q = source.q.reshape(3, 3, 9)
    for left in range(3):
        for front, parts in enumerate(
            ([1 / 1.5, 0.5 / 1.5, 0], [0, 0.5 / 3.5, 3 / 3.5])
        ):
            weights = known[:, left] * np.reshape(parts, (3, 1))
            total = weights.sum(axis=0)
            expected = np.zeros(9)
            np.divide(
                (weights * q[:, left]).sum(axis=0), total, expected, where=total > 0
            )
            assert agent.q[2 * left + front] == pytest.approx(expected)


def test_what_no_visited_pair_stands_for_begins_with_zero():
    source = rl.Agent("wander_1k")
    forward = action(source.task, 1, 1)
    source.q[1023, forward], source.visits[1023, forward] = 42, 1
    agent = transfer(source, "wander_4k")
    where = [
        agent.task.states.encode(
            dict.fromkeys(source.task.states.decode(0), 5.0) | {"laser_rear": x}
        )
        for x in (0.1, 5)
    ]
    assert agent.q[where, action(agent.task, 1, 1)] == pytest.approx([42, 42])
    assert (agent.q[where, action(agent.task, 0, 0)] == 0).all()
    assert np.array_equal(agent.q != 0, carried_over(source, agent.task)[1])
    assert agent.q[agent.q != 0] == pytest.approx(42)


def test_q_grows_with_the_largest_value_it_can_take_so_softmax_chooses_alike():
    source = experienced("wander_simple", share=1)
    target = replace(rl.load_task("wander_simple"), rewards=[-30, -6, -0.06, 30])
    agent = transfer(source, target)
    assert agent.q == pytest.approx(3 * source.q)
    assert agent.q * agent.parameters.q_scale == pytest.approx(
        source.q * source.parameters.q_scale
    )


@pytest.mark.parametrize(
    ("source", "target"),
    [("wander_1k", "arm_1k"), ("arm_1k", "arm_4k"), ("wander_4k", "wander_1k")],
)
def test_robots_without_wheels_and_lost_inputs_are_refused(source, target):
    with pytest.raises(ValueError, match="choose two tasks of robots on wheels"):
        transfer(rl.Agent(source), target)
