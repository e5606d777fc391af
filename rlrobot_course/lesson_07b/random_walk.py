"""A walk without aim (Sutton & Barto, example 7.1): a world whose true values are known, to see how much λ is good."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from rlrobot_course.plots import BLUE, Picture, chart
from rlrobot_course.runs import error_bars

CELLS = 19
TRUE = np.linspace(-1, 1, CELLS + 2)[1:-1]  # of cell 1 to the last; cells 0 and CELLS + 1 are the ends


def walk_error(update: Callable[..., object], lam: float, alpha: float, episodes: int, seed: int) -> float:
    """How far Q is from the true values, root of the mean square, mean over the episodes.

    update: as `sarsa_lambda_update`; seed: of the walk
    """
    rng, errors = np.random.default_rng(seed), []
    q = np.zeros((CELLS + 2, 1))
    for _ in range(episodes):
        e, s = np.zeros_like(q), (CELLS + 1) // 2
        while 0 < s <= CELLS:
            s_next = s + (1 if rng.random() < 0.5 else -1)
            r = {0: -1.0, CELLS + 1: 1.0}.get(s_next, 0.0)
            update(q, e, s, 0, r, s_next, 0, not 0 < s_next <= CELLS, alpha, 1.0, lam)
            s = s_next
        errors.append(float(np.sqrt(np.mean((q[1:-1, 0] - TRUE) ** 2))))
    return float(np.mean(errors))


def sweep(
    update: Callable[..., object], lambdas: Sequence[float], walkers: int, alpha: float, episodes: int = 10
) -> dict[float, np.ndarray]:
    """The errors of so many walkers for each λ, arrays (walkers,); the same walks for every λ."""
    return {lam: np.array([walk_error(update, lam, alpha, episodes, i) for i in range(walkers)]) for lam in lambdas}


def plot_sweep(errors: Mapping[float, np.ndarray], title: str) -> Picture:
    """Mean error over λ, with its 95 % interval. errors: λ to array (walkers,)."""
    mean, reach = error_bars(np.array(list(errors.values())).T)
    walkers = len(next(iter(errors.values())))
    picture, ax = chart((6.5, 3.8), "λ", "error of Q (root of the mean square)", title)
    picture.alt = f"{title}. " + ", ".join(f"{m:.2f} at λ = {lam:g}" for lam, m in zip(errors, mean, strict=True)) + "."
    ax.errorbar(list(errors), mean, reach, color=BLUE, marker="o", capsize=3)
    ax.text(0.02, 0.04, f"{walkers} walkers each, means and their 95 % intervals", transform=ax.transAxes, fontsize=9)
    return picture
