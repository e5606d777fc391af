"""The figures of lesson 03: how ties are broken, how an action is sampled, what units do, which rule is best."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import gymnasium
import numpy as np

from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.palette import BLACK, CURVES
from rlrobot_edu.show.picture import Picture, plain
from rlrobot_edu.task.task import Task


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
    figure, told = Picture(figsize=(7.5, 3.7)), []
    for ax, (label, counts) in zip(figure.subplots(1, len(visits)), visits.items(), strict=True):
        cells = env.unwrapped.desc
        share = 100 * counts.reshape(cells.shape) / counts.sum()
        image = ax.imshow(share, cmap="cividis", vmin=0, vmax=100)
        for (row, column), cell in np.ndenumerate(cells):
            value, n = share[row, column], counts.reshape(cells.shape)[row, column]
            text = f"{names[cell]}\n{value:.1f} %" if n else f"{names[cell]}\nnever"
            ax.text(column, row, text.strip(), ha="center", va="center", color="black" if value > 50 else "white")
        ax.set(xticks=[], yticks=[], title=plain(label))
        told.append(f"{label}: {np.count_nonzero(counts)} of {counts.size} squares seen, the goal {counts[-1]} times")
    figure.suptitle(plain(title))
    figure.colorbar(image, ax=figure.axes, label="steps that ended there (%)", shrink=0.8)
    figure.alt = f"Maps of the squares that were visited. {'; '.join(told)}."
    return figure


def plot_draw(p: Sequence[float], u: float) -> Picture:
    """Sampling an action: the probabilities end to end on a line from 0 to 1, and the point `u` that picks one of them.

    p: array (n_actions,), sums to 1, at most seven of them; u: in [0, 1)
    """
    ends = np.cumsum(p)
    sampled = int(np.argmax(ends > u))
    figure = Picture(figsize=(7, 1.7))
    ax = figure.subplots()
    for a, (colour, _) in zip(range(len(p)), CURVES, strict=False):
        ax.barh(0, p[a], left=ends[a] - p[a], color=colour, alpha=1 if a == sampled else 0.35, edgecolor=BLACK)
        ax.text(ends[a] - p[a] / 2, 0.5, f"action {a}: {p[a]:g}", ha="center", va="bottom")
    ax.plot([u, u], [-0.55, 0.45], color=BLACK, linewidth=2.5)
    ax.text(u, -0.6, f"u = {u:g}", ha="center", va="top")
    ax.set(xlim=(0, 1), ylim=(-1.05, 0.95), yticks=[], xticks=[0, *ends], title=f"u = {u:g} draws action {sampled}")
    ax.set_xlabel("running sum of the probabilities")
    figure.alt = (
        f"A line from 0 to 1, cut at {', '.join(f'{end:g}' for end in ends)}. u = {u:g} draws action {sampled}."
    )
    return figure


def learn_in_units(
    task: Task, factor: float, normalised: bool, repetitions: int, steps: int, seed: int
) -> list[History]:
    """Let Q+SR agents learn `task` with all rewards times `factor`; the histories are in the task's own units again.

    normalised: whether the agents are told the largest reward in the new units. If not, they normalise with the old
        one, which is the same factor for all units: as good as none
    """
    histories = []
    for i in range(repetitions):
        env = gymnasium.wrappers.TransformReward(make_env(task, seed=seed + i), lambda r: r * factor)
        r_max = max(task.rewards) * (factor if normalised else 1)
        history = learn(Agent(task, "Q+SR", r_max=r_max, seed=seed + i), env, steps, progress=False)
        transitions = history.transitions._replace(r=history.rewards / factor)
        histories.append(replace(history, transitions=transitions))
    return histories


def plot_units(
    task: Task, factors: Sequence[float], *, repetitions: int = 10, steps: int = 600, seed: int = 0
) -> Picture:
    """Learning curves for rewards times each of `factors`: on the left without normalising, on the right with it."""
    panels = {
        f"{name} ({repetitions} repetitions)": [
            learn_in_units(task, factor, name == "normalised", repetitions, steps, seed) for factor in factors
        ]
        for name in ("not normalised", "normalised")
    }
    labels = [f"rewards × {factor:g}" for factor in factors]
    return plot_side_by_side(
        panels, labels, "Without normalising, the unit of the reward decides how the robot behaves"
    )


def plot_side_by_side(
    panels: Mapping[str, Sequence[Sequence[History]]], labels: Sequence[str], title: str, columns: int = 2
) -> Picture:
    """Learning curves in panels that share their labels, `columns` in a row, all with the same axis of rewards.

    panels: title of a panel -> for each label the repetitions to average, see `plot_learning`; as the repetitions of
        panels may differ in number, that number belongs in the panel's title
    """
    rows = -(-len(panels) // columns)
    figure, told = Picture(figsize=(8.5, 1 + 2.6 * rows)), []
    axes = figure.subplots(rows, columns, sharey=True, squeeze=False)
    for ax, (name, groups) in zip(axes.flat, panels.items(), strict=True):
        plot_learning(*groups, labels=labels, ax=ax, title=name)
        ax.get_legend().remove()
        if ax is not axes[ax.get_subplotspec().rowspan.start, 0]:
            ax.set_ylabel("")
        ends = [np.mean([history.average_reward[-1] for history in group]) for group in groups]
        told.append(f"{name}: " + ", ".join(f"{label} {end:.2f}" for label, end in zip(labels, ends, strict=True)))
    # the bands of the first steps are as wide as the rewards themselves; the means decide what is shown
    means = np.concatenate([line.get_ydata() for ax in figure.axes for line in ax.lines])
    axes[0, 0].set_ylim(means.min() - 0.1 * np.ptp(means), means.max() + 0.1 * np.ptp(means))
    figure.suptitle(plain(title))
    note = "means, and bands of their 95 % intervals"
    names = [plain(label) for label in labels]
    figure.legend(axes[0, 0].lines, names, loc="outside lower center", ncols=len(names), title=note)
    figure.alt = f"Learning curves, average reward at the end. {'; '.join(told)}."
    return figure
