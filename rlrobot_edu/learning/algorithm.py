"""What a method is made of: an algorithm and a selection, and a planner; each is a kernel, and its name."""

from collections.abc import Callable
from typing import Any, NamedTuple

from rlrobot_edu.keywords import suggests_keywords

NO_ACTION = -1  # a' where there is none: after a terminal state, or in an imagined step


@suggests_keywords
class Algorithm(NamedTuple):
    """A learning algorithm. The toolkit's own are in methods.py; yours is one more.

    Parameters
    ----------
    name : str
        Its part of a method's name, such as ``SARSA``.
    update : function
        ``(m, s, a, r, s_next, a_next, terminated) -> TD error``, which changes ``m``, the agent's memory: ``m.q`` are
        its action values, ``m.e`` its traces, ``m.visits`` its counts, ``m.parameters`` its parameters. A plain
        function, written as numba understands it; it is compiled when an agent first learns.
    on_policy : bool
        Whether a' is selected before the update, which learns from it; otherwise after the update.
    has_traces : bool
        Whether it keeps eligibility traces.
    """

    name: str
    update: Callable[..., Any]
    on_policy: bool = True
    has_traces: bool = False


@suggests_keywords
class Selection(NamedTuple):
    """A rule by which actions are selected.

    Parameters
    ----------
    name : str
        Its part of a method's name, such as ``SR``.
    compute_probabilities : function
        ``(m, s)``, which writes the probability of each action in `s` to ``m.probabilities``; ``m`` is the agent's
        memory, see `Algorithm`.
    is_softmax, is_biased : bool
        Whether the temperature counts; whether it computes a bias.
    """

    name: str
    compute_probabilities: Callable[..., Any]
    is_softmax: bool = False
    is_biased: bool = False


@suggests_keywords
class Planner(NamedTuple):
    """A way to learn from imagined steps. The toolkit's own is dyna.py; yours is one more.

    Parameters
    ----------
    name : str
        Such as ``dyna``.
    plan : function
        ``(m, x, s, a, n, rng)``, called after each real step: it imagines ``n`` steps from ``x``, the agent's
        experience, and changes ``m``, its memory, see `Algorithm`. Written as an algorithm's update is.
    new_notes : function, optional
        ``(n_states, n_actions) -> named tuple of arrays of numbers``: what it keeps between two steps, as ``x.notes``.
    """

    name: str
    plan: Callable[..., Any]
    new_notes: Callable[[int, int], tuple[Any, ...]] | None = None
