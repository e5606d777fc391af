"""The figures of lesson 04: how an action is drawn, what rules make of Q, what robots earn."""

from collections.abc import Mapping, Sequence

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
from rlrobot_edu.learning.history import History
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
