"""How states and numbers are written, on the page, in pictures and in sentences."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import Bin
from rlrobot_edu.widgets.bias_explorer.bias import BiasNumbers
from rlrobot_edu.widgets.stepper.numerals import number, short_exponent

SMALLEST = 1e-9  # less is what rounding leaves of a sum
SAME = 1e-6  # probabilities that differ by less count as the same


def name_text(name: str) -> str:
    """An input's name as a formula has it: θ for ``theta``."""
    return "θ" if name == "theta" else name


def value_words(value: Bin) -> str:
    """A bin with its unit: ``−90°``, ``0–0.4 m``."""
    return str(value).replace(" deg", "°").replace("-", "−")


def value_text(value: Bin) -> str:
    """A bin in as few signs as possible: its value without the unit if it has a single one, else its limits."""
    if value.low != value.high:
        return str(value).replace("-", "−")
    return f"{value.reading:g}".replace("-", "−")


def state_text(task: Task, s: int) -> str:
    """State `s` as the paper writes it: ``(1,1,90,0)``."""
    values = task.states.decode(s).values()
    return f"({','.join(value_text(value) for value in values)})"


def state_words(task: Task, s: int) -> str:
    """State `s` in words: ``X 1, Y 1, θ 90°, d 0``."""
    words = []
    for name, value in task.states.decode(s).items():
        words.append(f"{name_text(name)} {value_words(value)}")
    return ", ".join(words)


def amount(x: float) -> str:
    """A value: two decimals, or two digits that count where these would hide it: −0.30, −0.0075; only 0 is 0.00."""
    size = abs(x)
    if size < SMALLEST:
        return "0.00"
    if size < 0.1:
        return short_exponent(f"{x:.2g}")
    return short_exponent(f"{x:.2f}") if size < 100 else number(x)


def percents(p: float, other: float, decimals: int) -> tuple[str, str]:
    """Two probabilities in percent, with as many decimals as it takes to tell them apart."""
    one, two = f"{100 * p:.{decimals}f} %", f"{100 * other:.{decimals}f} %"
    if one == two and abs(p - other) > SAME:
        return percents(p, other, decimals + 1)
    return one, two


def vector(x: Iterable[float]) -> str:
    """One number an action: ``(1.00, −0.50, 0.00)``."""
    return f"({', '.join(amount(value) for value in x)})"


def finding(actions: Sequence[str], q: np.ndarray, numbers: BiasNumbers) -> str:
    """The action whose probability the bias changes most, and whether that is the similar states' doing.

    actions: the name of each; q: array (n_states, n_actions)
    """
    a = numbers.most_changed
    before, now = percents(numbers.sr[a], numbers.qbiassr[a], 0)
    name = f"“{actions[a]}”"
    if before == now:
        return f"Similar states change nothing here: {name} keeps {now}"
    rises = numbers.qbiassr[a] > numbers.sr[a]
    change = f"{'rises' if rises else 'falls'} from {before} to {now}"
    in_sets = np.mean([1 / len(states) for states in numbers.sets.values()])
    own = q[numbers.s, a] * in_sets  # the state itself is in every set
    theirs = numbers.bias[a] - own
    if abs(theirs) < abs(own) or rises != (theirs > 0):
        return f"With its bias, the chance of {name} {change}"
    speak = "for" if rises else "against"
    return f"Similar states speak {speak} {name}: its chance {change}"
