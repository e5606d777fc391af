"""How states and numbers are written, on the page, in pictures and in sentences."""

from __future__ import annotations

from collections.abc import Iterable

from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import Bin


def name_text(name: str) -> str:
    """An input's name as a formula has it: θ for ``theta``."""
    return "θ" if name == "theta" else name


def value_words(value: Bin) -> str:
    """A bin with its unit: ``−90°``, ``0–0.4 m``."""
    return str(value).replace(" deg", "°").replace("-", "−")


def value_text(value: Bin) -> str:
    """A bin in as few signs as possible: its value without the unit if it has a single one, else its limits."""
    if value.low != value.high:
        return str(value)
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


def two_decimals(x: float) -> str:
    """`x` with a true minus sign, which never stands before zero."""
    text = f"{x:.2f}"
    return "0.00" if float(text) == 0 else text.replace("-", "−")


def vector(x: Iterable[float]) -> str:
    """One number an action: ``(1.00, −0.50, 0.00)``."""
    return f"({', '.join(two_decimals(value) for value in x)})"
