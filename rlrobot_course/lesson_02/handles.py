"""What the reader of lesson 02 moves: the discount rate over rewards, and sweeps over a frozen lake."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_02.figures import plot_returns, plot_sweep

GAMMA = 0.9  # at which it opens, and of the sweeps
SWEEP = 5  # at which the lake opens
SQUARE = 62  # whose formula is open, beside the goal of the 8 x 8 map


def discounted(rewards, gamma):
    """The return of rewards, array (n,), the next one first."""
    total = 0.0
    weight = 1.0
    for k in range(rewards.shape[0]):
        total += weight * rewards[k]
        weight *= gamma
    return total


def gamma_over(gathered: Mapping[str, Sequence[float]]) -> Handle:
    """The rewards of policies, and what γ leaves of them. gathered: all rewards of each, the next one first."""
    rounded = [[float(r) for r in rewards] for rewards in gathered.values()]
    return Handle(
        "What γ leaves of each reward",
        __package__,
        ["gamma.js"],
        {"names": list(gathered), "rewards": rounded, "gamma": GAMMA},
        plot_returns(gathered, [GAMMA]),
        {"discounted": discounted},
    )


def one_sum(v, s_next, r, terminated, gamma):
    """What an action is worth by the values v, array (n_states,): r alone if the step is terminated."""
    if terminated:
        return r
    return r + gamma * v[s_next]


def sweeps_over(values: Sequence[np.ndarray], lake: Any) -> Handle:
    """A frozen lake's values after 0, 1, 2 … sweeps, with γ = 0.9.

    values: arrays (n_states,); lake: Gymnasium's FrozenLake of 8 x 8 squares, not slippery
    """
    follows = []
    for actions in lake.P.values():
        outcomes = [outcome for (outcome,) in actions.values()]
        follows.append([[s, float(r), bool(ends)] for _, s, r, ends in outcomes])
    feed = {
        "values": [[round(float(x), 6) for x in v] for v in values],
        "desc": [b"".join(row).decode() for row in lake.desc],
        "follows": follows,
        "gamma": GAMMA,
        "opens": SWEEP,
        "square": SQUARE,
    }
    return Handle(
        "Values that spread over a frozen lake",
        __package__,
        ["sweeps.js"],
        feed,
        plot_sweep(values, SWEEP, lake.desc),
        {"one_sum": one_sum},
    )
