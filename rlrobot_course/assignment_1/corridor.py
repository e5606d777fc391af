"""The world of assignment 1: a cart in a corridor, with a battery."""

from collections.abc import Callable, Sequence

import numpy as np

from rlrobot_course.figures.plots import BLUE, GREEN, ORANGE, Picture, centred
from rlrobot_course.worlds.tapes import with_action

CELLS = 7  # the charger is in cell 0, the shelf in cell 6
FULL = 8  # moves that a full battery is good for
ACTIONS = ("left", "right", "charge")
SIGNS = ("←", "→", "↯")
LOOKS = (ORANGE, BLUE, GREEN)
CUTS = [
    11.25 + 0.5 * k for k in range(FULL)
]  # voltages between the charges 0, 1 … FULL
LONGEST = 60  # steps of an episode


def voltage(charge: int) -> float:
    """What the battery's sensor reads [V] with so many moves left."""
    return 11.0 + 0.5 * charge


class Corridor:
    """A cart that must bring a box to the shelf, and never run out of power.

    Actions: 0 left, 1 right, 2 charge. A move takes one unit of charge; at an end of the corridor the wheels only slip.
    Charging fills the battery in the charger's cell, and does nothing elsewhere.
    Rewards: −1 for a step; 20 at the shelf, and −20 where the battery is empty away from the charger; both terminate.
    Start: anywhere but at the shelf, with any charge from 1 on. After LONGEST steps an episode is truncated.

    read: of (cell, voltage) makes the number of the state; seed: of the starts
    reset() -> state; step(action) -> state, reward, terminated, truncated
    """

    def __init__(self, read: Callable[[int, float], int], seed: int = 0) -> None:
        self._read, self._random = read, np.random.default_rng(seed)
        self._cell, self._charge, self._t = 0, FULL, 0

    def reset(self) -> int:
        """Start an episode; returns its first state."""
        self._cell, self._charge = (
            int(self._random.integers(CELLS - 1)),
            int(self._random.integers(1, FULL + 1)),
        )
        self._t = 0
        return self._state()

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Do action `a`: returns next state, reward, terminated, truncated."""
        self._t += 1
        if a == 2 and self._cell == 0:
            self._charge = FULL
        elif a != 2:
            self._cell = min(max(self._cell + (1 if a == 1 else -1), 0), CELLS - 1)
            self._charge = max(self._charge - 1, 0)
        there, empty = self._cell == CELLS - 1, self._charge == 0 and self._cell > 0
        reward = -1.0
        if there:
            reward = 20.0
        elif empty:
            reward = -20.0
        return self._state(), reward, there or empty, self._t >= LONGEST

    def _state(self) -> int:
        return self._read(self._cell, voltage(self._charge))


def plot_policy(policy: np.ndarray, read: Callable[[int, float], int]) -> Picture:
    """What the policy, probabilities (n_states, 3), does in each cell with each charge.

    read: of (cell, voltage) makes the number of the state
    """
    picture = Picture(figsize=(6.5, 4.2))
    ax = picture.subplots()
    counts: Sequence[int] = [0, 0, 0]
    for cell in range(CELLS - 1):
        for charge in range(0 if cell == 0 else 1, FULL + 1):
            p = policy[read(cell, voltage(charge))]
            best = np.flatnonzero(p)
            counts = [n + (a in best) for a, n in enumerate(counts)]
            look = {"fontsize": 15, "color": LOOKS[best[0]], "family": "DejaVu Sans"}
            centred(ax, cell, charge, "".join(SIGNS[a] for a in best), **look)
    centred(ax, CELLS - 1, FULL / 2, "shelf", rotation=90)
    ax.set(
        xlim=(-0.5, CELLS - 0.5),
        ylim=(-0.5, FULL + 0.5),
        xlabel="cell (the charger is in 0)",
        ylabel="moves left",
    )
    picture.headline("What is best in each state: ← → move, ↯ charge")
    ax.grid(alpha=0.2)
    told = ", ".join(f"{name} in {n}" for name, n in zip(ACTIONS, counts, strict=True))
    picture.alt = f"A policy for {CELLS - 1} cells and charges of 0 to {FULL}. Best actions: {told} states."
    return picture
