"""The figures of lesson 14: how sure an estimate is, what a recording covers, what the unknown does, and the gap."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREY,
    ORANGE,
    RED,
    Picture,
    centred,
    chart,
    in_panels,
    legend_below,
    name_rows,
    plain,
)
from rlrobot_course.lesson_14.worlds import Gap
from rlrobot_edu import SampleModel, value_iteration

NEVER = {
    "facecolor": "#e8e8e8",
    "edgecolor": GREY,
    "hatch": "///",
    "linewidth": 0.0,
}  # what was never tried


def plot_estimates(
    happened: np.ndarray, sizes: Sequence[int], estimates: int
) -> Picture:
    """How far estimates of a probability scatter, for several numbers of rows.

    happened: array (n,) of bool, whether it happened in each of many rows; sizes: how many are drawn of them for one
    estimate; estimates: how many estimates of each size
    """
    rng, p = np.random.default_rng(0), happened.mean()
    title = "The same probability, estimated again and again"
    figure, ax = chart((7.6, 3.9), "number of rows", "estimated probability", title)
    n = np.geomspace(min(sizes) * 0.8, max(sizes) * 1.25, 100)
    width = 2 * np.sqrt(p * (1 - p) / n)
    ax.fill_between(
        n,
        (p - width).clip(0),
        (p + width).clip(max=1),
        color=BLUE,
        alpha=0.15,
        linewidth=0,
    )
    ax.plot(
        [], [], color=BLUE, alpha=0.3, linewidth=8, label="within two standard errors"
    )
    ax.axhline(
        p, color=GREY, linestyle=":", label=f"in all {len(happened):,} rows: {p:.2f}"
    )
    shares = []
    for size in sizes:
        found = happened[rng.integers(len(happened), size=(estimates, size))].mean(
            axis=1
        )
        beside = size * np.exp(rng.uniform(-0.09, 0.09, estimates))
        ax.plot(beside, found, "o", color=RED, alpha=0.5, markersize=4)
        shares.append(f"{size}: {found.min():.2f} to {found.max():.2f}")
    ax.plot([], [], "o", color=RED, markersize=4, label="one estimate")
    ax.set_xscale("log")
    ax.set_xticks(sizes, [f"{size:,}" for size in sizes])
    ax.minorticks_off()
    ax.set_ylim(-0.03, 1.03)
    legend_below(figure, 3)
    figure.alt = f"{estimates} estimates each of a probability of {p:.2f}, by number of rows: {'; '.join(shares)}."
    return figure


def plot_counts(
    model: SampleModel, states: Sequence[str], actions: Sequence[str]
) -> Picture:
    """How often each pair was tried, as a table. states, actions: what they are called."""
    counts = model.pair_count
    figure = Picture(figsize=(1.6 + 1.35 * len(actions), 1.5 + 0.5 * len(states)))
    ax = figure.subplots()
    shown = np.ma.log10(np.ma.masked_equal(counts, 0))
    image = ax.imshow(shown, cmap="cividis", vmin=0, vmax=4.3, aspect="auto")
    for (s, a), count in np.ndenumerate(counts):
        if count:
            centred(ax, a, s, f"{count:,}", color="white" if count < 300 else BLACK)
        else:
            ax.add_patch(Rectangle((a - 0.5, s - 0.5), 1, 1, **NEVER))
            centred(
                ax,
                a,
                s,
                "never",
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 2},
            )
    ax.set_xticks(range(len(actions)), [plain(text) for text in actions])
    ax.set_yticks(range(len(states)), [plain(text) for text in states])
    ax.set(xlabel="action", ylabel="state")
    bar = figure.colorbar(image, ax=ax, ticks=range(5), label="times tried")
    bar.ax.set_yticklabels([f"{10**k:,}" for k in range(5)])
    figure.headline("How often each pair was tried")
    never = [f"{states[s]}, {actions[a]}" for s, a in np.argwhere(counts == 0)]
    figure.alt = (
        f"A table of {counts.shape[0]} states and {counts.shape[1]} actions with how often each pair was tried, from 1 "
        f"to {counts.max():,}; {np.count_nonzero(counts == 1)} were tried once. Never: {'; '.join(never) or 'none'}."
    )
    return figure


def plot_unknown(
    models: Mapping[str, SampleModel], s: int, actions: Sequence[str], place: str
) -> Picture:
    """What each action of state `s` is worth in several models of one recording; hatched: what was never tried there.

    models: by what an unseen pair does; actions, place: what the actions and the state are called
    """
    figure = Picture(figsize=(8.2, 3.1))
    told = []
    for ax, name, model in in_panels(figure, models, sharey=True, sharex=True):
        q, tried = value_iteration(model).q[s], model.pair_count[s] > 0
        best = int(q.argmax())
        for a, value in enumerate(q):
            look = (
                {"color": BLUE}
                if tried[a]
                else {"facecolor": "white", "edgecolor": RED, "hatch": "////"}
            )
            ax.barh(a, value, 0.7, **look)
            ax.text(
                value + 1, a, f"{value:.1f}{' ←' if a == best else ''}", va="center"
            )
        ax.set_title(plain(name), fontsize=11)
        ax.set(xlabel="Q*(s, a)", xlim=(0, 108))
        told.append(
            f"{name}: best is {actions[best]}, {'tried' if tried[best] else 'never tried'}, {q[best]:.1f}"
        )
    name_rows(figure.axes[0], actions)
    figure.headline(
        f"The best values {place}; blue: tried, hatched: never tried, ←: the best"
    )
    figure.alt = f"Bars of Q* of each action {place}, a panel for each treatment of unseen pairs. {'; '.join(told)}."
    return figure


def plot_capture(
    shares: np.ndarray, rewards: np.ndarray, recorded: float, block: int
) -> Picture:
    """How agents come to spend their time in a model's loops, and what that pays.

    shares, rewards: arrays (agents, blocks): share of the steps spent in loops, and mean reward, in blocks of `block`
    recorded: mean reward of the robot that was recorded
    """
    figure = Picture(figsize=(7.6, 3.3))
    left, right = figure.subplots(1, 2)
    t = block * np.arange(1, shares.shape[1] + 1)
    for ax, runs in ((left, 100 * shares), (right, rewards)):
        ax.plot(t, runs.T, color=BLUE, alpha=0.25, linewidth=1)
        ax.plot(
            t,
            runs.mean(axis=0),
            color=BLUE,
            linewidth=2.4,
            label=f"mean of {len(runs)} agents",
        )
        ax.set_xlabel("step in the model")
        ax.grid(alpha=0.3)
        ax.margins(x=0)
    left.set(ylabel="steps spent in suspect loops (%)", ylim=(-3, 103))
    right.axhline(
        recorded, color=RED, linestyle="--", label="the robot that was recorded"
    )
    right.set(ylabel="reward per step")
    right.legend(loc="lower right")
    figure.headline(
        f"Where the agents are, and what they earn there (means of {block} steps)"
    )
    figure.alt = (
        f"Two sets of curves of {len(shares)} agents. Steps spent in suspect loops: {shares[:, 0].mean():.0%} in the "
        f"first {block}, {shares[:, -1].mean():.0%} in the last. Reward per step: {rewards[:, 0].mean():.1f} at first, "
        f"{rewards[:, -1].mean():.1f} in the end; the recorded robot earned {recorded:.1f}."
    )
    return figure


def plot_gaps(gaps: Mapping[str, Gap], title: str) -> Picture:
    """What agents earn in the model and on the robot, a row a setting; their difference with its 95 % interval."""
    figure = Picture(figsize=(7.6, 1.3 + 0.55 * len(gaps)))
    ax, beside = figure.subplots(1, 2, sharey=True, width_ratios=(3, 2))
    told = []
    for row, (name, gap) in enumerate(gaps.items()):
        model, robot = gap.model.mean(), gap.robot.mean()
        ax.plot([robot, model], [row, row], color=GREY, linewidth=1.5, zorder=1)
        ax.plot(
            model,
            row,
            "o",
            color=BLUE,
            markersize=9,
            markerfacecolor="white",
            markeredgewidth=2,
        )
        ax.plot(robot, row, "s", color=RED, markersize=7)
        beside.errorbar(
            gap.mean,
            row,
            xerr=gap.half,
            fmt="D",
            color=BLACK,
            ecolor=ORANGE,
            elinewidth=3,
            markersize=5,
        )
        told.append(
            f"{name}: model {model:.1f}, robot {robot:.1f}, difference {gap.mean:.1f} ± {gap.half:.1f}"
        )
    ax.plot(
        [],
        [],
        "o",
        color=BLUE,
        markerfacecolor="white",
        markeredgewidth=2,
        label="in the model",
    )
    ax.plot([], [], "s", color=RED, label="on the robot")
    ax.set_yticks(range(len(gaps)), [plain(name) for name in gaps])
    ax.set_ylim(len(gaps) - 0.5, -0.5)
    ax.set(xlabel="reward per step")
    beside.axvline(0, color=GREY, linestyle=":")
    beside.set(xlabel="model less robot, 95 % interval")
    for each in (ax, beside):
        each.grid(alpha=0.3, axis="x")
    legend_below(figure, 2)
    figure.headline(title)
    figure.alt = f"{title}. Reward per step of the same agents. {'; '.join(told)}."
    return figure
