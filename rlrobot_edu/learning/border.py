"""The border to compiled code, where no bounds are looked up: what may pass, checked once, in Python."""

import math
from collections.abc import Iterator, Mapping
from numbers import Real

import numpy as np

from rlrobot_edu.learning.memory import Memory
from rlrobot_edu.task.messages import all_exist, existing, expect


def check_pair(memory: Memory, s: int, a: int = 0) -> tuple[int, int]:
    """(s, a) as ints. Raises ValueError for a state or an action that there is not."""
    n_states, n_actions = memory.q.shape
    return existing("state", s, n_states), existing("action", a, n_actions)


def check_transition(memory: Memory, s: int, a: int, r: float, s_next: int) -> tuple[int, int, float, int]:
    """The transition in Python's own numbers, which kernels know. Raises ValueError for one that cannot be."""
    s, a = check_pair(memory, s, a)
    s_next = existing("state", s_next, len(memory.q))
    if not (isinstance(r, Real) and math.isfinite(r)):
        raise ValueError(f"a reward must be a finite number, got {r!r:.200}")
    return s, a, float(r), s_next


def changing(memory: Memory) -> dict[str, np.ndarray]:
    """The parts of a memory that learning changes, by name; arrays that share the memory's numbers."""
    return {name: np.asarray(value) for name, value in memory._asdict().items() if name != "parameters"}


def restore(memory: Memory, arrays: Mapping[str, np.ndarray]) -> None:
    """Fill a new memory with `arrays`, by the names of `changing`.

    Raises ValueError for what learning cannot have left there.
    """
    shape = memory.shape.copy()
    for name, part in changing(memory).items():
        array = arrays[name]
        if array.shape != part.shape or not np.can_cast(array.dtype, part.dtype, "equiv"):
            raise ValueError(f"{name} is {array.dtype} {array.shape}, expected {part.dtype} {part.shape}")
        part[...] = array
    expect("agent", [("shape", np.array_equal(memory.shape, shape))])
    expect("agent", contents(memory))


def contents(m: Memory) -> Iterator[tuple[str, bool]]:
    """Each part of a memory, and whether learning can have left it like that."""
    now, length = m.now, len(m.queue_states)
    for name in ("q", "e", "queue_rewards", "bias"):
        yield name, bool(np.isfinite(getattr(m, name)).all())
    yield "visits", bool((m.visits >= 0).all())
    yield "probabilities", bool((m.probabilities >= 0).all()) and abs(m.probabilities.sum() - 1) < 1e-9
    yield "register", all_exist(m.register, len(m.q)) and 0 <= now.register_size <= len(m.register)
    yield "queue", all_exist(m.queue_states, len(m.q))
    yield "queue_size", 0 <= now.queue_size <= length and 0 <= now.queue_end < length
    in_queue = m.queue_states[np.arange(now.queue_end - now.queue_size, now.queue_end) % length]
    yield "queue_count", np.array_equal(m.queue_count, np.bincount(in_queue, minlength=len(m.q)))
    yield "queue_unique", now.queue_unique == np.count_nonzero(m.queue_count)
    yield "temperature", 0 < now.temperature < math.inf
    yield "q_old", math.isfinite(now.q_old)
