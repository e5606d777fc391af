"""A template: one kernel, to be called from Python. numba keeps it on disk, with all that the kernel calls."""

from rlrobot_edu.jit.dispatcher import compiled


def kernel() -> None:
    """The part: does nothing here."""


@compiled
def call(*arguments):
    """What the kernel answers to these arguments."""
    return kernel(*arguments)
