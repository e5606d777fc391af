"""What the reader of lesson 07 moves: a path over a grid, and the traces that it leaves."""

from rlrobot_course.handles.handle import Handle
from rlrobot_course.trace_lab.lab import trace_lab


def traces_on_a_path() -> Handle:
    """The trace lab with replacing and accumulating traces."""
    return trace_lab(
        "straight to A",
        kinds=["replacing", "accumulating"],
        paths=["straight to A", "a loop", "there and back"],
        kind="replacing",
        alpha=0.1,
    )
