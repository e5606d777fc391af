"""What an algorithm is, a selection, and a planner: one file each, with its kernel, its name and what sets it apart."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.learning.parameters import Parameters

# The numbers of one step by their symbols: r, γ, α, (1 − α), δ, Q(s, a), e(s, a) and Q_old, as the update found them.
Numbers = Mapping[str, float]


class Algorithm(NamedTuple):
    """A learning algorithm.

    name: its part of a method's name, such as ``SARSA``
    update: the kernel (memory, s, a, r, s', a', terminated) -> TD error, which changes the memory
    next_value: function (Q(s'), a', probabilities in s') -> what the target takes for the value of s'
    equation: function (parameters) -> the update line by line, every number in braces by its symbol; the one with s′ is
        what `next_value` says
    on_policy: whether a' is selected before the update, which learns from it; otherwise after the update
    new_trace: of an algorithm with traces, function (parameters, numbers) -> e(s, a) once the pair was visited
    share: of an algorithm with traces, function (numbers) -> what any other pair learns for each unit of its trace
    """

    name: str
    update: Callable[..., Any]
    next_value: Callable[[np.ndarray, int, np.ndarray], float]
    equation: Callable[[Parameters], tuple[str, ...]]
    on_policy: bool = True
    new_trace: Callable[[Parameters, Numbers], float] | None = None
    share: Callable[[Numbers], float] | None = None


class Selection(NamedTuple):
    """A rule by which actions are selected.

    name: its part of a method's name, such as ``SR``
    weigh: the kernel (memory, s), which writes the probability of each action in `s` to the memory
    is_softmax: whether the temperature counts; is_biased: whether it computes a bias
    """

    name: str
    weigh: Callable[..., Any]
    is_softmax: bool = False
    is_biased: bool = False


class Planner(NamedTuple):
    """A way to learn from imagined steps.

    name: such as ``dyna``
    plan: the kernel (memory, experience, s, a, number of steps to imagine, random numbers), called after each real step
    """

    name: str
    plan: Callable[..., Any]
