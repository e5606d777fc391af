"""The figures of lesson 14: what a recording covers, what the unknown does, and the gap."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    RED,
    Picture,
    centred,
    in_panels,
    name_rows,
    plain,
)
from rlrobot_course.lesson_14.worlds import Gap
from rlrobot_edu import SampleModel, value_iteration
from rlrobot_edu.show.palette import LIGHT
from rlrobot_edu.show.style import SHADES_OF_BLUE

NEVER = {
    "facecolor": LIGHT["floor"],
    "edgecolor": GREY,
    "hatch": "///",
    "linewidth": 0.0,
}  # what was never tried


def counts_finding(counts: np.ndarray) -> str:
    """How many pairs were never tried, and how many once. counts: array (states, actions)"""
    never, once = np.count_nonzero(counts == 0), np.count_nonzero(counts == 1)
    if not never:
        return f"All {counts.size} pairs were tried, {once} of them once"
    return f"{never} of {counts.size} pairs were never tried, {once} once"


def plot_counts(
    model: SampleModel, states: Sequence[str], actions: Sequence[str]
) -> Picture:
    """How often each pair was tried, as a table. states, actions: what they are called"""
    counts = model.pair_count
    figure = Picture(figsize=(1.6 + 1.35 * len(actions), 1.5 + 0.5 * len(states)))
    note = f"how often each action was done in each state, in {counts.sum():,} steps"
    figure.headline(counts_finding(counts), note)
    ax = figure.subplots()
    shown = np.ma.log10(np.ma.masked_equal(counts, 0))
    ax.imshow(shown, cmap=SHADES_OF_BLUE, vmin=-0.5, vmax=6, aspect="auto")
    for (s, a), count in np.ndenumerate(counts):
        if count:
            centred(ax, a, s, f"{count:,}")
        else:
            ax.add_patch(Rectangle((a - 0.5, s - 0.5), 1, 1, **NEVER))
            box = {"facecolor": "white", "edgecolor": "none", "pad": 2}
            centred(ax, a, s, "never", color=RED, weight="bold", bbox=box)
    ax.set_xticks(range(len(actions)), [plain(text) for text in actions])
    ax.set_yticks(range(len(states)), [plain(text) for text in states])
    ax.tick_params(length=0)
    ax.spines["bottom"].set_visible(False)
    never = [f"{states[s]}, {actions[a]}" for s, a in np.argwhere(counts == 0)]
    figure.alt = (
        f"A table of {counts.shape[0]} states and {counts.shape[1]} actions with how often each pair was tried, from 1 "
        f"to {counts.max():,}; {np.count_nonzero(counts == 1)} were tried once. Never: {'; '.join(never) or 'none'}."
    )
    return figure


def unknown_finding(
    models: Mapping[str, SampleModel], s: int, actions: Sequence[str]
) -> str:
    """Which action is the best in each model, and whether it was never tried."""
    said = []
    for name, model in models.items():
        best = int(value_iteration(model).q[s].argmax())
        never = "" if model.pair_count[s, best] else ", never tried"
        said.append(f"“{actions[best]}”{never}, with “{name}”")
    return f"Best is {'; '.join(said)}"


def plot_unknown(
    models: Mapping[str, SampleModel], s: int, actions: Sequence[str], place: str
) -> Picture:
    """What each action of state `s` is worth in several models of one recording; hatched: what was never tried there.

    models: by what an unseen pair does; actions, place: what the actions and the state are called
    """
    figure = Picture(figsize=(8.2, 3.1))
    note = f"Q* of each action {place}; hatched: never tried there, ←: the best"
    figure.headline(unknown_finding(models, s, actions), note)
    told = []
    for ax, name, model in in_panels(figure, models, sharey=True, sharex=True):
        q, tried = value_iteration(model).q[s], model.pair_count[s] > 0
        best = int(q.argmax())
        for a, value in enumerate(q):
            look: dict[str, Any] = {"color": BLUE}
            if not tried[a]:
                look = {"facecolor": "white", "edgecolor": RED, "hatch": "////"}
            ax.barh(a, value, 0.7, **look)
            text = f"{value:.1f}{' ←' if a == best else ''}"
            ax.text(value + 1, a, text, va="center")
        ax.set_title(f"“{plain(name)}”", weight="bold")
        ax.set(xlim=(0, 108), xticks=[])
        ax.spines["bottom"].set_visible(False)
        told.append(
            f"{name}: best is {actions[best]}, {'tried' if tried[best] else 'never tried'}, {q[best]:.1f}"
        )
    name_rows(figure.axes[0], actions)
    figure.alt = f"Bars of Q* of each action {place}, a panel for each treatment of unseen pairs. {'; '.join(told)}."
    return figure


def capture_finding(shares: np.ndarray, rewards: np.ndarray, recorded: float) -> str:
    """Where the agents are in the end, and what that pays them."""
    return (
        f"In the end the agents spend {shares[:, -1].mean():.0%} of their steps in suspect loops and earn "
        f"{rewards[:, -1].mean():.1f} a step; the recorded robot earned {recorded:.1f}"
    )


def plot_capture(
    shares: np.ndarray, rewards: np.ndarray, recorded: float, block: int
) -> Picture:
    """How agents come to spend their time in a model's loops, and what that pays.

    shares, rewards: arrays (agents, blocks): share of the steps spent in loops, and mean reward, in blocks of `block`
    recorded: mean reward of the robot that was recorded
    """
    figure = Picture(figsize=(8.0, 3.7))
    note = f"means of {block} steps in the model; thin: one of {len(shares)} agents, thick: their mean"
    figure.headline(capture_finding(shares, rewards, recorded), note)
    left, right = figure.subplots(1, 2)
    t = block * np.arange(1, shares.shape[1] + 1)
    for ax, runs in ((left, 100 * shares), (right, rewards)):
        ax.plot(t, runs.T, color=BLUE, alpha=0.25, linewidth=1)
        ax.plot(t, runs.mean(axis=0), color=BLUE, linewidth=2.4)
        ax.set_xlabel("step in the model")
        ax.grid(axis="y")
        ax.margins(x=0)
    left.set_title("steps in suspect loops (%)", weight="bold")
    left.set(ylim=(-3, 103))
    right.axhline(recorded, color=RED, linestyle="--")
    right.set_title("reward a step", weight="bold")
    right.text(t[-1], recorded - 0.4, "the recorded robot", color=RED, weight="bold", ha="right", va="top")  # fmt: skip
    figure.alt = (
        f"Two sets of curves of {len(shares)} agents. Steps spent in suspect loops: {shares[:, 0].mean():.0%} in the "
        f"first {block}, {shares[:, -1].mean():.0%} in the last. Reward per step: {rewards[:, 0].mean():.1f} at first, "
        f"{rewards[:, -1].mean():.1f} in the end; the recorded robot earned {recorded:.1f}."
    )
    return figure


def gaps_finding(gaps: Mapping[str, Gap]) -> str:
    """Where model and robot differ least, and by how much elsewhere."""
    least = min(gaps, key=lambda name: gaps[name].mean)
    others = [
        f"{gap.mean:.1f} with “{name}”" for name, gap in gaps.items() if name != least
    ]
    return f"The model promises {gaps[least].mean:.1f} a step too much with “{least}”, {', '.join(others)}"


def plot_gaps(gaps: Mapping[str, Gap]) -> Picture:
    """What agents earn in the model and on the robot, a row a setting; their difference with its 95 % interval."""
    figure = Picture(figsize=(8.0, 1.8 + 0.55 * len(gaps)))
    n = len(next(iter(gaps.values())).model)
    note = f"reward a step; means of {n} recordings, one agent each; right: with the 95 % interval"
    figure.headline(gaps_finding(gaps), note)
    ax, beside = figure.subplots(1, 2, sharey=True, width_ratios=(3, 2))
    told = []
    for row, (name, gap) in enumerate(gaps.items()):
        model, robot = gap.model.mean(), gap.robot.mean()
        ax.plot([robot, model], [row, row], color=GREY, linewidth=1.5, zorder=1)
        ax.plot(model, row, "o", color=GREY, markersize=9)
        ax.plot(robot, row, "s", color=BLUE, markersize=8)
        beside.errorbar(
            gap.mean, row, xerr=gap.half, fmt="D", color=BLACK, markersize=5
        )
        if row == 0:
            centred(
                ax, model, -0.36, "in the model", color=LIGHT["faint"], weight="bold"
            )
            centred(ax, robot, -0.36, "on the robot", color=BLUE, weight="bold")
        told.append(
            f"{name}: model {model:.1f}, robot {robot:.1f}, difference {gap.mean:.1f} ± {gap.half:.1f}"
        )
    ax.set_yticks(range(len(gaps)), [plain(name) for name in gaps])
    ax.set_ylim(len(gaps) - 0.5, -0.6)
    ax.set_xlim(0, 10.5)
    beside.axvline(0, color=GREY, linewidth=1)
    beside.set_title("model less robot", weight="bold")
    for each in (ax, beside):
        each.grid(axis="x")
    figure.alt = f"Model less robot, {n} recordings each. Reward per step of the same agents. {'; '.join(told)}."
    return figure
