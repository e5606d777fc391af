"""What a learner does while all its values are still 0: the way in which it breaks ties decides where it gets."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import gymnasium
import numpy as np

from rlrobot_edu.show.picture import Picture


def count_visits(env: gymnasium.Env, choose: Callable[[np.ndarray], int], episodes: int, seed: int = 0) -> np.ndarray:
    """Number of steps that ended in each state while Q is 0 throughout; array (n_states,) of int.

    env: a world with Discrete states and actions; choose: function (row of Q) -> action
    """
    q_s = np.zeros(env.action_space.n)
    visits = np.zeros(env.observation_space.n, dtype=int)
    for episode in range(episodes):
        env.reset(seed=seed + episode)
        ended = False
        while not ended:
            s_next, _, terminated, truncated, _ = env.step(int(choose(q_s)))
            visits[s_next] += 1
            ended = terminated or truncated
    return visits


def plot_visits(env: gymnasium.Env, visits: Mapping[str, np.ndarray], title: str) -> Picture:
    """Maps of a FrozenLake, one a way to choose, with the share of all steps that ended in each square.

    visits: label of a map -> array (n_states,) of `count_visits`
    """
    names = {b"S": "start", b"F": "", b"H": "hole", b"G": "goal"}
    figure, told = Picture(figsize=(7.5, 3.7), layout="constrained"), []
    for ax, (label, counts) in zip(figure.subplots(1, len(visits)), visits.items(), strict=True):
        cells = env.unwrapped.desc
        share = 100 * counts.reshape(cells.shape) / counts.sum()
        image = ax.imshow(share, cmap="cividis", vmin=0, vmax=100)
        for (row, column), cell in np.ndenumerate(cells):
            value, n = share[row, column], counts.reshape(cells.shape)[row, column]
            text = f"{names[cell]}\n{value:.1f} %" if n else f"{names[cell]}\nnever"
            ax.text(column, row, text.strip(), ha="center", va="center", color="black" if value > 50 else "white")
        ax.set(xticks=[], yticks=[], title=label)
        told.append(f"{label}: {np.count_nonzero(counts)} of {counts.size} squares seen, the goal {counts[-1]} times")
    figure.suptitle(title)
    figure.colorbar(image, ax=figure.axes, label="steps that ended there (%)", shrink=0.8)
    figure.alt = f"Maps of the squares that were visited. {'; '.join(told)}."
    return figure
