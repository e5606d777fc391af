"""The figures of lesson 04a: what the temperature does, what units do, and which rule earns most."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import gymnasium
import numpy as np

from rlrobot_course.plots import BLACK, CURVES, Picture, plain
from rlrobot_edu import Agent, History, Task, learn, make_env, plot_learning
from rlrobot_edu.widgets.kernels import probabilities


def plot_temperature(x: Sequence[float], temperature: float) -> Picture:
    """Left: the probability of each action over the temperature. Right: the same at `temperature`, as bars.

    x: preferences, array (n_actions,), at most seven of them
    """
    figure = Picture(figsize=(9, 3.6))
    left, right = figure.subplots(1, 2, width_ratios=(3, 2), sharey=True)
    grid = np.logspace(-1, 3, 200)  # temperatures from 0.1 to 1000
    curves = np.array([probabilities(x, t) for t in grid])
    now = probabilities(x, temperature)
    for a, (colour, dashes) in zip(range(len(x)), CURVES, strict=False):
        label = f"action {a}, x = {x[a]:g}"
        left.semilogx(grid, curves[:, a], color=colour, linestyle=dashes, linewidth=2, label=label)
        right.bar(a, now[a], color=colour, width=0.7)
        right.text(a, now[a] + 0.01, f"{now[a]:.3f}", ha="center", va="bottom")
    left.axvline(temperature, color=BLACK, linewidth=1, linestyle=":")
    box = {"facecolor": "white", "edgecolor": "none", "pad": 1}
    left.text(temperature, 1.06, f"T = {temperature:.3g}", va="bottom", ha="center", bbox=box)
    left.set(xlabel="temperature T (logarithmic)", ylabel="probability P(a)", ylim=(0, 1.15), xlim=(grid[0], grid[-1]))
    left.grid(alpha=0.3)
    left.legend(fontsize=9, loc="center right")
    right.set(xlabel="action", xticks=range(len(x)), title=f"At T = {temperature:.3g}")
    left.set_title("The same preferences, from cold to hot", pad=12)
    told = ", ".join(f"action {a} {p:.3f}" for a, p in enumerate(now))
    figure.alt = (
        f"Probability of each action over the temperature: near the best action alone when cold, all alike when hot. "
        f"At T = {temperature:.3g}: {told}."
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
        history = learn(Agent(task, "Q+SR", r_max=r_max, loop_evasion=False, seed=seed + i), env, steps, progress=False)
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
    return plot_side_by_side(panels, labels, "Rewards in three units")


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


def plot_ends(worlds: Mapping[str, Sequence[Sequence[History]]], labels: Sequence[str], title: str) -> Picture:
    """What each robot earns in the last 200 of its steps: a dot a robot, a bar for the mean of all, a panel a world.

    worlds: title of a panel -> for each label the repetitions
    """
    figure, told = Picture(figsize=(8.5, 3.6)), []
    for ax, (name, groups) in zip(figure.subplots(1, len(worlds)), worlds.items(), strict=True):
        means = []
        for i, (group, (colour, _)) in enumerate(zip(groups, CURVES, strict=False)):
            ends = np.array([history.rewards[-200:].mean() for history in group])
            aside = i + np.linspace(-0.25, 0.25, len(ends))
            ax.plot(aside, ends, "o", color=colour, alpha=0.7, markersize=4)
            ax.plot([i - 0.35, i + 0.35], [ends.mean()] * 2, color=BLACK, linewidth=2)
            means.append(f"{labels[i]} {ends.mean():.2f} (from {ends.min():.2f} to {ends.max():.2f})")
        names = [plain(label) for label in labels]
        ax.set(xticks=range(len(labels)), title=plain(name))
        ax.set_xticklabels(names, rotation=30)
        ax.grid(alpha=0.3, axis="y")
        told.append(f"{name}: " + ", ".join(means))
    figure.axes[0].set_ylabel("reward per step, last 200 steps")
    figure.suptitle(plain(title))
    figure.alt = f"One dot for each robot, what it earns in its last 200 steps. {'; '.join(told)}."
    return figure
