"""State and action spaces: all combinations of the variables of a task.

A *structured state* is one bin for each input variable. The bins of all inputs together make the state's number,
in C order: the first input varies slowest (``numpy.ravel_multi_index``).
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from operator import index
from typing import Any

import numpy as np

from rlrobot_edu.checks import check_index
from rlrobot_edu.task.variables import Bin, InputVariable, OutputVariable, Variable


def _check_names(kind: str, variables: Sequence[Variable]) -> None:
    """Raises ValueError unless there are variables, each with a name of its own."""
    names = [v.name for v in variables]
    if not names:
        raise ValueError(
            f"a task needs at least one {kind} variable, else it has no states or no actions"
        )
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise ValueError(f"{kind} {twice[0]!r} appears twice; names must be different")


def _places(kind: str, number: int, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Place along each axis of `shape` of the state or action (`kind`) with this number."""
    number = check_index(kind, number, math.prod(shape))
    return tuple(int(i) for i in np.unravel_index(number, shape))


@dataclass(frozen=True)
class StateSpace:
    """All combinations of the inputs' bins, numbered in C order.

    shape: number of bins of each input; n: number of states
    """

    inputs: Sequence[InputVariable]
    shape: tuple[int, ...] = field(init=False)
    n: int = field(init=False)

    def __post_init__(self) -> None:
        _check_names("input", self.inputs)
        shape = tuple(v.n_bins for v in self.inputs)
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "inputs", tuple(self.inputs))
        object.__setattr__(self, "shape", shape)
        object.__setattr__(self, "n", math.prod(shape))

    def encode(self, readings: Mapping[str, float]) -> int:
        """State number of `readings` (sensor name to number). Raises ValueError that names a bad reading."""
        s = 0
        for v, n_bins in zip(self.inputs, self.shape, strict=True):
            try:
                reading = readings[v.name]
            except (KeyError, IndexError, TypeError):
                raise ValueError(
                    f"input {v.name!r} is not in the readings {readings!r:.200}"
                ) from None
            s = s * n_bins + v.bin(reading)
        return s

    def bins(self, s: int) -> tuple[int, ...]:
        """Bin of each input in state `s`. Raises ValueError if there is no such state."""
        return _places("state", s, self.shape)

    def number(self, bins: Sequence[int]) -> int:
        """State number of one bin an input. Raises ValueError if there is no such bin, or not one for each input."""
        try:
            whole = tuple(index(bin) for bin in bins)
            return int(np.ravel_multi_index(whole, self.shape))
        except (TypeError, ValueError, OverflowError):
            names = ", ".join(f"{v.name} (0 to {v.n_bins - 1})" for v in self.inputs)
            raise ValueError(
                f"a state is one bin of each of {names}; got {bins!r:.200}"
            ) from None

    def decode(self, s: int) -> dict[str, Bin]:
        """What state `s` means: the bin of each input, by name. Raises ValueError if there is no such state."""
        bins = zip(self.inputs, self.bins(s), strict=True)
        return {v.name: v.decode(i) for v, i in bins}

    def siblings(self, s: int) -> dict[str, np.ndarray]:
        """For each input, the states that share every *other* input with `s`, in bin order, `s` itself included.

        These are the sets SS(s, x_i) that bias the choice of an action (paper algorithm 2).
        """
        states: Any = np.arange(self.n).reshape(self.shape)
        bins = self.bins(s)
        siblings = {}
        for i, v in enumerate(self.inputs):
            row = (*bins[:i], slice(None), *bins[i + 1 :])
            siblings[v.name] = states[row]
        return siblings


@dataclass(frozen=True)
class ActionSpace:
    """All combinations of the outputs' values, numbered in C order: the first output varies slowest.

    shape: number of values of each output; n: number of actions
    """

    outputs: Sequence[OutputVariable]
    shape: tuple[int, ...] = field(init=False)
    n: int = field(init=False)

    def __post_init__(self) -> None:
        _check_names("output", self.outputs)
        shape = tuple(len(v.values) for v in self.outputs)
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "outputs", tuple(self.outputs))
        object.__setattr__(self, "shape", shape)
        object.__setattr__(self, "n", math.prod(shape))

    def decode(self, a: int) -> dict[str, float]:
        """The value [unit] of each output in action `a`, by name. Raises ValueError if there is no such action."""
        return {v.name: v.values[i] for v, i in self._values(a)}

    @property
    def labels(self) -> list[str]:
        """Each action in words, in their order."""
        return [self.label(a) for a in range(self.n)]

    def label(self, a: int) -> str:
        """Action `a` in words, for axes and tables: ``left_wheel 1, right_wheel -1``, or the task's own ``advance``."""
        parts = []
        for v, i in self._values(a):
            parts.append(v.words[i] if v.words else f"{v.name} {v.values[i]:g}")
        return ", ".join(parts)

    def _values(self, a: int) -> Iterable[tuple[OutputVariable, int]]:
        """Each output, and which of its values it has in action `a`."""
        places = _places("action", a, self.shape)
        return zip(self.outputs, places, strict=True)
