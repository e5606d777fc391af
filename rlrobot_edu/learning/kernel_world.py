"""Worlds of kernels, in which a whole learning process can run compiled. They do not depend on the agent."""

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np

NEVER = 2**53  # steps after which an episode is cut off


class KernelWorld(NamedTuple):
    """A world as the compiled loop of learning needs it.

    begin: kernel (arrays, rng) -> state in which an episode begins
    outcome: kernel (arrays, s, a, rng) -> (s', r, terminated)
    arrays: named tuple of arrays and numbers, the first argument of both kernels. Its `episode_steps` is the number of
        steps after which an episode is cut off, `NEVER` for none
    state: those of the arrays that the kernels write. The loop copies them, to put them back if a kernel fails

    A kernel that cannot compute its state returns one below 0. It must have changed nothing then: no array, no random
    number. The plain loop in Python takes the step instead.
    """

    begin: Callable[..., Any]
    outcome: Callable[..., Any]
    arrays: Any
    state: tuple[np.ndarray, ...] = ()


@runtime_checkable
class KernelEnv(Protocol):
    """An environment that can offer its world as kernels, besides what Gymnasium asks of an environment.

    episode_step: steps of the episode so far; the loop sets it, too
    np_random: the generator from which both `step` and the kernels draw, in the same order
    """

    episode_step: int
    np_random: np.random.Generator

    def kernel_world(self, steps: int) -> KernelWorld | None:
        """The world as it is now. None if there are no kernels, or if for so few steps they are not worth it."""

    def arrive(self, s: int) -> Any:
        """Take over state `s`, which the kernels have reached. The loop calls this now and then, and at the end."""
