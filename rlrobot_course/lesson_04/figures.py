"""The figures of lesson 04: how an action is drawn, what rules make of Q, rewards in other units, what robots earn."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import gymnasium
import numpy as np
from matplotlib.axes import Axes

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    Picture,
    in_panels,
    name_rows,
    plain,
)
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.figures.words import as_sentence
from rlrobot_edu import Agent, Task, learn, make_env, plot_learning
from rlrobot_edu.learning.history import History
from rlrobot_edu.show.ends import End, name_ends
from rlrobot_edu.show.palette import LIGHT

NARROW = 0.07  # a piece of a bar that has no room for a number


def plot_draw(p: Sequence[float], u: float) -> Picture:
    """Sampling an action: the probabilities end to end on a line from 0 to 1, and the point `u` that picks one of them.

    p: array (n_actions,), sums to 1; u: in [0, 1)
    """
    ends = np.cumsum(p)
    sampled = int(np.argmax(ends > u))
    figure = Picture(figsize=(7, 2.0))
    figure.headline(
        f"u = {u:g} draws action {sampled}",
        "the probabilities end to end; below: their running sum",
    )
    ax = figure.subplots()
    for a, end in enumerate(ends):
        colour = BLUE if a == sampled else LIGHT["line"]
        ax.barh(0, p[a], left=end - p[a], color=colour, edgecolor="white")
        ax.text(end - p[a] / 2, 0.5, f"action {a}: {p[a]:g}", ha="center", va="bottom")
    ax.plot([u, u], [-0.55, 0.45], color=BLACK, linewidth=2.5)
    ax.text(u, -0.6, f"u = {u:g}", ha="center", va="top")
    ax.set(
        xlim=(0, 1),
        ylim=(-1.05, 0.95),
        yticks=[],
        xticks=[0, *ends],
    )
    cuts = ", ".join(f"{end:g}" for end in ends)
    figure.alt = f"A line from 0 to 1, cut at {cuts}. u = {u:g} draws action {sampled}."
    return figure


def plot_rules(q_s: Sequence[float], rules: Mapping[str, np.ndarray]) -> Picture:
    """The probabilities that some rules give the actions of a state, a bar from 0 to 1 for each rule.

    q_s: array (n_actions,); rules: name -> array (n_actions,), sums to 1
    """
    best = int(np.argmax(q_s))
    values = ", ".join(f"{q:g}" for q in q_s)
    figure = Picture(figsize=(8.4, 0.75 * len(rules) + 1.2))
    figure.headline(
        sharpest_and_dullest(q_s, rules),
        f"the probabilities of actions 0, 1, …, end to end; their values: {values}; blue: the best",
    )
    ax = figure.subplots()
    for row, p in enumerate(rules.values()):
        starts = np.cumsum(p) - p
        colours = [BLUE if a == best else LIGHT["line"] for a in range(len(p))]
        ax.barh(row, p, left=starts, color=colours, edgecolor="white", height=0.62)
        for a in np.flatnonzero(p > NARROW):
            look = {"ha": "center", "va": "center", "weight": "bold"}
            colour = "white" if a == best else BLACK
            middle = starts[a] + p[a] / 2
            ax.text(middle, row, f"{a}: {p[a]:.2f}", color=colour, **look)
    name_rows(ax, list(rules))
    ax.set(xlim=(0, 1), xticks=[0, 0.5, 1])
    told = [
        f"{name}: {', '.join(f'{one:.2f}' for one in p)}" for name, p in rules.items()
    ]
    figure.alt = f"Probabilities of {len(q_s)} actions with values {values}, end to end on a bar. {'; '.join(told)}."
    return figure


def sharpest_and_dullest(q_s: Sequence[float], rules: Mapping[str, np.ndarray]) -> str:
    """How often the rules take the best action: the one that does so most often, and the one that does so least."""
    best = int(np.argmax(q_s))
    shares = {name: 100 * p[best] for name, p in rules.items()}
    most, least = (
        max(shares, key=shares.__getitem__),
        min(shares, key=shares.__getitem__),
    )
    return (
        f"The best action is taken in {shares[most]:.0f} % by {most}, "
        f"and in {shares[least]:.0f} % by {least}"
    )


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
    return plot_side_by_side(panels, labels)


def plot_side_by_side(
    panels: Mapping[str, Sequence[Sequence[History]]], labels: Sequence[str]
) -> Picture:
    """Learning curves in panels that share their labels and the axis of rewards.

    panels: title of a panel -> for each label the repetitions to average, see `plot_learning`
    """
    figure, told = Picture(figsize=(8.4, 4.0)), []
    ends = {
        name: [np.mean([run.average_reward[-1] for run in group]) for group in groups]
        for name, groups in panels.items()
    }
    figure.headline(
        how_far_apart(ends),
        "average reward a step so far; line: mean, band: its 95 % interval",
    )
    for ax, name, groups in in_panels(figure, panels, sharey=True):
        plot_learning(*groups, labels=labels, ax=ax, title=name)
        ax.get_legend().remove()
        ax.set_ylabel("")
        words = [
            f"{label} {end:.2f}" for label, end in zip(labels, ends[name], strict=True)
        ]
        told.append(f"{name}: {', '.join(words)}")
    axes = figure.axes
    # the bands of the first steps are as wide as the rewards themselves; the means decide what is shown
    means = np.concatenate([line.get_ydata() for ax in axes for line in ax.lines])
    axes[0].set_ylim(
        means.min() - 0.1 * np.ptp(means), means.max() + 0.1 * np.ptp(means)
    )
    for ax, values in zip(axes, ends.values(), strict=True):
        _name_together(ax, labels, values)
    figure.alt = f"Learning curves, average reward at the end. {'; '.join(told)}."
    return figure


def how_far_apart(ends: Mapping[str, Sequence[float]]) -> str:
    """In which panel the curves end apart and in which together, as a sentence. ends: of the curves, by panel"""
    parts = []
    for name, values in ends.items():
        panel = name.split(" (")[0]
        low, high = f"{min(values):.2f}", f"{max(values):.2f}"
        if low == high:
            parts.append(f"{panel}: all end at {low}")
        else:
            parts.append(f"{panel}: {low} to {high} a step")
    return as_sentence("; ".join(parts))


def _name_together(ax: Axes, labels: Sequence[str], ends: Sequence[float]) -> None:
    """Name the curves at their ends; those that end alike have one name."""
    alike: dict[str, list[int]] = {}
    for i, end in enumerate(ends):
        alike.setdefault(f"{end:.2f}", []).append(i)
    names = []
    for value, curves in alike.items():
        last = curves[-1]
        name = labels[last] if len(curves) == 1 else f"all {len(curves)}"
        colour = str(ax.lines[last].get_color())
        names.append(End(float(ends[last]), f"{name}\n{value}", colour))
    name_ends(ax, names)


def plot_ends(worlds: Mapping[str, Mapping[str, Sequence[History]]]) -> Picture:
    """What each robot earns in the last 200 of its steps: a dot a robot, a line for the mean of all, a panel a world.

    worlds: title of a panel -> name of a rule -> the repetitions
    """
    figure, told = Picture(figsize=(8.4, 3.9)), []
    earned = {
        world: {
            name: np.array([history.rewards[-200:].mean() for history in group])
            for name, group in groups.items()
        }
        for world, groups in worlds.items()
    }
    figure.headline(
        who_earns_most(earned),
        "reward a step in the last 200 steps; dot: a robot, line: the mean, box: its 95 % interval",
    )
    for ax, world, groups in in_panels(figure, earned):
        ax.set_title(plain(world))
        told.append(f"{world}: {', '.join(_draw_dots(ax, groups))}")
    figure.alt = f"One dot for each robot, what it earns in its last 200 steps. {'; '.join(told)}."
    return figure


def plot_earned(earned: Mapping[str, Sequence[float]]) -> Picture:
    """What each robot earns by each of two rules. earned: name of a rule -> a number a robot"""
    groups = {name: np.array(each) for name, each in earned.items()}
    figure = Picture(figsize=(5.2, 3.9))
    n_robots = max(map(len, groups.values()))
    figure.headline(
        how_much_more(groups),
        f"reward a step of {n_robots} robots; dot: a robot, line: the mean, box: its 95 % interval",
    )
    told = _draw_dots(figure.subplots(), groups)
    figure.alt = f"One dot for each robot, what it earns. {', '.join(told)}."
    return figure


def how_much_more(earned: Mapping[str, np.ndarray]) -> str:
    """How much more the better of two rules earns, with the interval of the difference, as a sentence."""
    means = {name: mean_and_half(each) for name, each in earned.items()}
    less, more = sorted(means, key=means.__getitem__)
    difference = means[more][0] - means[less][0]
    half = np.hypot(means[more][1], means[less][1])
    text = f"{more} earns {difference:.2f} ± {half:.2f} more than {less}"
    return as_sentence(text if difference > half else f"{text}, which may be chance")


def _draw_dots(ax: Axes, groups: Mapping[str, np.ndarray]) -> list[str]:
    """A dot a robot, a line for their mean, a box for its interval; returns these numbers in words, by group."""
    best = max(groups, key=lambda name: groups[name].mean())
    told = []
    for i, (name, each) in enumerate(groups.items()):
        colour = BLUE if name == best else GREY
        mean, half = mean_and_half(each)
        box = {"color": colour, "alpha": 0.2, "linewidth": 0}
        ax.fill_between([i - 0.35, i + 0.35], mean - half, mean + half, **box)
        places = i + np.linspace(-0.25, 0.25, len(each))
        ax.plot(places, each, "o", color=colour, alpha=0.7, markersize=4)
        ax.plot([i - 0.35, i + 0.35], [each.mean()] * 2, color=colour, linewidth=3)
        told.append(
            f"{name} {mean:.2f} ± {half:.2f} (from {each.min():.2f} to {each.max():.2f})"
        )
    names = [f"{name}\n{each.mean():.2f}" for name, each in groups.items()]
    ax.set_xticks(range(len(groups)), [plain(name) for name in names])
    ax.grid(axis="y")
    return told


def who_earns_most(earned: Mapping[str, Mapping[str, np.ndarray]]) -> str:
    """Which rule earns most in each world, as a sentence; too close to tell, if the next one's interval meets its own.

    earned: world -> rule -> what each robot earns
    """
    parts = []
    for world, groups in earned.items():
        intervals = {name: mean_and_half(ends) for name, ends in groups.items()}
        order = sorted(intervals, key=lambda name, of=intervals: of[name], reverse=True)
        (mean, half), (next_mean, next_half) = (intervals[name] for name in order[:2])
        where = world.split(", ")[0]
        if mean - half > next_mean + next_half:
            parts.append(f"{order[0]} earns most in the {where} ({mean:.2f})")
        else:
            parts.append(f"too close to tell in the {where}")
    return as_sentence(", ".join(parts))
