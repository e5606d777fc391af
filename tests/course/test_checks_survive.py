"""Whatever a learner hands to a check, there is a verdict: short, soon, and never "right" by accident."""

from __future__ import annotations

import asyncio
import collections
import cProfile
import datetime
import decimal
import fractions
import importlib
import itertools
import sys
import time
import uuid

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from test_checks import exercises

from rlrobot_grading.answers.values import MOST_SIGNS, same, show
from rlrobot_grading.exercises.exercise import Exercise

SECONDS, SIGNS = 5.0, 4000  # a check computes and says no more

NAMES = "repr str eq ne len float int index bool array iter getitem hash deepcopy reduce_ex format getattribute lt call"
METHODS = [f"__{name}__" for name in NAMES.split()]


@pytest.fixture(autouse=True)
def nobody_hears_of_what_dies_at_the_bottom_of_a_recursion(monkeypatch):
    """Answers recurse until Python stops them. Whoever tells of an object that could not be taken down has no room."""
    monkeypatch.setattr(sys, "unraisablehook", lambda _: None)


class Trouble(BaseException):
    """No Exception, as SystemExit is none."""

    def __str__(self):
        raise ValueError("this error cannot be shown")


def evil(names=METHODS, base=object, error=RuntimeError):
    """An object whose methods raise."""

    def raises(*_, **__):
        raise error

    made = type(
        "Evil", (base,), {"__hash__": object.__hash__} | dict.fromkeys(names, raises)
    )
    return base.__new__(made)


def nested(depth):
    value = []
    for _ in range(depth):
        value = [value]
    return value


def recursive(kind):
    value = kind()
    value.update(a=value) if kind is dict else value.append(value)
    return value


def holding_itself():
    value = np.empty(2, dtype=object)
    value[:] = value, 1
    return value


class Endless:
    """Says that it is short, and never ends."""

    def __len__(self):
        return 3

    def __iter__(self):
        return itertools.count()


class EndlessList(list):
    def __iter__(self):
        return itertools.count()


class Sized:
    def __len__(self):
        return sys.maxsize

    def __getitem__(self, i):
        return 0


class Frame(Sized):
    """Like a table of pandas: an array of texts that is told in many lines."""

    shape = (2, 2)

    def __array__(self, dtype=None, copy=None):
        return np.array([["a", "b"], ["c", "d"]], dtype=dtype)

    def __len__(self):
        return 2

    def __repr__(self):
        return "   x  y\n" * 10_000

    def __eq__(self, other):
        return self  # neither true nor false

    def __bool__(self):
        raise ValueError("the truth value of a table is ambiguous")


class Shy(np.ndarray):
    """An array that shows nothing."""

    def __getitem__(self, i):
        raise IndexError(i)


POINT = collections.namedtuple("Point", "x y")

# each a function, for some can be used only once, and some are large
VALUES = {
    "0-d array": lambda: np.array(5.5),
    "0-d object": lambda: np.array({"a": 1}, dtype=object),
    "generator": lambda: (i for i in range(3)),
    "endless generator": itertools.count,
    "huge int": lambda: 10**5000,
    "huge negative int in a list": lambda: [-(10**5000), 1],
    "true": lambda: True,
    "nan": lambda: float("nan"),
    "infinity": lambda: -np.inf,
    "complex": lambda: 5.05 + 3j,
    "complex array": lambda: np.array([1j, 2]),
    "numpy complex": lambda: np.complex128(0.933 + 1j),
    "text": lambda: "x" * 1_000_000,
    "control characters": lambda: "\x1b[31m\x00\r\n\ud800\u202e",
    "bytes": lambda: b"\xff\x00" * 1000,
    "bytearray": lambda: bytearray(10**5),
    "memoryview": lambda: memoryview(b"abc"),
    "dict": lambda: {i: i for i in range(100_000)},
    "set": lambda: set(range(100_000)),
    "mixed set": lambda: {1, "a", None, (2, 3)},
    "class": lambda: dict,
    "function": lambda: print,
    "module": lambda: sys,
    "ellipsis in a list": lambda: [...],
    "not implemented": lambda: NotImplemented,
    "long list": lambda: list(range(100_000)),
    "million in lists": lambda: [[0.0] * 1000] * 1000,
    "long tuple": lambda: tuple(range(5000)),
    "long range": lambda: range(10**18),
    "range too long for len": lambda: range(10**30),
    "large array": lambda: np.zeros((3000, 300)),
    "array larger than the memory": lambda: np.broadcast_to(0.0, (10**6, 10**6)),
    "empty array": lambda: np.zeros((0, 10**9)),
    "many dimensions": lambda: np.zeros((1,) * 60),
    "object array": lambda: np.array([None, "a", [1], 2.0], dtype=object),
    "recursive array": holding_itself,
    "structured array": lambda: np.zeros(3, dtype=[("a", float), ("b", "U5")]),
    "dates": lambda: np.array(["2020-01-01"], dtype="datetime64[D]"),
    "no date": lambda: np.datetime64("NaT"),
    "texts": lambda: np.array(["a", "b"]),
    "masked": lambda: np.ma.array([7.0, 7.0, 7.0], mask=True),  # not masked_all: what lies in fresh memory may be right
    "matrix that shows nothing": lambda: np.ones(3).view(Shy),
    "ragged": lambda: [[1, 2], [3]],
    "recursive list": lambda: recursive(list),
    "recursive dict": lambda: recursive(dict),
    "deep": lambda: nested(20_000),
    "less deep": lambda: nested(900),
    "decimal": lambda: decimal.Decimal("1e999999"),
    "signalling nan": lambda: decimal.Decimal("sNaN"),
    "fraction": lambda: fractions.Fraction(10**5000, 3),
    "date": lambda: datetime.date(2020, 1, 1),
    "uuid": lambda: uuid.UUID(int=0),
    "namedtuple": lambda: POINT(10**5000, None),
    "deque": lambda: collections.deque(range(50_000)),
    "exception": lambda: Trouble(),
    "sized": Sized,
    "endless": Endless,
    "endless list": lambda: EndlessList([1, 2, 3]),
    "like a table": Frame,
    "evil": evil,
    "evil with SystemExit": lambda: evil(error=SystemExit),
    "evil with a trouble of its own": lambda: evil(error=Trouble),
    "evil list": lambda: evil(base=list),
    "evil number": lambda: evil(set(METHODS) - {"__float__"}, base=float),
    "evil dict in a list": lambda: [evil(base=dict), 1],
    "evil text": lambda: evil(base=str),
    "evil keys": lambda: {evil(["__eq__", "__repr__"]): 1},
    **{f"evil {name}": lambda name=name: evil([name]) for name in METHODS},
}  # fmt: skip


def recursion(*arguments):
    return recursion(*arguments)


def raiser(error):
    def answer(*_):
        raise error

    return answer


def spoils(*arguments):
    """Changes what it is given, as far as that can be done, and puts strange things into it."""
    for thing in arguments:
        if isinstance(thing, list):
            thing.append(thing)
            thing.extend([evil(), (i for i in "ab"), 10**5000])
        elif isinstance(thing, dict):
            thing["itself"] = thing
        elif isinstance(thing, np.ndarray) and thing.size:
            thing.flat[0] = np.nan
        elif hasattr(thing, "__dict__") and not callable(thing):
            thing.__dict__.update(s=(i for i in "ab"), episode=evil(), t=10**5000)


async def unawaited(*_):
    return 1


def yields(*_):
    yield 1


# answers that are functions and do more than return a value
FUNCTIONS = {
    "sys.exit": lambda *_: sys.exit(),
    "sys.exit with a text": lambda *_: sys.exit("x" * 10**6),
    "SystemExit itself": raiser(SystemExit),
    "GeneratorExit": raiser(GeneratorExit),
    "CancelledError": raiser(asyncio.CancelledError()),
    "StopIteration": raiser(StopIteration),
    "MemoryError": raiser(MemoryError()),
    "an error without a name": raiser(type("", (Exception,), {})()),
    "an error of many lines": raiser(ValueError("line\n" * 100_000)),
    "an error that cannot be shown": raiser(Trouble()),
    "no arguments": lambda: 0,
    "keywords only": lambda *, q, s: 0,
    "too many": lambda a, b, c, d, e, f, g, h, i, j, k, l, m, n: 0,  # noqa: E741
    "recursion": recursion,
    "spoils": spoils,
    "yields": yields,
    "class that takes nothing": type("Empty", (), {}),
    "evil function": evil(set(METHODS) - {"__getattribute__"}),
    "evil when looked at": type(
        "Evil",
        (),
        {"__call__": lambda *_: 0, "__code__": property(raiser(RuntimeError()))},
    )(),
}


def judge(check, answer):
    """The verdict, which is checked for what must hold of each."""
    begin = time.process_time()
    verdict = check(answer)
    text = repr(verdict)
    assert time.process_time() - begin < SECONDS
    assert len(text) < SIGNS, f"{len(text)} signs"
    assert text.isascii() or text.encode()
    assert all(sign.isprintable() or sign == "\n" for sign in text)
    assert text.startswith(("✗ ", "… "))
    assert verdict.status in ("wrong", "waiting") and not verdict
    return verdict


# one for each kind of check and of what a right answer is: numbers, arrays, a list, a tuple, a dict, texts, a world
ONE_OF_EACH_KIND = [
    ("lesson_01", "bin_of"), ("lesson_01", "reward"), ("lesson_03", "q_by_hand"), ("lesson_03", "learn"),
    ("lesson_05", "siblings"), ("lesson_05", "best_adviser"), ("lesson_11", "bins"), ("lesson_11", "motion"),
    ("lesson_13", "arm_reward"), ("lesson_14", "estimate"), ("lesson_16", "size"), ("lesson_17", "dyna"),
    ("assignment_1", "greedy"), ("assignment_5", "verdict"),
]  # fmt: skip


@pytest.mark.long
@pytest.mark.filterwarnings(
    "ignore"
)  # numpy's, in what the learner's functions compute
@pytest.mark.parametrize(("lesson", "name"), ONE_OF_EACH_KIND)
def test_a_check_survives_every_answer(lesson, name):
    check = exercises(lesson)[name]
    for what, make in VALUES.items():
        judge(check, make())
        if isinstance(check, Exercise):
            value = make()
            assert judge(check, lambda *_, value=value: value).status == "wrong", what
    for answer in FUNCTIONS.values():
        judge(check, answer)


@pytest.mark.parametrize(("lesson", "name"), ONE_OF_EACH_KIND)
def test_a_check_judges_as_before_after_hostile_answers(lesson, name):
    check = exercises(lesson)[name]
    judge(check, spoils)
    assert check(
        getattr(importlib.import_module(f"rlrobot_course.{lesson}.exercises"), name)
    )


def test_an_exit_is_told_and_an_interrupt_is_not_swallowed():
    check = exercises("lesson_03")["target"]
    verdict = judge(check, lambda *_: sys.exit("bye"))
    assert "SystemExit: bye" in verdict.text and "return" in verdict.hint
    with pytest.raises(KeyboardInterrupt):
        check(raiser(KeyboardInterrupt()))
    with pytest.raises(KeyboardInterrupt):
        check(lambda *_: evil(error=KeyboardInterrupt))


def endless(*_):
    while True:
        pass


def counts(x, cuts):
    return sum(x > cut for cut in cuts)


def noted_after_the_check():
    return None


@pytest.mark.parametrize("answer", [counts, endless])
def test_a_profiler_written_in_c_goes_on_after_a_check(answer, monkeypatch):
    monkeypatch.setattr("rlrobot_grading.answers.limits.SECONDS", 0.1)
    profiler = cProfile.Profile()
    profiler.enable()
    try:
        verdict = exercises("lesson_01")["bin_of"](answer)
        noted_after_the_check()
    finally:
        profiler.disable()
    assert bool(verdict) == (answer is counts), verdict
    noted = [entry.code for entry in profiler.getstats()]
    assert noted_after_the_check.__code__ in noted


@pytest.mark.parametrize("answer", [counts, endless])
def test_functions_that_profile_and_trace_are_set_again_after_a_check(
    answer, monkeypatch
):
    monkeypatch.setattr("rlrobot_grading.answers.limits.SECONDS", 0.1)

    def look(frame, event, argument):
        return None

    traced, profiled = sys.gettrace(), sys.getprofile()
    sys.setprofile(look)
    sys.settrace(look)
    try:
        exercises("lesson_01")["bin_of"](answer)
        after = sys.gettrace(), sys.getprofile()
    finally:
        sys.settrace(traced)
        sys.setprofile(profiled)
    assert after == (look, look)


def test_a_debugger_that_is_attached_is_not_asked_to_step_aside(monkeypatch):
    asked = []
    monkeypatch.setattr(sys, "settrace", lambda function: asked.append(function))
    assert exercises("lesson_01")["bin_of"](counts)
    assert not asked


def test_an_exit_in_a_notebook_does_not_end_its_kernel(monkeypatch):
    ipython = pytest.importorskip("IPython")

    class Shell:
        ended = False

        def ask_exit(self):
            self.ended = True

    shell = Shell()
    leave = ipython.core.autocall.ExitAutocall(shell)  # what exit is in a notebook
    monkeypatch.setattr(ipython, "get_ipython", lambda: shell)
    check = exercises("lesson_03")["target"]
    assert "SystemExit" in judge(check, lambda *_: leave()).text and not shell.ended
    assert check(importlib.import_module("rlrobot_course.lesson_03.exercises").target)
    leave()
    assert shell.ended, "everywhere else it does what it does"


TAME = [
    what for what in VALUES if not what.startswith("evil")
]  # hypothesis itself looks at what it draws
ANYTHING = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.complex_numbers() | st.text() | st.binary()
    | st.decimals() | st.fractions() | st.dates() | st.sampled_from(TAME).map(lambda what: VALUES[what]()),
    lambda inner: st.lists(inner, max_size=4) | st.tuples(inner, inner) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)  # fmt: skip


@settings(
    max_examples=80,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    report_multiple_bugs=False,
)
@given(a=ANYTHING, b=ANYTHING)
def test_any_two_values_can_be_compared_and_any_value_shown(a, b):
    assert same(a, b) in (True, False)
    text = show(a)
    assert 0 < len(text) <= MOST_SIGNS and text.isprintable()
