"""Checks, made once in Python, of what goes to compiled code, which looks up no bounds: numbers and files."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from rlrobot_edu.learning.memory import NOW, Memory, as_array
from rlrobot_edu.task.messages import LARGEST_NUMBER, all_exist, check_between, existing, expect

LARGEST_KEPT = 1e300  # of what a file may bring: beyond, sums soon are infinite
LARGEST_TRACE = 1e6  # beyond the number of visits, for own algorithms: a huge trace makes Q infinite


def check_pair(memory: Memory, s: int, a: int = 0) -> tuple[int, int]:
    """(s, a) as ints. Raises ValueError for a state or an action that there is not."""
    n_states, n_actions = memory.q.shape
    return existing("state", s, n_states), existing("action", a, n_actions)


def check_transition(memory: Memory, s: int, a: int, r: Any, s_next: int) -> tuple[int, int, float, int]:
    """The transition in Python's own numbers, which kernels know. Raises ValueError for one that cannot be."""
    s, a = check_pair(memory, s, a)
    s_next = existing("state", s_next, len(memory.q))
    if isinstance(r, np.generic | np.ndarray) and r.ndim == 0:
        r = r.item()
    check_between("a reward", r, -LARGEST_NUMBER, LARGEST_NUMBER)
    return s, a, float(r), s_next


def changing(memory: Memory) -> dict[str, np.ndarray]:
    """What learning changes in a memory, by name; arrays that share their numbers, but ``now``."""
    arrays = memory._asdict() | {"now": as_array(memory.now, NOW)}
    del arrays["shape"], arrays["parameters"]
    return arrays


def restore(memory: Memory, arrays: Mapping[str, np.ndarray]) -> None:
    """Fill a new memory with `arrays`, by the names of `changing`.

    Raises ValueError for what learning cannot have left there.
    """
    for name, part in changing(memory).items():
        array = arrays[name]
        expect("agent", [(name, array.shape == part.shape and np.can_cast(array.dtype, part.dtype, "equiv"))])
        part[...] = array
    for name in NOW.names or ():
        setattr(memory.now, name, arrays["now"][name].item())
    expect("agent", contents(memory))


def contents(m: Memory) -> Iterator[tuple[str, object]]:
    """Each part of a memory, and whether learning can have left it like that."""
    now = m.now
    n_states = len(m.q)
    length = len(m.queue_states)
    for name in ("q", "queue_rewards", "bias"):
        yield name, (np.abs(getattr(m, name)) <= LARGEST_KEPT).all()
    yield "e", (np.abs(m.e) <= max(m.visits.max(), LARGEST_TRACE)).all()  # a visit adds at most 1
    yield "visits", (m.visits >= 0).all()
    yield "probabilities", (m.probabilities >= 0).all() and abs(m.probabilities.sum() - 1) < 1e-9
    yield "register", all_exist(m.register, n_states) and 0 <= now.register_size <= len(m.register)
    yield "queue", all_exist(m.queue_states, n_states)
    yield "queue_size", 0 <= now.queue_size <= length and 0 <= now.queue_end < length
    in_queue = m.queue_states[np.arange(now.queue_end - now.queue_size, now.queue_end) % length]
    yield "queue_count", np.array_equal(m.queue_count, np.bincount(in_queue, minlength=n_states))
    yield "queue_unique", now.queue_unique == np.count_nonzero(m.queue_count)
    yield "temperature", 0 < now.temperature < math.inf
    yield "q_old", math.isfinite(now.q_old)
