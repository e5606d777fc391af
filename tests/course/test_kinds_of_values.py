"""One rule for values: what counts as right in the notebook counts as right when it is graded, of whatever kind."""

import array
import collections
import decimal
import enum
import fractions
import types

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_judging import marked

from rlrobot_course.lesson_05 import check as check_07
from rlrobot_course.lesson_05.exercises import siblings
from rlrobot_grading.answers.limits import Elsewhere
from rlrobot_grading.answers.values import as_data, same
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.serialization import read, written


class Whole(int):
    """A number of the learner's own, which prints in its own way."""

    def __repr__(self):
        return "one"

    __str__ = __int__ = __float__ = __index__ = None


class Real(float):
    __repr__ = __float__ = None


class Colour(enum.IntEnum):
    RED = 3


class Measured:
    """A number as some libraries have them."""

    def __init__(self, value):
        self.value = value

    def __float__(self):
        return float(self.value)


class Frame:
    """An array as some libraries have them."""

    def __init__(self, values):
        self.values = values

    def __array__(self, dtype=None, copy=None):
        return np.array(self.values, dtype=dtype)

    def __len__(self):
        return len(self.values)


Point = collections.namedtuple("Point", "x y z")


def objects(values):
    made = np.empty(len(values), dtype=object)
    made[:] = values
    return made


# what a learner may write for a number, and for several; each of these is right where the plain ones are
NUMBERS = {
    "int": int, "own int": Whole, "float": float, "own float": Real, "numpy int": np.int64, "small int": np.int8,
    "unsigned": np.uint16, "float64": np.float64, "float32": np.float32, "float16": np.float16,
    "long double": np.longdouble, "complex": complex, "numpy complex": np.complex64, "fraction": fractions.Fraction,
    "decimal": decimal.Decimal, "0-d": np.array, "0-d object": lambda x: np.array(fractions.Fraction(x), dtype=object),
    "enum": lambda x: Colour.RED if x == 3 else int(x), "measured": Measured, "masked": lambda x: np.ma.array(x),
}  # fmt: skip
SEVERAL = {
    "list": list, "tuple": tuple, "array": np.array, "deque": collections.deque, "user list": collections.UserList,
    "array.array": lambda x: array.array("d", x), "memoryview": lambda x: memoryview(array.array("d", x)),
    "masked": np.ma.array, "objects": objects, "frame": Frame, "named": lambda x: Point(*x),
    "own list": type("Own", (list,), {}), "float32": np.float32, "long doubles": lambda x: np.array(x, np.longdouble),
    "fractions": lambda x: list(map(fractions.Fraction, x)), "decimals": lambda x: objects([*map(decimal.Decimal, x)]),
    "complex": lambda x: np.array(x, complex), "reversed": lambda x: np.array(x[::-1])[::-1],
    "memmap": lambda x: np.array(x).view(np.memmap), "read only": lambda x: np.broadcast_to(np.array(x), (3,)),
}  # fmt: skip
NEVER = {
    "masked": lambda: np.ma.array([1.0, 2, 3], mask=[0, 1, 0]), "generator": lambda: (i for i in [1, 2, 3]),
    "text": lambda: "3", "texts": lambda: ["1", "2", "3"], "text objects": lambda: objects(["1", "2", "3"]),
    "bytes": lambda: b"\1\2\3", "dates": lambda: np.array([1, 2, 3], "datetime64[D]"), "set": lambda: {1, 2, 3},
    "dict": lambda: {0: 1, 1: 2, 2: 3}, "date": lambda: np.datetime64(3, "D"), "function": lambda: len,
}  # fmt: skip


def verdicts(value, right):
    """At home, and when graded: whether a value is right, and all that is said of it."""
    home, away = Question(right, "give it"), Question(right, "give it")
    return home(value), away(read(written(value)))


@pytest.mark.parametrize("kind", NUMBERS)
@pytest.mark.parametrize("wanted", [3, 3.0, np.float64(3), np.array(3)])
def test_a_number_of_any_kind_is_that_number_at_home_and_when_graded(kind, wanted):
    for number in (3, 4):
        for verdict in verdicts(NUMBERS[kind](number), wanted):
            assert bool(verdict) == (number == 3), verdict


@pytest.mark.parametrize("kind", SEVERAL)
@pytest.mark.parametrize(
    "wanted", [[1, 2, 3], (1.0, 2.0, 3.0), np.array([1.0, 2, 3]), range(1, 4)]
)
def test_several_numbers_of_any_kind_are_those_numbers_at_home_and_when_graded(
    kind, wanted
):
    for numbers in ([1, 2, 3], [1, 2, 4]):
        for verdict in verdicts(SEVERAL[kind](numbers), wanted):
            assert bool(verdict) == (numbers[2] == 3), verdict


@pytest.mark.parametrize("kind", NEVER)
def test_what_is_no_number_is_wrong_in_both(kind):
    for wanted in (3, [1, 2, 3], np.array([1.0, 2, 3])):
        assert not any(verdicts(NEVER[kind](), wanted))


plain = (
    st.integers(-5, 5)
    | st.floats(-4, 4, width=16)
    | st.booleans()
    | st.sampled_from(["a", "B", "", "1.5"])
)
number = st.builds(
    lambda kind, x: NUMBERS[kind](x),
    st.sampled_from(sorted(NUMBERS)),
    st.integers(0, 4),
)
several = st.builds(
    lambda kind, x: SEVERAL[kind](x),
    st.sampled_from(sorted(SEVERAL)),
    st.lists(st.integers(-3, 3), min_size=3, max_size=3),
)
never = st.sampled_from(sorted(NEVER)).map(lambda kind: NEVER[kind]())
kinds = st.recursive(
    plain | number | several | never | st.none() | st.just(...),
    lambda inner: st.lists(inner, max_size=3) | st.tuples(inner, inner) | st.dictionaries(plain, inner, max_size=2)
    | st.lists(inner, max_size=3).map(objects) | st.dictionaries(plain, inner, max_size=2).map(types.MappingProxyType)
    | st.lists(inner, max_size=2).map(collections.deque) | st.sets(plain, max_size=3)
    | st.frozensets(plain, max_size=3),
    max_leaves=6,
)  # fmt: skip


@settings(max_examples=400, deadline=None)
@given(kinds, kinds)
def test_home_and_grade_find_the_same_of_any_two_values(value, other):
    if not (
        "unkept" in written(value) and "unkept" in written(other)
    ):  # at home, a function is the same as itself
        data = as_data(other)
        assert same(value, data) == same(read(written(value)), data)
    assert read(written(read(written(value)))) is ... or written(
        read(written(value))
    ) == written(value)
    if "unkept" not in written(value):
        assert same(value, read(written(value))), "and what travels is what was sent"


@settings(max_examples=60, deadline=None)
@given(kinds)
def test_home_and_grade_say_the_same_of_what_a_function_returns(value):
    exercise = Exercise(three, [{"n": 3}, {"n": 1}], "return it", returns="number")
    at_home = exercise.judge(lambda n: value)
    graded = exercise.judge(Elsewhere(lambda n: (read(written(value)), None, "")))
    assert at_home.status == graded.status
    if not callable(
        value
    ):  # of which only the notebook knows what it is; as it alone knows an answer's code
        assert (at_home.text, at_home.called, at_home.rows) == (
            graded.text,
            graded.called,
            graded.rows,
        )


def three(n):
    return [1, 2, n]


def test_the_siblings_of_lesson_05_may_be_a_range_or_fractions():
    for kind in (
        tuple,
        np.array,
        lambda x: np.array(x, dtype=object),
        lambda x: [fractions.Fraction(int(i)) for i in x],
    ):
        answer = wrapped(kind)
        assert check_07.siblings.judge(answer) and marked(
            "lesson_05", "siblings", answer
        )


def wrapped(kind):
    return lambda *arguments: kind(siblings(*arguments))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[1]",
        '{"pickle": 1}',
        '{"array": [1], "shape": [5], "kind": "float64"}',
        '{"array": [], "shape": [0], "kind": "U999999999"}',
        "[" * 9999,
    ],
)
def test_a_text_that_is_no_value_is_refused(text):
    with pytest.raises(ValueError):
        read(text)
