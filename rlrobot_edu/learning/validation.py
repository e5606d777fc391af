"""Checks, made once in Python, of what goes to compiled code, which looks up no bounds: numbers and files."""

import math
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from rlrobot_edu.learning.memory import NOW, Memory, as_array
from rlrobot_edu.learning.planning.experience import OUTCOME, Experience, meet, with_room
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


def changing(memory: Memory, x: Experience | None = None) -> dict[str, np.ndarray]:
    """What learning changes in a memory and an experience, by name; arrays that share their numbers, but ``now``."""
    arrays = memory._asdict() | {"now": as_array(memory.now, NOW)}
    del arrays["shape"], arrays["parameters"]
    if x is not None:
        arrays |= {name: getattr(x, name)[: x.now.outcomes] for name in OUTCOME[:5]}
        arrays |= {f"notes_{i}": array for i, array in enumerate(x.notes)}
    return arrays


def restore(memory: Memory, x: Experience | None, arrays: Mapping[str, np.ndarray]) -> Experience | None:
    """Fill a new memory and a new experience with `arrays`, by the names of `changing`; returns the experience.

    Raises ValueError for what learning cannot have left there.
    """
    for name, part in changing(memory, x).items():
        array = arrays[name]
        expected = arrays["pair"].shape if name in OUTCOME else part.shape
        expect("agent", [(name, array.shape == expected and np.can_cast(array.dtype, part.dtype, "equiv"))])
        if name not in OUTCOME:
            part[...] = array
    for name in NOW.names or ():
        setattr(memory.now, name, arrays["now"][name].item())
    expect("agent", contents(memory, x))
    return x and _met(x, arrays)


def contents(m: Memory, x: Experience | None = None) -> Iterator[tuple[str, object]]:
    """Each part of a memory and of a planner's notes, and whether learning can have left it like that."""
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
    for i, array in enumerate(x.notes if x else ()):
        yield f"notes_{i}", np.isfinite(array).all()


def _met(x: Experience, arrays: Mapping[str, np.ndarray]) -> Experience:
    """The experience `x`, which is new, with the outcomes in `arrays`. Raises ValueError for what cannot have been."""
    times = arrays["times"]
    are_counts = (times > 0).all() and int(times.sum(dtype=object)) < 1 << 53
    limits = {"pair": len(x.tries), "s_next": len(x.last_into)}
    expect("agent", [(name, all_exist(arrays[name], n)) for name, n in limits.items()])
    expect("agent", [("r", np.isfinite(arrays["r"]).all()), ("times", are_counts)])
    x = with_room(x, len(times))
    for outcome in zip(*(arrays[name].tolist() for name in OUTCOME[:5]), strict=True):
        meet(x, *outcome)
    return x
