"""The trace lab as a still: the cells after the last step of the path."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    Picture,
    centred,
    draw_lattice,
)
from rlrobot_course.trace_lab.kernels import (
    online_lambda_return,
    sarsa_lambda,
    true_online,
)
from rlrobot_edu.show.numerals import with_minus

BARS, FOOT = 0.42, 0.14  # height of the bars; from a cell's middle down to their foot
WIDE = 0.24


def plot_lab(feed: Mapping[str, Any]) -> Picture:
    """What each cell has learned at the end of the path. feed: what the lab is given, see `trace_lab`."""
    e, q, ideal, delta = learned(feed)
    kind, path, cells = feed["kinds"][feed["kind"]], feed["path"], feed["cells"]
    way = " ".join(cells[cell] for cell in path)
    traces = kind if kind == "true online" else f"{kind} traces"
    compared = "; dashed: the ideal’s Q" if feed["againstIdeal"] else ""
    note = (
        f"the way {way}, {traces}, α = {feed['alpha']:g}, γ = λ = {feed['decay']:g}; "
        f"left: the trace e, right: Q{compared}"
    )
    figure = Picture((8.4, 6.2))
    finding = about_the_step(feed, e[-1], delta[-1])
    if feed["againstIdeal"]:
        finding = about_the_gap(feed, q[-1], ideal[-1])
    figure.headline(finding, note)
    ax, below = figure.subplots(2, 1, height_ratios=(4, 1))
    _draw_cells(ax, feed, e[-1], q[-1], ideal[-1])
    _draw_curve(below, feed, e, q, ideal)
    visited = [cell for cell in range(len(cells)) if cell in path[:-1]]
    numbers = [
        f"{cells[cell]}: e {e[-1, cell]:.2f}, Q {with_minus(q[-1, cell], 2)}"
        for cell in visited
    ]
    figure.alt = f"A path over a grid, {way}. {figure.finding}. {'; '.join(numbers)}."
    return figure


def _draw_cells(
    ax: Axes, feed: Mapping[str, Any], e: np.ndarray, q: np.ndarray, ideal: np.ndarray
) -> None:
    """The grid, the path, and the bars of each cell after the last step."""
    path = feed["path"]
    draw_lattice(ax, (feed["rows"], feed["columns"]))
    ax.set(aspect="auto", xticks=[], yticks=[])
    places = [divmod(cell, feed["columns"])[::-1] for cell in path]
    ax.plot(*zip(*places, strict=True), color=GREY, linewidth=9, alpha=0.3, zorder=0)
    lowest, highest = min(0, q.min(), ideal.min()), max(0, q.max(), ideal.max())
    for cell, name in enumerate(feed["cells"]):
        x, y = cell % feed["columns"], cell // feed["columns"]
        ax.text(x - 0.44, y - 0.36, name, va="center", weight="bold")
        if feed["pays"][cell]:
            paid = with_minus(feed["pays"][cell])
            colour = GREEN if feed["pays"][cell] > 0 else RED
            ax.text(x + 0.44, y - 0.36, f"pays {paid}", ha="right", va="center", color=colour)  # fmt: skip
        if cell not in path[:-1]:
            continue
        _bar(ax, x - 0.23, y + FOOT, -BARS * e[cell] / max(1.0, e.max()), ORANGE)
        centred(ax, x - 0.23, y + 0.25, f"e = {e[cell]:.2f}")
        scale = BARS / (highest - lowest)
        zero = y + FOOT + scale * lowest
        _bar(ax, x + 0.23, zero, -scale * q[cell], BLUE if q[cell] >= 0 else RED)
        centred(ax, x + 0.23, y + 0.25, f"Q = {with_minus(q[cell], 2)}")
        if feed["againstIdeal"]:
            frame = (x + 0.23 - WIDE / 2 - 0.02, zero), WIDE + 0.04, -scale * ideal[cell]  # fmt: skip
            ax.add_patch(Rectangle(*frame, fill=False, edgecolor=BLACK, linestyle="--"))
            centred(ax, x + 0.23, y + 0.4, f"ideal {with_minus(ideal[cell], 2)}")


def _draw_curve(
    ax: Axes, feed: Mapping[str, Any], e: np.ndarray, q: np.ndarray, ideal: np.ndarray
) -> None:
    """Q of the cell that is left most often, over the steps, and the ideal's; without the ideal its trace."""
    left = feed["path"][:-1]
    watched = max(left, key=left.count)
    name = "Q" if feed["againstIdeal"] else "e"
    ax.set_title(f"{name}({feed['cells'][watched]}) at each step", loc="left")
    ax.margins(x=0.02)
    ax.set_xticks(range(len(feed["path"])))
    if feed["againstIdeal"]:
        ax.plot(ideal[:, watched], color=GREY, linewidth=7, alpha=0.4)
        ax.plot(q[:, watched], color=BLUE, marker="o", markersize=4)
    else:
        ax.plot(e[:, watched], color=ORANGE, marker="o", markersize=4)


def learned(feed: Mapping[str, Any]) -> tuple[np.ndarray, ...]:
    """Traces, values and the ideal's values after each step, arrays (n + 1, n_cells), and the TD errors (n + 1,)."""
    path = np.array(feed["path"])
    rewards = np.array(feed["pays"])[path[1:]]
    shape = len(path), len(feed["cells"])
    q, e, ideal = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    delta, q_old = np.zeros(len(path)), np.zeros(len(path))
    settings = path, rewards, feed["alpha"], feed["decay"], feed["decay"]
    kind = feed["kinds"][feed["kind"]]
    if kind == "true online":
        true_online(q, e, delta, q_old, *settings, 1, 1)
    else:
        sarsa_lambda(q, e, delta, *settings, int(kind == "accumulating"))
    online_lambda_return(ideal, *settings)
    return e, q, ideal, delta


def about_the_step(feed: Mapping[str, Any], e: np.ndarray, delta: float) -> str:
    """Whom the last step teaches, as the lab says it. e: traces as it uses them, array (n_cells,); delta: its error"""
    changes = feed["alpha"] * delta * e
    taught = np.flatnonzero(changes)
    most, least = taught[changes[taught].argmax()], taught[changes[taught].argmin()]
    cells = feed["cells"]
    return (
        f"Step {len(feed['path']) - 1} teaches {len(taught)} cells: {cells[most]} most, +{changes[most]:.2f}, "
        f"and {cells[least]} least, +{changes[least]:.2f}"
    )


def about_the_gap(feed: Mapping[str, Any], q: np.ndarray, ideal: np.ndarray) -> str:
    """How far the values are from the ideal, as the lab says it. q, ideal: arrays (n_cells,)"""
    kind = feed["kinds"][feed["kind"]].capitalize()
    gaps = q - ideal
    cell = int(np.abs(gaps).argmax())
    if abs(gaps[cell]) < 1e-9:
        return f"{kind} is the ideal, in every cell"
    side = "above" if gaps[cell] > 0 else "below"
    visits = feed["path"][:-1].count(cell)
    return f"{kind} traces: Q of {feed['cells'][cell]}, left {visits} times, is {abs(gaps[cell]):.1f} {side} the ideal"


def _bar(ax: Axes, x: float, foot: float, height: float, colour: str) -> None:
    ax.add_patch(Rectangle((x - WIDE / 2, foot), WIDE, height, color=colour))
