"""The world of assignment 2: a crossing with eight doors, and a workshop behind one of them."""

from collections.abc import Callable, Mapping

import numpy as np

from rlrobot_course.figures.plots import (
    CURVES,
    GREY,
    Picture,
    chart,
    legend_below,
    plain,
)
from rlrobot_course.worlds.tapes import with_action

DOORS = 8
EPISODES, ROBOTS = 300, 100
SMOOTH = 10  # episodes of which a point of a curve is the mean

Choose = Callable[[np.ndarray, int], int]


class Workshop:
    """A robot at a crossing: door 0 leads into the workshop, each other door home.

    State 0 is the crossing, state 1 the workshop, state 2 the end. Home terminates with a reward of 0. In the workshop
    stand eight machines; to serve one terminates with a reward that is drawn: mean −0.1, standard deviation 1.

    seed: of the rewards; entered: for each episode, whether the robot went into the workshop
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def __init__(self, seed: int) -> None:
        self._random, self._s = np.random.default_rng(seed), 0
        self.entered: list[bool] = []

    def reset(self) -> int:
        """Start an episode at the crossing; returns its state."""
        self._s = 0
        return 0

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Go through door `a`, or serve machine `a`: returns next state, reward, terminated, truncated."""
        if self._s == 1:
            return 2, float(self._random.normal(-0.1, 1.0)), True, False
        self.entered.append(a == 0)
        self._s = 1 if a == 0 else 2
        return self._s, 0.0, a != 0, False


def learn_by(
    env: Workshop,
    q: np.ndarray,
    choose: Choose,
    value: Callable[[np.ndarray], float],
    alpha: float,
    gamma: float,
) -> None:
    """Learn with one table for EPISODES episodes. value: of a row of Q, what the next state counts as."""
    for _ in range(EPISODES):
        s, over = env.reset(), False
        while not over:
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            q[s, a] += alpha * (
                r + (0.0 if terminated else gamma * value(q[s_next])) - q[s, a]
            )
            s, over = s_next, terminated or truncated


def share_of_entered(
    learn: Callable[[Workshop, np.random.Generator], object],
) -> np.ndarray:
    """How many of ROBOTS robots go into the workshop in each episode, array (EPISODES,) of shares.

    learn: lets a robot learn in its workshop; the generator is for its choices
    """
    worlds = [Workshop(seed) for seed in range(ROBOTS)]
    for seed, world in enumerate(worlds):
        learn(world, np.random.default_rng([seed, 1]))
    return np.mean([world.entered for world in worlds], axis=0)


def plot_shares(shares: Mapping[str, np.ndarray], chance: np.ndarray) -> Picture:
    """The share of robots in the workshop, a curve each; `chance`: how many would be there if none meant to."""
    title = f"Who goes where nothing is to be had, {ROBOTS} robots each"
    picture, ax = chart((6.5, 3.8), "episode", "share of robots in the workshop", title)
    told = []
    episodes = np.arange(EPISODES).reshape(-1, SMOOTH).mean(axis=1)
    for (label, share), (colour, dashes) in zip(shares.items(), CURVES, strict=False):
        ax.plot(
            episodes,
            share.reshape(-1, SMOOTH).mean(axis=1),
            color=colour,
            linestyle=dashes,
            label=plain(label),
        )
        told.append(
            f"{label}: at most {100 * share.max():.0f} %, {100 * share[-50:].mean():.0f} % at the end"
        )
    ax.plot(chance, color=GREY, linestyle=":", label="by exploring alone")
    ax.margins(x=0)
    legend_below(picture, 2)
    picture.alt = f"Share of {ROBOTS} robots in the workshop over {EPISODES} episodes. {'; '.join(told)}."
    return picture
