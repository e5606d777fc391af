"""What the reader of lesson 08 moves: a path over a grid, and three kinds of trace against the ideal."""

from rlrobot_course.handles.handle import Handle
from rlrobot_course.trace_lab.lab import trace_lab


def traces_and_ideal() -> Handle:
    """The trace lab with three kinds of trace beside the ideal, after eight good steps and a bump."""
    return trace_lab(
        "eight good steps, a bump",
        paths=["eight good steps, a bump", "straight to A", "a loop", "there and back"],
        kind="accumulating",
        alpha=0.5,
        against_ideal=True,
    )


def with_and_without_q_old() -> Handle:
    """The trace lab with true online SARSA(λ) whose two terms with Q_old can be switched off."""
    return trace_lab(
        "A, B, A, B",
        kinds=["true online"],
        paths=["A, B, A, B", "eight good steps, a bump", "a loop"],
        kind="true online",
        alpha=0.5,
        against_ideal=True,
        has_switches=True,
    )
