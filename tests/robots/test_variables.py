"""Bins, states and actions: what must hold for any variables, and which variables are refused."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rlrobot_edu as rl
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable

numbers = st.floats(-1e6, 1e6, allow_subnormal=False)
cut_lists = st.lists(numbers, min_size=1, max_size=4, unique=True).map(sorted)
kinds = st.one_of(
    st.builds(lambda cuts: {"cuts": cuts}, cut_lists),
    st.builds(lambda n: {"sectors": n}, st.integers(2, 9)),
    st.builds(
        lambda values: {"values": values},
        st.lists(numbers, min_size=1, max_size=4, unique=True),
    ),
)


@st.composite
def state_spaces(draw):
    return StateSpace(
        [
            InputVariable(f"sensor_{i}", **kind)
            for i, kind in enumerate(draw(st.lists(kinds, min_size=1, max_size=4)))
        ]
    )


@st.composite
def spaces_and_states(draw):
    space = draw(state_spaces())
    return space, draw(st.integers(0, space.n - 1))


@given(spaces_and_states())
def test_encoding_a_decoded_state_gives_it_back(case):
    space, s = case
    assert (
        space.encode({name: bin.reading for name, bin in space.decode(s).items()}) == s
    )
    assert space.number(space.bins(s)) == s


@given(kinds)
def test_every_bin_can_be_reached(kind):
    variable = InputVariable("sensor", **kind)
    assert [
        variable.bin(variable.decode(i).reading) for i in range(variable.n_bins)
    ] == list(range(variable.n_bins))


@given(cut_lists)
def test_a_reading_on_a_cut_belongs_to_the_bin_below_it(cuts):
    variable = InputVariable("laser", cuts=cuts)
    assert [variable.bin(c) for c in cuts] == list(range(len(cuts)))
    assert [variable.bin(math.nextafter(c, math.inf)) for c in cuts] == list(
        range(1, len(cuts) + 1)
    )


@given(st.integers(2, 16), st.floats(-math.pi, math.pi))
def test_the_sector_of_an_angle_is_the_one_whose_centre_is_nearest(sectors, angle):
    variable = InputVariable("theta", sectors=sectors)
    centre = variable.decode(variable.bin(angle)).reading
    assert abs(math.remainder(angle - centre, 2 * math.pi)) <= math.pi / sectors + 1e-9


@given(spaces_and_states())
def test_siblings_share_all_inputs_but_one(case):
    space, s = case
    bins = space.bins(s)
    for i, (variable, siblings) in enumerate(
        zip(space.inputs, space.siblings(s).values(), strict=True)
    ):
        expected = [bins[:i] + (k,) + bins[i + 1 :] for k in range(variable.n_bins)]
        assert [space.bins(int(sibling)) for sibling in siblings] == expected


@given(state_spaces())
def test_states_are_numbered_in_c_order(space):
    for s, bins in enumerate(np.ndindex(space.shape)):
        assert space.number(bins) == s == np.ravel_multi_index(bins, space.shape)


@given(
    st.lists(
        st.lists(numbers, min_size=1, max_size=3, unique=True), min_size=1, max_size=3
    )
)
def test_actions_are_numbered_in_c_order(values):
    space = ActionSpace([OutputVariable(f"motor_{i}", v) for i, v in enumerate(values)])
    for a, indices in enumerate(np.ndindex(space.shape)):
        assert space.decode(a) == {
            f"motor_{i}": values[i][k] for i, k in enumerate(indices)
        }


def test_the_examples_of_the_course_fall_into_the_bins_it_says():
    laser = InputVariable(
        "laser_front", cuts=[0.27, 0.53, 0.80], unit="m", low=0.0, high=5.0
    )
    assert [laser.bin(x) for x in (0.0, 0.27, 0.28, 0.53, 0.8, 0.81, 5.0)] == [
        0,
        0,
        1,
        1,
        2,
        3,
        3,
    ]
    theta = InputVariable("theta", sectors=8)
    assert [
        theta.bin(math.radians(d)) for d in (0, 22, 23, 90, 180, -180, -90, -22)
    ] == [0, 0, 1, 2, 4, 4, 6, 0]


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ({}, "exactly one"),
        ({"cuts": [1.0], "sectors": 4}, "exactly one"),
        ({"cuts": []}, "one or more"),
        ({"cuts": [math.nan]}, "finite"),
        ({"cuts": [2.0, 1.0]}, "increase"),
        ({"cuts": [1.0, 1.0]}, "increase"),
        ({"cuts": [7.0], "high": 5.0}, "range"),
        ({"values": []}, "one or more"),
        ({"values": [1, 1]}, "different"),
        ({"sectors": 1}, "at least 2"),
        ({"sectors": 2.5}, "integer"),
    ],
)
def test_an_input_whose_bins_are_not_well_defined_is_refused_by_name(kind, words):
    with pytest.raises(ValueError, match=rf"'laser'.*{words}"):
        InputVariable("laser", **kind)


@pytest.mark.parametrize("values", [[], [1, 1], [math.nan], [math.inf]])
def test_an_output_without_distinct_finite_values_is_refused_by_name(values):
    with pytest.raises(ValueError, match="'wheel'"):
        OutputVariable("wheel", values)


@pytest.mark.parametrize("reading", [math.nan, math.inf, -0.1, 5.1])
def test_a_reading_outside_the_range_of_its_sensor_is_refused_by_name(reading):
    space = StateSpace([InputVariable("laser", cuts=[1.0], low=0.0, high=5.0)])
    with pytest.raises(ValueError, match="'laser'"):
        space.encode({"laser": reading})


def test_names_that_appear_twice_and_numbers_that_do_not_exist_are_refused():
    twice = InputVariable("laser", cuts=[1.0])
    with pytest.raises(ValueError, match="'laser' appears twice"):
        StateSpace([twice, twice])
    with pytest.raises(ValueError, match="states are the integers 0 to 1"):
        StateSpace([twice]).decode(2)
    with pytest.raises(ValueError, match="actions are the integers 0 to 1"):
        ActionSpace([OutputVariable("wheel", [0, 1])]).decode(-1)


def test_actions_are_called_by_the_words_of_the_task_where_it_has_some():
    move = OutputVariable("move", [0, 1], words=["advance", "spin"])
    space = ActionSpace([OutputVariable("gripper", [-1, 1], "rad"), move])
    assert [space.label(a) for a in range(4)] == [
        "gripper -1, advance", "gripper -1, spin", "gripper 1, advance", "gripper 1, spin",
    ]  # fmt: skip
    assert space.decode(3) == {"gripper": 1, "move": 1}
    with pytest.raises(ValueError, match="one text for each of the 2 values"):
        OutputVariable("move", [0, 1], words=["advance"])


TEXTS = ["12", b"12", "", {"1": 2}, {1: 2}, ["1", "2"], bytearray(b"12")]


@pytest.mark.parametrize("text", TEXTS)
def test_a_text_is_no_list_wherever_a_list_is_expected(text):
    task = rl.load_task("wander_simple")
    for make in (
        lambda: rl.InputVariable("x", cuts=text),
        lambda: rl.InputVariable("x", values=text),
        lambda: rl.InputVariable("x", cuts=[1.5], low=text),
        lambda: rl.OutputVariable("x", text),
        lambda: replace(task, rewards=text),
        lambda: replace(task, inputs=text),
        lambda: replace(task, outputs=text),
    ):
        with pytest.raises(ValueError):
            make()
    if text != ["1", "2"]:
        with pytest.raises(
            ValueError, match="words must be one text for each of the 2 values"
        ):
            rl.OutputVariable("x", [0, 1], words=text)


def test_numbers_of_all_kinds_make_bins():
    variable = rl.InputVariable(
        "x", cuts=np.array([0.5, 1.5], np.float32), low=Fraction(0), high=Fraction(3)
    )
    assert variable.cuts == (0.5, 1.5) and [
        variable.bin(x) for x in (0, Fraction(1), np.float32(2))
    ] == [0, 1, 2]
    with pytest.raises(ValueError, match=r"reading 4 .*outside 0 to 3"):
        variable.bin(4)
    with pytest.raises(
        ValueError, match="cuts must lie inside the sensor's range 1 to 3"
    ):
        rl.InputVariable("x", cuts=[0.5], low=Fraction(1), high=3)


@given(st.integers(2, 40), st.integers(-200, 200), st.sampled_from([0.0, 0.25, 0.5]))
def test_each_sector_ends_with_its_highest_angle_as_bins_do(sectors, place, part):
    variable = rl.InputVariable("theta", sectors=sectors, unit="rad")
    angle = (place + part) * 2 * math.pi / sectors
    if (angle * sectors / (2 * math.pi)) != place + part:
        return  # a float beside the place that was meant
    assert (
        variable.bin(angle) == place % sectors
    )  # a half is the end of the sector before it
    low, high = (
        variable.decode(place % sectors).low,
        variable.decode(place % sectors).high,
    )
    assert high - low == pytest.approx(2 * math.pi / sectors)


@pytest.mark.parametrize("reading", ["x", None, [1.0], 1j, np.zeros(2)])
def test_a_reading_that_is_no_number_is_refused_with_the_inputs_name(reading):
    states = rl.load_task("wander_simple").states
    good = dict.fromkeys([v.name for v in states.inputs], 1.0)
    for name in good:
        with pytest.raises(ValueError, match=f"input '{name}'"):
            states.encode(good | {name: reading})
        with pytest.raises(ValueError, match="is not a number"):
            rl.InputVariable(name, cuts=[0.5]).bin(reading)
    with pytest.raises(ValueError, match="input 'laser_front_left'"):
        states.encode(good | {"laser_front_left": 10**400})


@pytest.mark.parametrize(
    "bins", [3, [9, 9], [1], [0, 0, 0], ["a", "b"], None, [0.5, 0], [10**400, 0]]
)
def test_what_is_no_bin_of_each_input_is_refused_with_the_inputs_names(bins):
    with pytest.raises(
        ValueError,
        match=r"one bin of each of laser_front_left \(0 to 1\), laser_front_right \(0 to 1\);",
    ):
        rl.load_task("wander_simple").states.number(bins)
