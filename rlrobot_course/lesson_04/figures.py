"""The figures of lesson 04: how an action is drawn, rules as bars, rewards in other units, and what robots earn."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import gymnasium
import numpy as np

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    CURVES,
    GREY,
    Picture,
    in_panels,
    plain,
)
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_edu import Agent, Task, learn, make_env, plot_learning
from rlrobot_edu.learning.history import History


def plot_draw(p: Sequence[float], u: float) -> Picture:
    """Sampling an action: the probabilities end to end on a line from 0 to 1, and the point `u` that picks one of them.

    p: array (n_actions,), sums to 1, at most seven of them; u: in [0, 1)
    """
    ends = np.cumsum(p)
    sampled = int(np.argmax(ends > u))
    figure = Picture(figsize=(7, 1.7))
    ax = figure.subplots()
    for a, (colour, _) in zip(range(len(p)), CURVES, strict=False):
        ax.barh(
            0,
            p[a],
            left=ends[a] - p[a],
            color=colour,
            alpha=1 if a == sampled else 0.35,
            edgecolor=BLACK,
        )
        ax.text(
            ends[a] - p[a] / 2, 0.5, f"action {a}: {p[a]:g}", ha="center", va="bottom"
        )
    ax.plot([u, u], [-0.55, 0.45], color=BLACK, linewidth=2.5)
    ax.text(u, -0.6, f"u = {u:g}", ha="center", va="top")
    ax.set(
        xlim=(0, 1),
        ylim=(-1.05, 0.95),
        yticks=[],
        xticks=[0, *ends],
    )
    figure.headline(f"u = {u:g} draws action {sampled}")
    ax.set_xlabel("running sum of the probabilities")
    cuts = ", ".join(f"{end:g}" for end in ends)
    figure.alt = f"A line from 0 to 1, cut at {cuts}. u = {u:g} draws action {sampled}."
    return figure


def plot_rules(q_s: Sequence[float], rules: Mapping[str, np.ndarray]) -> Picture:
    """The values of a state's actions, and beside them the probabilities that some rules give these actions.

    q_s: array (n_actions,); rules: title of a panel -> array (n_actions,), sums to 1
    """
    figure = Picture(figsize=(9, 2.7))
    first, *others = figure.subplots(1, 1 + len(rules))
    first.bar(range(len(q_s)), q_s, color=GREY)
    first.set(title="values", ylabel="Q(s, a)")
    for ax, (name, p) in zip(others, rules.items(), strict=True):
        bars = ax.bar(range(len(p)), p, color=BLUE)
        ax.bar_label(bars, [f"{one:.2f}" for one in p], fontsize=9)
        ax.set(ylim=(0, 1.12), yticks=[0, 0.5, 1])
        ax.set_title(plain(name))
    others[0].set_ylabel("probability")
    for ax in figure.axes:
        ax.set(xlabel="action", xticks=range(len(q_s)))
    told = [
        f"{name}: {', '.join(f'{one:.2f}' for one in p)}" for name, p in rules.items()
    ]
    values = ", ".join(f"{q:g}" for q in q_s)
    figure.alt = f"Probabilities of {len(q_s)} actions with values {values}, as bars. {'; '.join(told)}."
    return figure


def learn_in_units(
    task: Task, factor: float, normalised: bool, repetitions: int, steps: int
) -> list[History]:
    """Let Q+SR agents learn `task` with all rewards times `factor`; the histories are in the task's own units again.

    normalised: whether the agents get the largest reward in the new units. If not, they normalise with the old
        one, which is the same factor for all units: as good as none
    """
    histories = []
    for i in range(repetitions):
        env = gymnasium.wrappers.TransformReward(
            make_env(task, seed=i), lambda r: r * factor
        )
        r_max = max(task.rewards) * (factor if normalised else 1)
        history = learn(
            Agent(task, "Q+SR", r_max=r_max, loop_evasion=False, seed=i),
            env,
            steps,
            progress=False,
        )
        transitions = history.transitions._replace(r=history.rewards / factor)
        histories.append(replace(history, transitions=transitions))
    return histories


def plot_units(
    task: Task,
    factors: Sequence[float],
    *,
    repetitions: int = 10,
    steps: int = 600,
) -> Picture:
    """Learning curves for rewards times each of `factors`: on the left without normalising, on the right with it."""
    panels = {
        f"{name} ({repetitions} repetitions)": [
            learn_in_units(task, factor, name == "normalised", repetitions, steps)
            for factor in factors
        ]
        for name in ("not normalised", "normalised")
    }
    labels = [f"rewards × {factor:g}" for factor in factors]
    return plot_side_by_side(panels, labels, "Rewards in three units")


def plot_side_by_side(
    panels: Mapping[str, Sequence[Sequence[History]]], labels: Sequence[str], title: str
) -> Picture:
    """Learning curves in panels that share their labels and the axis of rewards.

    panels: title of a panel -> for each label the repetitions to average, see `plot_learning`
    """
    figure, told = Picture(figsize=(8.5, 3.6)), []
    for ax, name, groups in in_panels(figure, panels, sharey=True):
        plot_learning(*groups, labels=labels, ax=ax, title=name)
        ax.get_legend().remove()
        ends = [
            np.mean([history.average_reward[-1] for history in group])
            for group in groups
        ]
        told.append(
            f"{name}: "
            + ", ".join(
                f"{label} {end:.2f}" for label, end in zip(labels, ends, strict=True)
            )
        )
    axes = figure.axes
    axes[1].set_ylabel("")
    # the bands of the first steps are as wide as the rewards themselves; the means decide what is shown
    means = np.concatenate([line.get_ydata() for ax in axes for line in ax.lines])
    axes[0].set_ylim(
        means.min() - 0.1 * np.ptp(means), means.max() + 0.1 * np.ptp(means)
    )
    figure.headline(title)
    note = "means, and bands of their 95 % intervals"
    names = [plain(label) for label in labels]
    figure.legend(
        axes[0].lines, names, loc="outside lower center", ncols=len(names), title=note
    )
    figure.alt = f"Learning curves, average reward at the end. {'; '.join(told)}."
    return figure


def plot_ends(
    worlds: Mapping[str, Mapping[str, Sequence[History]]], title: str
) -> Picture:
    """What each robot earns in the last 200 of its steps: a dot a robot, a line for the mean of all, a panel a world.

    worlds: title of a panel -> name of a rule -> the repetitions
    """
    figure, told = Picture(figsize=(8.5, 3.6)), []
    for ax, world, groups in in_panels(figure, worlds):
        means = []
        for i, ((name, group), (colour, _)) in enumerate(
            zip(groups.items(), CURVES, strict=False)
        ):
            ends = np.array([history.rewards[-200:].mean() for history in group])
            ax.plot(
                i + np.linspace(-0.25, 0.25, len(ends)),
                ends,
                "o",
                color=colour,
                alpha=0.7,
                markersize=4,
            )
            ax.plot([i - 0.35, i + 0.35], [ends.mean()] * 2, color=BLACK, linewidth=2)
            mean, half = mean_and_half(ends)
            means.append(
                f"{name} {mean:.2f} ± {half:.2f} (from {ends.min():.2f} to {ends.max():.2f})"
            )
        ax.set(
            xticks=range(len(groups)),
            xticklabels=map(plain, groups),
            title=plain(world),
        )
        ax.grid(alpha=0.3, axis="y")
        told.append(f"{world}: " + ", ".join(means))
    figure.axes[0].set_ylabel("reward per step, last 200 steps")
    figure.headline(title)
    figure.alt = f"One dot for each robot, what it earns in its last 200 steps. {'; '.join(told)}."
    return figure
