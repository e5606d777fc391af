"""The repetitions of one method, to look at one by one or all together, and as columns to keep."""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.learning.history import History, Learned
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.task.messages import all_exist, expect


class Runs(list[History]):
    """The histories of one method's repetitions, in order: a list that also knows what they are together."""

    def __repr__(self) -> str:
        return f"<{len(self)} repetitions of {self[0].method}>" if self else "<no repetitions>"

    @property
    def curves(self) -> NDArray[np.float64]:
        """Learning curves, array (repetitions, steps): average reward; in an episodic task, of the last episode."""
        return np.array([h.average_reward if h.size.episode_steps is None else h.last_episode for h in self])

    @property
    def final(self) -> NDArray[np.float64]:
        """The final average reward of each repetition, array (repetitions,)."""
        return np.array([history.final_average_reward for history in self])

    @property
    def rewards(self) -> list[NDArray[np.float64]]:
        """The rewards of each repetition, arrays (steps,)."""
        return [history.rewards for history in self]

    @property
    def seconds(self) -> NDArray[np.float64]:
        """How long each repetition took, array (repetitions,) [s]."""
        return np.array([history.seconds for history in self])


_LEARNED = [f"learned_{name}" for name in Learned._fields]


def to_columns(histories: Sequence[History]) -> dict[str, np.ndarray]:
    """All arrays of several histories one after the other, by name, and their lengths."""
    parts = [_arrays(history) for history in histories]
    lengths = np.array([[len(array) for array in part.values()] for part in parts])
    return {"lengths": lengths, **{name: np.concatenate([part[name] for part in parts]) for name in parts[0]}}


def _arrays(history: History) -> dict[str, np.ndarray]:
    learned = dict(zip(_LEARNED, history.learned, strict=True))
    return {**history.transitions._asdict(), **learned, "seconds": np.array([history.seconds])}


def from_columns(columns: Mapping[str, np.ndarray], method: str, size: Size) -> list[History]:
    """The histories that `to_columns` wrote, of this method, in a world of this size."""
    names = [*Transitions._fields, *_LEARNED, "seconds"]
    expect("batch of repetitions", _contents(columns, names, size))
    ends = np.cumsum(columns["lengths"], axis=0)
    parts = [np.split(columns[name], ends[:-1, i]) for i, name in enumerate(names)]
    n = len(Transitions._fields)
    return [
        History(method, Transitions(*arrays[:n]), Learned(*arrays[n:-1]), float(arrays[-1][0]), size)
        for arrays in zip(*parts, strict=True)
    ]


def _contents(columns: Mapping[str, np.ndarray], names: Sequence[str], size: Size) -> Iterator[tuple[str, object]]:
    """Each column, and whether it can be of repetitions in a world of this size."""
    lengths = columns["lengths"]
    whole = lengths.ndim == 2 and lengths.dtype.kind in "iu" and lengths.shape[1] == len(names)
    yield "lengths", whole and (lengths >= 0).all() and (lengths[:, -1] == 1).all()
    kinds = {"r": "f", "learned_q": "f", "seconds": "f", "terminated": "b", "truncated": "b"}  # all others are integers
    limits = {"s": size.n_states, "s_next": size.n_states, "a": size.n_actions}
    limits["learned_pair"] = size.n_states * size.n_actions
    for i, name in enumerate(names):
        column, kind = columns[name], kinds.get(name, "iu")
        yield name, column.dtype.kind in kind and column.shape == (lengths[:, i].sum(),)
        yield name, np.isfinite(column).all() if kind == "f" else all_exist(column, limits.get(name, np.inf))
    steps = lengths[:, names.index("r")]
    for i, name in enumerate(Transitions._fields):
        kept = lengths[:, i] == steps
        yield name, (kept | (lengths[:, i] == 0) if name in ("s", "a", "s_next") else kept).all()
    learned = lengths[:, [names.index(name) for name in _LEARNED]]
    yield "learned_q", (learned == learned[:, :1]).all()
