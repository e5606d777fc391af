"""Numbers that remember of which rewards they are made, and the library's kernels, run on such numbers."""

from __future__ import annotations

from collections.abc import Callable
from functools import total_ordering
from types import FunctionType
from typing import Any

import numpy as np


@total_ordering
class Linear:
    """A number that is a sum over rewards: ``value`` = something that no reward made, plus ``weights`` · rewards.

    It adds to and subtracts from numbers of both kinds, and is multiplied by plain ones. It is compared by its value:
    so a maximum is held where it is now.

    value: the number; weights: array (n_rewards,), how much of each reward is in it
    """

    __slots__ = ("value", "weights")
    __array_priority__ = 1  # numpy leaves the arithmetic to it

    def __init__(self, value: float, weights: np.ndarray) -> None:
        self.value, self.weights = value, weights

    def __add__(self, other: Any) -> Linear:
        if isinstance(other, Linear):
            return Linear(self.value + other.value, self.weights + other.weights)
        return Linear(self.value + other, self.weights)

    def __mul__(self, factor: float) -> Linear:
        if isinstance(factor, Linear):
            raise TypeError(
                "a value times a value is no sum of rewards: this algorithm has no exact credit"
            )
        return Linear(self.value * factor, self.weights * factor)

    def __neg__(self) -> Linear:
        return Linear(-self.value, -self.weights)

    def __sub__(self, other: Any) -> Linear:
        return self.__add__(-other)

    def __rsub__(self, other: float) -> Linear:
        return -self + other

    __radd__, __rmul__ = __add__, __mul__

    def __lt__(self, other: Any) -> bool:
        return bool(self.value < getattr(other, "value", other))

    def __eq__(self, other: object) -> bool:
        return bool(self.value == getattr(other, "value", other))

    __hash__ = None  # type: ignore[assignment]


def plain(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The kernel as plain Python, and with it all kernels that it calls: these run on any numbers."""
    function = getattr(kernel, "py_func", kernel)
    if not isinstance(function, FunctionType):
        return kernel
    called = {
        name: function.__globals__.get(name) for name in function.__code__.co_names
    }
    others = {
        name: plain(thing)
        for name, thing in called.items()
        if thing is not None and hasattr(thing, "py_func")
    }
    return FunctionType(
        function.__code__,
        function.__globals__ | others,
        function.__name__,
        function.__defaults__,
        function.__closure__,
    )
