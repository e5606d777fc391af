"""What the reader of lesson 02 moves: the discount rate, over what it leaves of each reward."""

from collections.abc import Mapping, Sequence

from rlrobot_course.handles.handle import Handle
from rlrobot_course.lesson_02.figures import plot_returns

GAMMA = 0.9  # at which it opens


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
        "rlrobot_course.lesson_02",
        ["gamma.js"],
        {"names": list(gathered), "rewards": rounded, "gamma": GAMMA},
        plot_returns(gathered, [GAMMA]),
        {"discounted": discounted},
    )
