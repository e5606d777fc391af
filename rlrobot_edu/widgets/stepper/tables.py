"""Which states and actions fit into a picture of the tables. tables.js does the same for the page."""

from __future__ import annotations

from typing import NamedTuple

from rlrobot_edu.widgets.stepper.tape import Frame, Tape

MOST_STATES = 48  # of a larger table, the BLOCK states visited last are shown
MOST_ACTIONS = 9  # of a larger table, so many are shown: the latest first, then others
BLOCK = 12  # states that stand below each other; on the page the next block stands beside it


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
        actions = list(range(n_actions))
        says = []
        recent_states, recent_actions = tape.recent(BLOCK)
        if n_states > MOST_STATES:
            states = recent_states + [None] * (BLOCK - len(recent_states))
            says.append(f"the {BLOCK} states visited last, of {n_states}")
        if n_actions > MOST_ACTIONS:
            latest = [*_of_update(tape.frame), *recent_actions, *actions]
            each_once = list(dict.fromkeys(latest))
            actions = sorted(each_once[:MOST_ACTIONS])
            says.append(f"{MOST_ACTIONS} of {n_actions} actions, the latest among them")
        return cls(states, actions, "; ".join(says) or f"all {n_states} states")


def _of_update(frame: Frame | None) -> list[int]:
    """The actions that an update concerns: a, and those from which it may take the value of s′."""
    if frame is None:
        return []
    follows = frame.best if frame.step.a_next is None else frame.step.a_next
    return [frame.step.a, follows, frame.best]


def traces_of(frame: Frame | None) -> dict[int, float]:
    """The traces of a step by their flat positions."""
    if frame is None:
        return {}
    where, values = frame.traces
    return dict(zip(where.tolist(), values.tolist(), strict=True))
