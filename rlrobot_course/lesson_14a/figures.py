"""The figures of lesson 14a: what a recording covers, what the unknown does, and the gap."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.colors import BoundaryNorm
from matplotlib.patches import Rectangle

from rlrobot_course.lesson_14a.worlds import Gap
from rlrobot_course.plots import BLACK, BLUE, GREY, ORANGE, VERMILION, Picture, name_rows, plain
from rlrobot_edu import SampleModel, value_iteration

NEVER = {"facecolor": "#e8e8e8", "edgecolor": GREY, "hatch": "///", "linewidth": 0.0}  # what was never tried


def plot_counts(model: SampleModel, states: Sequence[str], actions: Sequence[str]) -> Picture:
    """How often each pair was tried, as a table. states, actions: what they are called."""
    counts = model.pair_count
    figure = Picture(figsize=(1.6 + 1.35 * len(actions), 1.5 + 0.5 * len(states)))
    ax = figure.subplots()
    shown = np.ma.log10(np.ma.masked_equal(counts, 0))
    image = ax.imshow(shown, cmap="cividis", vmin=0, vmax=4.3, aspect="auto")
    for (s, a), count in np.ndenumerate(counts):
        if count:
            ax.text(a, s, f"{count:,}", ha="center", va="center", color="white" if count < 300 else BLACK)
        else:
            ax.add_patch(Rectangle((a - 0.5, s - 0.5), 1, 1, **NEVER))
            ax.text(a, s, "never", ha="center", va="center", bbox={"facecolor": "white", "edgecolor": "none", "pad": 2})
    ax.set_xticks(range(len(actions)), [plain(text) for text in actions])
    ax.set_yticks(range(len(states)), [plain(text) for text in states])
    ax.set(xlabel="action", ylabel="state")
    bar = figure.colorbar(image, ax=ax, ticks=range(5), label="times tried")
    bar.ax.set_yticklabels([f"{10**k:,}" for k in range(5)])
    ax.set_title("How often each pair was tried")
    never = [f"{states[s]}, {actions[a]}" for s, a in np.argwhere(counts == 0)]
    figure.alt = (
        f"A table of {counts.shape[0]} states and {counts.shape[1]} actions with how often each pair was tried, from 1 "
        f"to {counts.max():,}; {np.count_nonzero(counts == 1)} were tried once. Never: {'; '.join(never) or 'none'}."
    )
    return figure


def plot_coverage(model: SampleModel, names: Sequence[str]) -> Picture:
    """How many actions were tried in each state of five inputs, x0 to x4: a panel for each bin of x0.

    Large rows are bins of x1 and the small ones in them bins of x2; large columns are bins of x4, the small ones of x3:
    where x1 and x2 look to the left as x4 and x3 look to the right, the diagonal is the line of symmetry.
    names: of the inputs
    """
    tried = (model.pair_count > 0).sum(axis=1).reshape(model.shape)
    panels, rows, columns = model.shape[0], model.shape[1] * model.shape[2], model.shape[3] * model.shape[4]
    figure = Picture(figsize=(2.3 * panels, 3.1))
    axes = figure.subplots(1, panels, sharey=True)
    norm = BoundaryNorm(np.arange(0.5, model.n_actions + 1), 256)
    for k, ax in enumerate(axes):
        grid = tried[k].transpose(0, 1, 3, 2).reshape(rows, columns)
        ax.set_facecolor("#e8e8e8")
        image = ax.imshow(np.ma.masked_equal(grid, 0), cmap="cividis", norm=norm, origin="lower")
        edges = np.arange(model.shape[2], rows, model.shape[2]) - 0.5
        ax.hlines(edges, -0.5, columns - 0.5, color=GREY, linewidth=0.6)
        ax.vlines(np.arange(model.shape[3], columns, model.shape[3]) - 0.5, -0.5, rows - 0.5, color=GREY, linewidth=0.6)
        ax.set_xticks((np.arange(model.shape[4]) + 0.5) * model.shape[3] - 0.5, range(model.shape[4]))
        ax.set_yticks((np.arange(model.shape[1]) + 0.5) * model.shape[2] - 0.5, range(model.shape[1]))
        ax.set(xlabel=f"bin of {names[4]}\n(in it: {names[3]})", title=f"{names[0]}: bin {k}")
    axes[0].set_ylabel(f"bin of {names[1]}\n(in it: {names[2]})")
    figure.colorbar(image, ax=list(axes), ticks=range(1, model.n_actions + 1), label="actions tried")
    figure.suptitle("How many of its actions were tried in each state (grey: no action tried)")
    known = ", ".join(f"{np.count_nonzero(tried[k])} of {tried[k].size} with bin {k}" for k in range(panels))
    figure.alt = (
        f"{panels} maps of states, one for each bin of {names[0]}. States in which an action was tried: {known}. All "
        f"{model.n_actions} actions were tried in {np.count_nonzero(tried == model.n_actions)} of {tried.size}."
    )
    return figure


def plot_unknown(models: Mapping[str, SampleModel], s: int, actions: Sequence[str], place: str) -> Picture:
    """What each action of state `s` is worth in several models of one recording; hatched: what was never tried there.

    models: by what an unseen pair does; actions, place: what the actions and the state are called
    """
    figure = Picture(figsize=(8.2, 3.1))
    axes = figure.subplots(1, len(models), sharey=True, sharex=True)
    told = []
    for ax, (name, model) in zip(axes, models.items(), strict=True):
        q, tried = value_iteration(model).q[s], model.pair_count[s] > 0
        best = int(q.argmax())
        for a, value in enumerate(q):
            look = {"color": BLUE} if tried[a] else {"facecolor": "white", "edgecolor": VERMILION, "hatch": "////"}
            ax.barh(a, value, 0.7, **look)
            ax.text(value + 1, a, f"{value:.1f}{' ←' if a == best else ''}", va="center")
        ax.set_title(plain(name), fontsize=11)
        ax.set(xlabel="Q*(s, a)", xlim=(0, 108))
        told.append(f"{name}: best is {actions[best]}, {'tried' if tried[best] else 'never tried'}, {q[best]:.1f}")
    name_rows(axes[0], actions)
    figure.suptitle(plain(f"The best values {place}; blue: tried, hatched: never tried, ←: the best"))
    figure.alt = f"Bars of Q* of each action {place}, a panel for each treatment of unseen pairs. {'; '.join(told)}."
    return figure


def plot_capture(shares: np.ndarray, rewards: np.ndarray, recorded: float, block: int) -> Picture:
    """How agents come to spend their time in a model's loops, and what that pays.

    shares, rewards: arrays (agents, blocks): share of the steps spent in loops, and mean reward, in blocks of `block`
    recorded: mean reward of the robot that was recorded
    """
    figure = Picture(figsize=(7.6, 3.3))
    left, right = figure.subplots(1, 2)
    t = block * np.arange(1, shares.shape[1] + 1)
    for ax, runs in ((left, 100 * shares), (right, rewards)):
        ax.plot(t, runs.T, color=BLUE, alpha=0.25, linewidth=1)
        ax.plot(t, runs.mean(axis=0), color=BLUE, linewidth=2.4, label=f"mean of {len(runs)} agents")
        ax.set_xlabel("step in the model")
        ax.grid(alpha=0.3)
        ax.margins(x=0)
    left.set(ylabel="steps spent in suspect loops (%)", ylim=(-3, 103))
    right.axhline(recorded, color=VERMILION, linestyle="--", label="the robot that was recorded")
    right.set(ylabel="reward per step")
    right.legend(loc="lower right")
    figure.suptitle(f"Where the agents are, and what they earn there (means of {block} steps)")
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
        ax.plot(model, row, "o", color=BLUE, markersize=9, markerfacecolor="white", markeredgewidth=2)
        ax.plot(robot, row, "s", color=VERMILION, markersize=7)
        beside.errorbar(gap.mean, row, xerr=gap.half, fmt="D", color=BLACK, ecolor=ORANGE, elinewidth=3, markersize=5)
        told.append(f"{name}: model {model:.1f}, robot {robot:.1f}, difference {gap.mean:.1f} ± {gap.half:.1f}")
    ax.plot([], [], "o", color=BLUE, markerfacecolor="white", markeredgewidth=2, label="in the model")
    ax.plot([], [], "s", color=VERMILION, label="on the robot")
    ax.set_yticks(range(len(gaps)), [plain(name) for name in gaps])
    ax.set_ylim(len(gaps) - 0.5, -0.5)
    ax.set(xlabel="reward per step")
    beside.axvline(0, color=GREY, linestyle=":")
    beside.set(xlabel="model less robot, 95 % interval")
    for each in (ax, beside):
        each.grid(alpha=0.3, axis="x")
    figure.legend(loc="outside lower center", ncols=2)
    figure.suptitle(plain(title))
    figure.alt = f"{title}. Reward per step of the same agents. {'; '.join(told)}."
    return figure
