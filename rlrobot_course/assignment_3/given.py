"""What the exercises of assignment 3 share."""

from typing import Any

import numpy as np

KINDS = ("accumulating", "replacing")

EPISODES = (
    ([1, 2, 3], [1.5, -0.5]),
    ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
    ([2, 1, 2, 0], [0.5, 2.5, 1.25]),
    ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
    ([1, 1, 2, 1, 3], [-1.5, 0.25, 0.75, 4.5]),
    ([2, 0], [2.5]),
)

ALPHAS, GAMMAS, LAMBDAS = (
    (0.5, 0.25, 0.4, 0.1, 0.3, 0.2),
    (0.9, 0.8, 0.95, 0.9, 0.7, 0.9),
    (0.8, 0.5, 0.9, 0.7, 0.6, 0.3),
)

V_START = np.array([7.0, 1.5, -0.5, 9.0])  # of 0 and 3, where the episodes end, the values tempt, too


def on_episodes(**more: tuple[Any, ...]) -> list[dict[str, Any]]:
    """A step of a tape for each episode."""
    columns = {"alpha": ALPHAS, "gamma": GAMMAS, "lam": LAMBDAS, **more}
    return [
        {"path": path, "rewards": rewards} | {name: column[i] for name, column in columns.items()}
        for i, (path, rewards) in enumerate(EPISODES)
    ]
