"""How ties are broken: where a learner walks before it has learned anything."""

from collections.abc import Callable, Mapping

import gymnasium
import numpy as np
from matplotlib import colormaps
from matplotlib.colors import LogNorm

from rlrobot_edu.show.picture import Picture, plain


def count_visits(env: gymnasium.Env, choose: Callable[[np.ndarray], int], episodes: int, seed: int = 0) -> np.ndarray:
    """Number of steps that ended in each state while Q is 0 throughout; array (n_states,) of int.

    env: with Discrete states and actions; choose: function (row of Q) -> action
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
    figure, told, colours = Picture(figsize=(7.5, 3.7)), [], colormaps["cividis"].with_extremes(bad="white")
    for ax, (label, counts) in zip(figure.subplots(1, len(visits)), visits.items(), strict=True):
        cells = env.unwrapped.desc
        share = 100 * counts.reshape(cells.shape) / counts.sum()
        shown = np.where(counts.reshape(cells.shape) > 0, share, np.nan)
        image = ax.imshow(shown, cmap=colours, norm=LogNorm(0.1, 100))
        for (row, column), cell in np.ndenumerate(cells):
            value, n = share[row, column], counts.reshape(cells.shape)[row, column]
            text = f"{names[cell]}\n{value:.1f} %" if n else f"{names[cell]}\nnever"
            ink = "black" if value > 3 or not n else "white"
            ax.text(column, row, text.strip(), ha="center", va="center", color=ink)
        ax.set(xticks=[], yticks=[], title=plain(label))
        told.append(f"{label}: {np.count_nonzero(counts)} of {counts.size} squares seen, the goal {counts[-1]} times")
    figure.suptitle(plain(title))
    figure.colorbar(image, ax=figure.axes, label="steps that ended there (%, logarithmic)", shrink=0.8)
    figure.alt = f"Maps of the squares that were visited. {'; '.join(told)}."
    return figure
