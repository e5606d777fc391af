"""Transfer: which bin and which action is which, and that nothing but experience is carried over."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.learning.size import Size
from rlrobot_edu.tools.transfer.bins import overlap
from rlrobot_edu.tools.transfer.commands import match_actions, motion

LEFT, RIGHT = "left_wheel", "right_wheel"

CUTS = st.lists(st.integers(1, 49), min_size=1, max_size=8, unique=True).map(
    lambda tenths: rl.InputVariable(
        "laser_front", [n / 10 for n in sorted(tenths)], "m", low=0.0, high=5.0
    )
)
ANGLES = st.integers(2, 24).map(
    lambda n: rl.InputVariable(
        "theta", sectors=n, unit="rad", low=-math.pi, high=math.pi
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
    return number_of(task, {LEFT: left, RIGHT: right})


def number_of(task, values):
    return next(a for a in range(task.actions.n) if task.actions.decode(a) == values)


def sources(target, source):
    """What stands for an action of `target`, as weights by the wheels' speeds in `source`."""
    matches = match_actions(target, source)

    def stands_for(left, right):
        match = matches[action(target, left, right)]
        return {
            tuple(source.actions.decode(b).values()): round(w, 9)
            for b, w in match.sources
        }

    return stands_for


# --- bins ---------------------------------------------------------------------------------------------------------


@given(st.one_of(st.tuples(CUTS, CUTS), st.tuples(ANGLES, ANGLES)))
@settings(max_examples=40, deadline=None)
def test_the_parts_of_every_bin_are_those_of_a_fine_ruler_and_sum_to_one(both):
    target, source = both
    weights = overlap(target, source).toarray()
    assert (weights >= 0).all() and weights.sum(axis=1) == pytest.approx(
        np.ones(target.n_bins)
    )
    n = 3000
    counted = np.zeros_like(weights)
    for reading in target.low + (np.arange(n) + 0.5) * (target.high - target.low) / n:
        counted[target.bin(reading), source.bin(reading)] += 1
    counted /= counted.sum(axis=1, keepdims=True)
    assert weights == pytest.approx(counted, abs=0.04)


@given(st.one_of(CUTS, ANGLES))
@settings(max_examples=40, deadline=None)
def test_the_same_bins_are_one_another_exactly(variable):
    assert np.array_equal(
        overlap(variable, variable).toarray(), np.eye(variable.n_bins)
    )


def test_the_sector_behind_takes_from_both_sides_of_180_degrees():
    four, eight = (
        rl.InputVariable("theta", sectors=n, unit="rad", low=-math.pi, high=math.pi)
        for n in (4, 8)
    )
    assert overlap(four, eight).toarray()[2] == pytest.approx(
        [0, 0, 0, 0.25, 0.5, 0.25, 0, 0]
    )
    halves = rl.InputVariable("theta", [0.0], "rad", low=-math.pi, high=math.pi)
    assert overlap(four, halves).toarray() == pytest.approx(
        np.array([[0.5, 0.5], [0, 1], [0.5, 0.5], [1, 0]])
    )


def test_open_ends_values_and_what_the_source_cannot_read():
    def x(*cuts, **limits):
        return rl.InputVariable("x", cuts, "m", **limits)

    assert overlap(x(0.0, 2.0), x(0.0, 1.0)).toarray() == pytest.approx(
        np.array([[1, 0, 0], [0, 0.5, 0.5], [0, 0, 1]])
    )
    assert overlap(
        x(1.0, 3.0, high=9.0), x(1.0, low=0.0, high=2.0)
    ).toarray().tolist() == [[1, 0], [0, 1], [0, 0]]
    three, two = (
        rl.InputVariable("x", values=v, unit="m") for v in ([0, 90, -90], [90, 0])
    )
    assert overlap(three, two).toarray().tolist() == [[0, 1], [1, 0], [0, 0]]
    assert overlap(x(50.0), three).toarray() == pytest.approx(
        np.array([[0.5, 0, 0.5], [0, 1, 0]])
    )
    assert overlap(three, x(50.0)).toarray().tolist() == [[1, 0], [0, 1], [1, 0]]


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
    assert motion(pioneer, action(pioneer, 1, 1)) == pytest.approx(
        {"ahead": 0.0975, "turn": 0}
    )
    assert motion(pioneer, action(pioneer, -1, -1)) == pytest.approx(
        {"ahead": 0.195, "turn": 0}
    )
    turn = {"ahead": 0, "turn": 0.075 / 0.46}
    assert motion(giraff, action(giraff, -0.5, 0.5)) == pytest.approx(turn)
    assert sources(giraff, pioneer)(0.5, 0.5)[1, 1] == pytest.approx(0.0375 / 0.0975)
    too_fast = sources(pioneer, giraff)
    assert too_fast(-1, -1) == {} == too_fast(1, -1)
    assert motion(replace(pioneer, step_time=2.0), action(pioneer, 1, 1))[
        "ahead"
    ] == pytest.approx(0.195)


def test_a_joint_that_the_source_does_not_move_stands_still_for_it():
    one, four = rl.load_task("arm_1k"), rl.load_task("arm_4k")
    for match in match_actions(four, one):
        wanted = four.actions.decode(match.action)
        speeds = {name: wanted[name] for name in ("arm", "forearm")}
        expected = ((number_of(one, speeds), 1.0),) if wanted["biceps"] == 0 else ()
        assert match.sources == expected


# --- the whole ----------------------------------------------------------------------------------------------------


def test_to_the_same_task_it_is_the_same_q_to_the_bit_and_nothing_else_is_carried_over():
    source = rl.Agent(
        "wander_simple", "SL+EG", seed=1, alpha=0.3, epsilon=0.2, accumulating=True
    )
    rl.learn(source, rl.make_env("wander_simple", seed=1), steps=200, progress=False)
    before = source.q.copy()
    agent = rl.transfer(source, "wander_simple", seed=2)
    assert np.array_equal(agent.q, before) and agent.report.scale == 1
    assert np.array_equal(agent.report.known, source.visits > 0)
    assert not agent.visits.any() and not agent.e.any() and agent.pending is None
    assert (agent.method, agent.parameters) == (source.method, source.parameters)
    other = rl.transfer(source, "wander_simple", method="TOSL+SR", temperature=3)
    assert (
        other.method.name,
        other.parameters.temperature,
        other.parameters.alpha,
    ) == ("TOSL+SR", 3, 0.3)
    rl.learn(agent, rl.make_env("wander_simple", seed=2), steps=20, progress=False)
    assert np.array_equal(source.q, before) and agent.visits.sum() == 20
    assert np.array_equal(
        rl.transfer(other, "wander_simple").q, before
    )  # what is known without visits goes on


@given(st.lists(st.integers(1, 20), max_size=4), st.integers(0, 99))
@settings(max_examples=20, deadline=None)
def test_finer_bins_copy_exactly_and_back_again_nothing_has_changed(more, seed):
    coarse = task_with(lasers(front=[0.27, 0.8], left=[0.5]))
    fine = task_with(
        lasers(
            left=[0.5, 1.0],
            front=sorted({0.27, 0.8, *(n / 5 + 0.01 for n in more)}),
            rear=[0.3],
        )
    )
    source = experienced(coarse, seed)
    agent = rl.transfer(source, fine)
    for s in range(fine.states.n):
        readings = {name: bin.reading for name, bin in fine.states.decode(s).items()}
        assert np.array_equal(agent.q[s], source.q[coarse.states.encode(readings)])
    assert rl.transfer(agent, coarse).q == pytest.approx(source.q)


def test_merged_bins_and_lost_inputs_are_means_over_what_was_visited():
    source = experienced(
        task_with(lasers(front=[1.0, 2.0], left=[0.5, 0.7], right=[0.5])), seed=3
    )
    agent = rl.transfer(source, task_with(lasers(left=[0.5, 0.7], front=[1.5])))
    known = source.visits.reshape(3, 3, 2, 9) > 0
    q = source.q.reshape(3, 3, 2, 9)
    for left in range(3):
        for front, parts in enumerate(
            ([1 / 1.5, 0.5 / 1.5, 0], [0, 0.5 / 3.5, 3 / 3.5])
        ):
            weights = known[:, left] * np.reshape(parts, (3, 1, 1))
            expected = (weights * q[:, left]).sum(axis=(0, 1)) / weights.sum(
                axis=(0, 1)
            )
            assert agent.q[2 * left + front] == pytest.approx(expected)
    assert [match.how for match in agent.report.inputs] == [
        "matched",
        "matched",
        "averaged",
    ]


def test_what_no_visited_pair_stands_for_begins_with_zero():
    source = rl.Agent("wander_1k")
    forward = action(source.task, 1, 1)
    source.q[1023, forward], source.visits[1023, forward] = 42, 1
    agent = rl.transfer(source, "wander_4k")
    where = [
        agent.task.states.encode(
            dict.fromkeys(source.task.states.decode(0), 5.0) | {"laser_rear": x}
        )
        for x in (0.1, 5)
    ]
    assert (agent.q[where, action(agent.task, 1, 1)] == 42).all()
    assert (agent.q[where, action(agent.task, 0, 0)] == 0).all()
    assert (
        (agent.q != 0).sum()
        == agent.report.known.sum()
        == round(agent.report.share * agent.q.size)
    )
    assert set(np.unique(agent.q)) == {0, 42}


@pytest.mark.parametrize("gamma", [0.9, 0.5])
def test_q_grows_with_the_largest_value_it_can_take_so_softmax_chooses_alike(gamma):
    source = experienced("wander_simple", share=1)
    target = replace(rl.load_task("wander_simple"), rewards=[-30, -6, -0.06, 30])
    agent = rl.transfer(source, target, gamma=gamma)
    assert agent.report.scale == pytest.approx(3 * (1 - 0.9) / (1 - gamma))
    assert agent.q * agent.parameters.q_scale == pytest.approx(
        source.q * source.parameters.q_scale
    )


@pytest.mark.parametrize("world", ["environment", "model", "task given"])
def test_an_agent_knows_its_task_from_whatever_has_one(world, wander_model, tmp_path):
    given = {}
    if world == "environment":
        source = rl.Agent(rl.make_env("wander_1k"))
    elif world == "model":
        source = rl.Agent(wander_model)
        rl.learn(source, rl.make_env(wander_model, seed=0), steps=2000, progress=False)
    else:
        rl.Agent(wander_model).save(tmp_path / "agent.npz")
        source, given = (
            rl.Agent.load(tmp_path / "agent.npz"),
            {"source_task": "wander_1k"},
        )
        with pytest.raises(
            ValueError,
            match=r"does not know which task it has learned; say it with source_task=",
        ):
            rl.transfer(source, "wander_1k")
    target = rl.make_env("giraff_wander_1k")
    agent = rl.transfer(source, target, **given)
    assert (
        agent.report.target == "giraff_wander_1k"
        and agent.task is target.unwrapped.task
    )
    assert (agent.report.share > 0) == (world == "model")
    rl.learn(agent, target, steps=3, progress=False)


def test_the_report_tells_of_every_input_and_action_in_text_and_in_html():
    report = rl.transfer(experienced("arm_1k"), "arm_4k").report
    text, page = str(report), report._repr_html_()
    assert text.startswith("From arm_1k to arm_4k: ") and "multiplied by 1;" in text
    assert (
        "the source lacks it: copied to all 4 bins" in text
        and "the same 8 bins" in text
    )
    assert (
        text.count("nothing like it: unknown") == 18
        and page.count("<tr>") == 1 + 5 + 27
    )
    wander = str(rl.transfer(experienced("wander_1k"), "wander_simple").report)
    assert "mean over its 4 bins" in wander and "2 bins from 4 by overlap" in wander
    assert "mean of (-1, 0), (0, -1), (0, 0)" in wander


@pytest.mark.parametrize(
    "source, target, given, said",
    [
        (
            "wander_1k",
            "arm_1k",
            {},
            r"no input of arm_1k .* is one of wander_1k .*nothing can be carried over",
        ),
        (
            "wander_1k",
            "wander_1k",
            {"source_task": "wander_4k"},
            r"but wander_4k has .*give the task that it was made",
        ),
        ("wander_1k", "wander_9k", {}, "did you mean"),
        (
            "wander_1k",
            Size((4,), 2),
            {},
            "a Size does not say what its bins and actions mean; give .* the task itself",
        ),
        ("wander_1k", "wander_1k", {"temperature": 0}, "temperature must be"),
    ],
)
def test_what_cannot_be_carried_over_is_refused_in_one_sentence(
    source, target, given, said
):
    with pytest.raises(ValueError, match=said):
        rl.transfer(rl.Agent(source), target, **given)


def test_other_units_other_robots_and_what_is_no_agent_are_refused():
    with pytest.raises(
        ValueError,
        match=r"input 'x': the source has it in 'm', the target in 'cm'; give both the same",
    ):
        overlap(rl.InputVariable("x", [1], "cm"), rl.InputVariable("x", [1], "m"))
    with pytest.raises(
        ValueError, match=r"carries over what an rl.Agent has learned, not 'wander_1k'"
    ):
        rl.transfer("wander_1k", "wander_1k")
    with pytest.raises(
        ValueError,
        match=r"worked_example tells its robot advance, spin, .*choose tasks whose robots",
    ):
        match_actions(rl.load_task("wander_1k"), rl.load_task("worked_example"))
    slow = (
        rl.OutputVariable(LEFT, [0.01], "rad/s"),
        rl.OutputVariable(RIGHT, [0.01], "rad/s"),
    )
    crawl = task_with(lasers(front=[1.0]), "crawl", outputs=slow, command=None)
    sprint = replace(
        crawl, outputs=[replace(wheel, values=[2.0]) for wheel in slow], name="sprint"
    )
    with pytest.raises(
        ValueError,
        match="no action of crawl is like any of sprint, so there is nothing to carry over",
    ):
        rl.transfer(rl.Agent(crawl), sprint)
