"""Values as Python text, good ones and others, and calls made of them."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import strategies as st

from fuzz.strategies import Draw

Text = st.SearchStrategy[str]  # of Python expressions

# What somebody may hand over by mistake instead of a number, a name, a list or a thing of ours; names as in `things`.
HOSTILE = [
    "0", "1", "-1", "2", "10**9", "2**63", "10**400", "-10**30", "0.5", "1e308", "5e-324", "nan", "inf", "-inf",
    "-0.0", "True", "None", "''", "'1'", "'text'", "[]", "[1]", "[nan]", "(1, 2)", "{}", "{'x': 1}", "...", "range(3)",
    "np.float64('nan')", "np.int64(3)", "np.float32(0.5)", "np.array(3)", "np.array([1, 2])", "np.array([[0.5]])",
    "np.bool_(True)", "np.zeros(0)", "Fraction(1, 3)", "lambda *_: 0", "int", "task", "model", "Odd()", "'$nope$'",
    "'$\\\\nope$'", "'_mine'", "'<b>'", "'a\\nb'", "'\\0'", "'\\ud800'", "'x' * 1000",
]  # fmt: skip
# What nobody hands over by mistake, but a learner's function may return.
ABSURD = [
    "1j", "b'x'", "set()", "Decimal('0.5')", "object()", "Odd(ValueError)", "raising(KeyError('x'))", "recursive()",
    "np.array(['x'])", "np.array([None])", "'é' * 300",
]  # fmt: skip


def value(*good: str, other: Sequence[str] = HOSTILE) -> Text:
    """Three times in four one of the good ones."""
    numbers = st.integers(-3, 30).map(repr) | st.floats().map(repr)
    usual = st.sampled_from(good) if good else numbers
    return st.integers(0, 15).flatmap(
        lambda i: usual if i < 12 else st.sampled_from(other) if i < 15 else numbers
    )


@st.composite
def call(draw: Draw, function: str, *positional: Text | str, **named: Text) -> str:
    """A call: all positional arguments, a third of the named ones; rarely one too few or too many."""
    arguments = [each if isinstance(each, str) else draw(each) for each in positional]
    arguments += [
        f"{name}={draw(each)}"
        for name, each in named.items()
        if draw(st.integers(0, 2)) == 0
    ]
    match draw(st.integers(0, 39)):
        case 0 if arguments:
            arguments.pop()
        case 1:
            arguments.append("nonsense=1")
        case 2 if positional:
            arguments.insert(0, draw(value()))
    return f"{function}({', '.join(arguments)})"


def lines(*strategies: Text | str) -> Text:
    """A program of these lines, one after the other; an empty one is left out."""
    parts = [st.just(each) if isinstance(each, str) else each for each in strategies]
    return st.tuples(*parts).map(
        lambda texts: "\n".join(text for text in texts if text) + "\n"
    )


def some(*strategies: Text | str, most: int = 4) -> Text:
    """Up to `most` lines of these kinds."""
    kinds = [st.just(each) if isinstance(each, str) else each for each in strategies]
    return st.lists(st.one_of(*kinds), max_size=most).map("\n".join)
