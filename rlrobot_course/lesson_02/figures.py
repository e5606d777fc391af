"""The figures of lesson 02: what counts of each reward, and how values spread from a goal through a grid."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke

from rlrobot_course.figures.plots import (
    BLUE,
    GREY,
    Picture,
    centred,
    draw_arrow,
)
from rlrobot_edu.show.palette import BLACK, LIGHT
from rlrobot_edu.show.style import DARK_FROM, SHADES_OF_WORTH

ARROWS = {
    0: (-1, 0),
    1: (0, 1),
    2: (1, 0),
    3: (0, -1),
}  # FrozenLake's actions: (columns to the right, rows down)


def plot_sweep(values: Sequence[np.ndarray], sweep: int, desc: np.ndarray) -> Picture:
    """The map of a grid world with its values after one of the sweeps.

    values: arrays (n_states,), the value of each state after 0, 1, 2 … sweeps, states row by row, at most 1
    desc: array (rows, columns) of bytes, FrozenLake's map: S start, F free, H hole, G goal
    """
    v = values[sweep]
    known = np.count_nonzero(v)
    figure = Picture((4.4, 4.9))
    figure.headline(
        f"After sweep {sweep}, {known} of {v.size} squares have a value",
        "colour and numbers: value V(s); hatched: holes",
    )
    draw_values(figure.subplots(), v, desc)
    counts = ", ".join(str(np.count_nonzero(each)) for each in values)
    figure.alt = (
        f"Map of {v.size} squares. After sweep {sweep}, {known} have a value, all near the goal. "
        f"After 0, 1, 2 … sweeps: {counts}."
    )
    return figure


def plot_returns(
    gathered: Mapping[str, Sequence[float]], gammas: Sequence[float], shown: int = 30
) -> Picture:
    """What is left of each reward in the return: a column a policy, a row a discount rate.

    gathered: the rewards of each policy, the next one first; shown: how many are drawn, the return has them all
    """
    figure = Picture((4.2 * len(gathered), 1.8 * len(gammas) + 0.7))
    returns = {gamma: returns_of(gathered, gamma) for gamma in gammas}
    figure.headline(
        how_far_apart(returns),
        f"grey: the first {shown} rewards; blue: what counts of each in the return G",
    )
    panels = figure.subplots(
        len(gammas), len(gathered), sharex=True, sharey=True, squeeze=False
    )
    said, k = [], np.arange(shown)
    for row, gamma in zip(panels, gammas, strict=True):
        for ax, (name, rewards) in zip(row, gathered.items(), strict=True):
            r = np.array(rewards)[:shown]
            ax.bar(k, r, color=LIGHT["line"])
            ax.bar(k, r * gamma**k, color=BLUE)
            total = returns[gamma][name]
            ax.set_title(f"{name}, γ = {gamma}: G = {total:.2f}")
            said.append(f"{name}, γ = {gamma}: {total:.2f}")
    for ax in panels[-1]:
        ax.set_xlabel("steps ahead, k")
    figure.alt = f"Bars of the first {shown} rewards, each with the part that counts in the return. {'; '.join(said)}."
    return figure


def returns_of(
    gathered: Mapping[str, Sequence[float]], gamma: float
) -> dict[str, float]:
    """The return of each policy, from all its rewards."""
    returns = {}
    for name, rewards in gathered.items():
        r = np.array(rewards)
        returns[name] = float(r @ gamma ** np.arange(len(r)))
    return returns


def how_far_apart(returns: Mapping[float, Mapping[str, float]]) -> str:
    """How far apart the returns of the policies are with each discount rate, as a sentence."""
    parts = []
    for gamma, of_each in returns.items():
        apart = max(of_each.values()) - min(of_each.values())
        parts.append(f"{apart:.2f} with γ = {gamma}")
    return f"The returns are apart by {', by '.join(parts)}"


def plot_ways(q: np.ndarray, desc: np.ndarray) -> Picture:
    """Map of a grid world with an arrow for every best action; where two are equally good, both are drawn.

    q: array (n_states, 4), FrozenLake's actions left, down, right, up; desc: see `plot_sweep`
    """
    figure = Picture(figsize=(5.4, 5.4))
    best = {
        s: np.flatnonzero(np.isclose(q[s], q[s].max()))
        for s in np.flatnonzero(np.isin(desc, [b"S", b"F"]))
    }
    figure.headline(
        uphill(q.max(axis=1), best, desc),
        "arrows: best actions; colour: value V(s); hatched: holes; G: the goal",
    )
    ax = figure.subplots()
    draw_values(ax, q.max(axis=1), desc, numbers=False)
    for s, actions in best.items():
        y, x = divmod(s, desc.shape[1])
        for a in actions:
            right, down = ARROWS[int(a)]
            head = (x + 0.45 * right, y + 0.45 * down)
            drawn = draw_arrow(ax, (x, y), head, "white", 2)
            drawn.arrow_patch.set_path_effects(
                [withStroke(linewidth=4, foreground="black")]
            )
    scale = figure.colorbar(ax.images[0], ax=ax, shrink=0.8)
    scale.outline.set_visible(False)
    scale.ax.set_title("V(s)")
    several = sum(len(actions) > 1 for actions in best.values())
    figure.alt = (
        f"The same map with an arrow for every best action. {several} of {len(best)} squares have more than one; holes "
        "are hatched, and the goal is in the lower right corner."
    )
    return figure


def uphill(v: np.ndarray, best: Mapping[int, np.ndarray], desc: np.ndarray) -> str:
    """How many best actions lead to the goal or to a square of higher value, as a sentence.

    v: array (n_states,); best: the best actions of each square
    """
    columns = desc.shape[1]
    rises = []
    for s, actions in best.items():
        for a in actions:
            right, down = ARROWS[int(a)]
            after = s + right + columns * down
            rises.append(desc.flat[after] == b"G" or v[after] > v[s])
    if all(rises):
        return f"All {len(rises)} best actions lead uphill in value"
    return f"{sum(rises)} of {len(rises)} best actions lead uphill in value"


def draw_values(
    ax: Axes, v: np.ndarray, desc: np.ndarray, numbers: bool = True
) -> None:
    """Draw the values `v`, array (n_states,), as colours on the map `desc`, and as numbers where they are not 0."""
    grid = v.reshape(desc.shape)
    ax.imshow(grid, cmap=SHADES_OF_WORTH, vmin=0, vmax=1)
    ax.set(xticks=[], yticks=[])
    for (y, x), square in np.ndenumerate(desc):
        if square == b"H" or (square == b"G" and not numbers):
            hatch = "////" if square == b"H" else ""
            end = Rectangle(
                (x - 0.5, y - 0.5),
                1,
                1,
                facecolor="white",
                edgecolor=GREY,
                hatch=hatch,
                linewidth=0,
            )
            ax.add_patch(end)
        if square in (b"S", b"G") and not grid[y, x]:
            centred(ax, x, y, square.decode(), color=BLACK, fontsize=11, weight="bold")
        elif numbers and grid[y, x]:
            colour = "white" if grid[y, x] > DARK_FROM else BLACK
            centred(
                ax, x, y, f"{grid[y, x]:.2f}".lstrip("0"), color=colour, fontsize=8.5
            )
