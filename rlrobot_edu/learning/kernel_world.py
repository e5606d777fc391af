"""Worlds of kernels, in which a whole learning process can run compiled. They know no agent."""

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np

NEVER = 2**53  # steps after which an episode is cut off


class KernelWorld(NamedTuple):
    """What the compiled loop of learning is given of a world.

    begin: kernel (arrays, rng) -> state in which an episode begins
    outcome: kernel (arrays, s, a, rng) -> (s', r, terminated). A state below 0: the kernels cannot tell. Then all is
        as if they had not been asked, and the plain loop takes this step.
    arrays: named tuple of arrays and numbers, what both are given; its `episode_steps` are those after which an episode
        is cut off, `NEVER` for none
    state: those of its arrays that the kernels change
    """

    begin: Callable[..., Any]
    outcome: Callable[..., Any]
    arrays: Any
    state: tuple[np.ndarray, ...] = ()


@runtime_checkable
class KernelEnv(Protocol):
    """An environment that can offer its world as kernels, besides what Gymnasium asks of it.

    episode_step: steps of the episode so far
    np_random: its random numbers, from which its kernels draw as its `step` does
    """

    episode_step: int
    np_random: np.random.Generator

    def kernel_world(self, steps: int) -> KernelWorld | None:
        """Its world as it is now, for about so many steps; None without kernels, or if they are not worth it."""

    def arrive(self, s: int) -> Any:
        """Be in state `s`, to which the kernels have led."""
