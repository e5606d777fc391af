"""The worlds of assignment 3: a robot that drifts between two docks, and a long corridor."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from rlrobot_course.figures.plots import CURVES, Picture, chart, legend_below, plain
from rlrobot_course.figures.runs import error_bars

SECTIONS = 9  # of the wall, 1 to 9; 0 and 10 are the docks
TRUE = np.arange(1, SECTIONS + 1) / (
    SECTIONS + 1
)  # how often a drift from each section ends at the right dock
ROBOTS, EPISODES = 60, 10
HIGHEST = 0.35  # error that the picture shows; larger ones are far beyond
CELLS, LONGEST = 12, 400  # of the corridor, and steps of an episode in it

Update = Callable[..., object]


def drift(rng: np.random.Generator) -> tuple[list[int], list[float]]:
    """One episode from the middle: its states, the last is a dock, and its rewards, 1 at the right dock, else 0."""
    path = [(SECTIONS + 1) // 2]
    while 0 < path[-1] <= SECTIONS:
        path.append(path[-1] + (1 if rng.random() < 0.5 else -1))
    return path, [0.0] * (len(path) - 2) + [float(path[-1] > SECTIONS)]


def drift_errors(learn: Update, lambdas: Sequence[float], alpha: float) -> np.ndarray:
    """How far V is from the true values, root of the mean square, mean over EPISODES; array (ROBOTS, λs).

    learn: of (v, path, rewards, alpha, gamma, lam), changes v; every λ is given the same drifts
    """
    errors = np.zeros((ROBOTS, len(lambdas)))
    for robot in range(ROBOTS):
        rng = np.random.default_rng(robot)
        episodes = [drift(rng) for _ in range(EPISODES)]
        for column, lam in enumerate(lambdas):
            v = np.full(SECTIONS + 2, 0.5)
            for path, rewards in episodes:
                learn(v, path, rewards, alpha, 1.0, lam)
                errors[robot, column] += (
                    np.sqrt(np.mean((v[1:-1] - TRUE) ** 2)) / EPISODES
                )
    return errors


def plot_errors(
    lambdas: Sequence[float], errors: Mapping[str, np.ndarray], alpha: float
) -> Picture:
    """Mean error over λ with its 95 % interval, a curve for each kind of trace."""
    title = f"{ROBOTS} robots each, {EPISODES} episodes, α = {alpha:g}"
    picture, ax = chart((6.5, 3.8), "λ", "error of V (root of the mean square)", title)
    told = []
    for (label, error), (colour, dashes) in zip(errors.items(), CURVES, strict=False):
        mean, reach = error_bars(error)
        ax.errorbar(
            lambdas,
            mean,
            reach,
            color=colour,
            linestyle=dashes,
            marker="o",
            capsize=3,
            label=plain(label),
        )
        last = f"{mean[-1]:.2f}" if mean[-1] < HIGHEST else "far beyond the picture"
        told.append(
            f"{label}: {mean[0]:.2f} at λ = 0, at best {mean.min():.2f}, {last} at λ = {lambdas[-1]:g}"
        )
    ax.set_ylim(0, HIGHEST)
    legend_below(picture, 3)
    picture.alt = f"Error of V over λ, α = {alpha:g}. {'; '.join(told)}."
    return picture


def corridor_steps(
    update: Update, lam: float, epsilon: float, episodes: int, robots: int = 30
) -> np.ndarray:
    """Steps to the far end of the corridor, mean over the robots; array (episodes,).

    update: as `watkins_update`. Actions: 0 left, 1 right; −1 for each step, and the far end terminates.
    """
    steps = np.zeros(episodes)
    for robot in range(robots):
        rng, q = np.random.default_rng(robot), np.zeros((CELLS, 2))
        for episode in range(episodes):
            e, s, a = np.zeros_like(q), 0, int(rng.integers(2))
            for _ in range(LONGEST):
                steps[episode] += 1 / robots
                s_next = min(max(s + (1 if a else -1), 0), CELLS - 1)
                best = np.flatnonzero(q[s_next] == q[s_next].max())
                a_next = (
                    int(rng.integers(2))
                    if rng.random() < epsilon
                    else int(rng.choice(best))
                )
                over = s_next == CELLS - 1
                update(q, e, s, a, -1.0, s_next, a_next, over, 0.2, 0.95, lam)
                s, a = s_next, a_next
                if over:
                    break
    return steps
