"""What must hold for the arrays of a sample model: the kernels that draw from them look up no bounds."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from rlrobot_edu.task.messages import all_exist, expect
from rlrobot_edu.task.spaces import check_table

if TYPE_CHECKING:
    from rlrobot_edu.models.sample_model import SampleModel

DTYPES = {
    "offsets": np.int64, "s_next": np.int64, "r": np.float64, "terminated": np.bool_, "cumulative": np.int64,
    "starts": np.int64, "rewards": np.float64,
}  # fmt: skip


def check_model(model: "SampleModel", unseen: Sequence[str]) -> None:
    """Give the arrays of a model the kernels' types. Raises ValueError that names the first part that cannot be.

    unseen: what a model may do after a pair that was never tried
    """
    if model.unseen not in unseen:
        raise ValueError(f"unseen must be one of {', '.join(unseen)}, got {model.unseen!r:.200}")
    numbers = (*model.shape, model.n_actions, 1 if model.episode_steps is None else model.episode_steps)
    whole = all(isinstance(n, int | np.integer) and 1 <= n < 2**53 for n in numbers)
    expect("sample model", [("shape, n_actions or episode_steps", whole)])
    check_table(model.n_states, model.n_actions)
    for name, dtype in DTYPES.items():
        array = np.asarray(getattr(model, name))
        expect("sample model", [(name, array.ndim == 1 and np.can_cast(array.dtype, dtype, "same_kind"))])
        vars(model)[name] = np.ascontiguousarray(array, dtype)  # one type for numba, compiled once
    expect("sample model", _contents(model))


def _contents(model: "SampleModel") -> Iterator[tuple[str, bool]]:
    offsets, outcomes, rewards = model.offsets, len(model.s_next), model.rewards
    yield "rewards", len(rewards) > 0 and bool(np.isfinite(rewards).all() and (np.diff(rewards) > 0).all())
    yield "r", len(model.r) == outcomes and bool(np.isin(model.r, rewards).all())
    yield "terminated", len(model.terminated) == outcomes
    yield "s_next", all_exist(model.s_next, model.n_states)
    yield "starts", len(model.starts) > 0 and all_exist(model.starts, model.n_states)
    rising = len(offsets) == model.n_states * model.n_actions + 1 and bool((np.diff(offsets) >= 0).all())
    yield "offsets", rising and bool(offsets[0] == 0 and offsets[-1] == outcomes)
    total = model.cumulative  # floats add such numbers, too, and differences of larger ones turn round
    countable = len(total) == outcomes and bool(((total >= 1) & (total < 2**53)).all())
    yield "cumulative", countable and bool((model.count >= 1).all())
