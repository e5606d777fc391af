"""Which states and actions fit into a picture of the tables. tables.js does the same for the page."""

from __future__ import annotations

from typing import NamedTuple

from rlrobot_edu.widgets.stepper.tape import Frame, Tape

MOST_STATES, MOST_ACTIONS = (
    48,
    9,
)  # with more of them, the most recent BLOCK states and MOST_ACTIONS actions are shown
BLOCK = 12  # rows in one block; the next block stands beside it


class Window(NamedTuple):
    """The part of the tables that is shown: states (None is an empty row), actions, and both in words."""

    states: list[int | None]
    actions: list[int]
    says: str

    @classmethod
    def of(cls, tape: Tape) -> Window:
        """All states and actions if they fit, otherwise those of the latest steps."""
        n_states, n_actions = tape.q.shape
        states: list[int | None] = list(range(n_states))
        actions, says = list(range(n_actions)), []
        if n_states <= MOST_STATES and n_actions <= MOST_ACTIONS:
            return cls(states, actions, f"all {n_states} states")
        recent_states, recent_actions = tape.recent(BLOCK)
        if n_states > MOST_STATES:
            states = recent_states + [None] * (BLOCK - len(recent_states))
            says.append(f"the {BLOCK} states visited last, of {n_states}")
        if n_actions > MOST_ACTIONS:
            # what the update took for the value of s′ is always shown
            step, best = (tape.frame.step, tape.frame.best) if tape.frame else (None, 0)
            follows = (
                [step.a, best if step.a_next is None else step.a_next, best]
                if step
                else []
            )
            latest = list(dict.fromkeys([*follows, *recent_actions, *actions]))
            actions = sorted(latest[:MOST_ACTIONS])
            says.append(f"{MOST_ACTIONS} of {n_actions} actions, the latest among them")
        return cls(states, actions, "; ".join(says) or f"all {n_states} states")


def traces_of(frame: Frame | None) -> dict[int, float]:
    """The traces of a step by their flat positions."""
    return (
        {}
        if frame is None
        else dict(zip(*(values.tolist() for values in frame.traces), strict=True))
    )
