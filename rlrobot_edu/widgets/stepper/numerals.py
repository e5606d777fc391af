"""Numbers for tables and equations: short, and never rounded to nothing."""

from __future__ import annotations

MINUS = "−"


def number(x: float) -> str:
    """`x` with three digits or so: 12.35, 0.905, −0.002."""
    size = abs(x)
    if size == 0 or 1 <= size < 100:
        text = f"{x:.2f}"
    elif size >= 100:
        text = f"{x:.1f}" if size < 1e4 else f"{x:.1e}"
    else:
        text = f"{x:.3f}" if size >= 0.01 else f"{x:.2g}"
    return short_exponent(text)


def told_apart(was: float, now: float) -> tuple[str, str]:
    """Two numbers as `number` writes them, or with more decimals where both would look the same."""
    if was == now or number(was) != number(now):
        return number(was), number(now)
    decimals = 4
    while decimals < 12 and f"{was:.{decimals}f}" == f"{now:.{decimals}f}":
        decimals += 1
    return short_exponent(f"{was:.{decimals}f}"), short_exponent(f"{now:.{decimals}f}")


def before_it(was: float, now: float) -> str:
    """What stands before the new value of a change: the old one, or by how much where both look the same."""
    if short(was) != short(now):
        return f"{short(was)} →"
    return f"{'+' if now > was else ''}{short(now - was)}"


def short(x: float) -> str:
    """`x` in six signs at most, for the cells of a table: 12.3, 0.90, −0.021, 4e−5; a plain 0 is exactly 0."""
    size = abs(x)
    if size == 0:
        text = "0"
    elif size < 0.0005 or size >= 1e5:
        text = f"{x:.0e}"
    elif size < 0.1:
        text = f"{x:.3f}"
    elif size < 10:
        text = f"{x:.2f}"
    elif size < 100:
        text = f"{x:.1f}"
    else:
        text = f"{x:.0f}"
    return short_exponent(text)


def given(x: float) -> str:
    """A number that somebody set, such as α or a reward: 0.1, 10, −0.02."""
    return short_exponent(f"{x:g}")


def short_exponent(text: str) -> str:
    """A number as Python writes it, with a true minus and no more of an exponent than it needs: 4e−5."""
    return text.replace("e-0", "e-").replace("e+0", "e").replace("-", MINUS)
