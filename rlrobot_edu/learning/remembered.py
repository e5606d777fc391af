"""What of an agent's experience goes into its file, and comes back if acting and planning can have left it."""

from collections.abc import Iterator, Mapping

import numpy as np

from rlrobot_edu.learning.experience import OUTCOME, Experience, with_room
from rlrobot_edu.task.messages import all_exist, expect


def remembered(x: Experience) -> dict[str, np.ndarray]:
    """What has to be known of an experience, by name: its outcomes in their order, and what sweeping has yet to do."""
    outcomes = {name: getattr(x, name)[: x.now.outcomes] for name in OUTCOME[:5]}
    return outcomes | {"urgency": x.urgency, "told": x.told, "heap": x.heap[: x.now.urgent]}


def recall(x: Experience, arrays: Mapping[str, np.ndarray]) -> Experience:
    """A new experience filled with `arrays`, by the names of `remembered`.

    Raises ValueError for what cannot have been met.
    """
    n, urgent = len(arrays["pair"]), len(arrays["heap"])
    for name, part in remembered(x).items():
        array, shape = arrays[name], {"heap": (urgent,)}.get(name, (n,) if name in OUTCOME else part.shape)
        if array.shape != shape or not np.can_cast(array.dtype, part.dtype, "equiv"):
            raise ValueError(f"{name} is {array.dtype} {array.shape}, expected {part.dtype} {shape}")
    expect("agent", _met(len(x.tries), len(x.told), arrays))
    x = with_room(x, n) or x
    for name in OUTCOME[:5]:
        getattr(x, name)[:n] = arrays[name]
    x.urgency[:], x.told[:], x.heap[:urgent] = arrays["urgency"], arrays["told"], arrays["heap"]
    x.place[x.heap[:urgent]] = np.arange(urgent)
    for key, last, before in ((x.pair, x.last_of, x.same_pair), (x.s_next, x.last_into, x.same_next)):
        for i, number in enumerate(key[:n].tolist()):
            before[i], last[number] = last[number], i
    np.add.at(x.tries, x.pair[:n], x.times[:n])
    tried = [*dict.fromkeys(x.pair[:n].tolist())]
    x.tried[: len(tried)] = tried
    x.now.outcomes, x.now.pairs, x.now.urgent = n, len(tried), urgent
    return x


def _met(pairs: int, n_states: int, arrays: Mapping[str, np.ndarray]) -> Iterator[tuple[str, bool]]:
    """Each part of an experience in a file, and whether acting can have left it like that."""
    columns = [arrays[name].tolist() for name in OUTCOME[:4]]
    yield "pair", all_exist(arrays["pair"], pairs)
    yield "s_next", all_exist(arrays["s_next"], n_states)
    yield "r", bool(np.isfinite(arrays["r"]).all())
    yield "outcomes", len(set(zip(*columns, strict=True))) == len(columns[0])
    yield "times", bool((arrays["times"] > 0).all()) and int(arrays["times"].sum(dtype=object)) < 1 << 53
    urgency, heap = arrays["urgency"], arrays["heap"]
    yield "urgency", bool((urgency >= 0).all() and np.isfinite(urgency).all())
    yield "told", bool(np.isfinite(arrays["told"]).all())
    above = np.arange(-1, len(heap) - 1) // 2
    yield "heap", all_exist(heap, pairs) and len({*heap.tolist()}) == len(heap)
    yield "heap", bool((urgency[heap] <= urgency[heap[above]])[1:].all()) and set(heap.tolist()) <= {*columns[0]}
