"""The figures of lesson 13: the arm, the places that it can reach, an episode, and what many arms come to."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.patches import Circle

from rlrobot_course.figures.plots import (
    BLACK,
    BLUE,
    CURVES,
    ORANGE,
    RED,
    Picture,
    centred,
    chart,
    legend_below,
    plain,
)
from rlrobot_course.figures.runs import mean_and_half
from rlrobot_course.lesson_13.arm_figure import CONTACT
from rlrobot_course.worlds.arm_world import Places
from rlrobot_edu.robots.arm.arm_body import (
    OBJECT,
    OBJECT_PLACE,
)

TOLD = 24  # rewards that stand in a picture


def plot_places(places: Places, path: Sequence[int], title: str) -> Picture:
    """Every place that the gripper can reach, from above, coloured by its height; path: numbers of places, in order."""
    figure = Picture(figsize=(6.6, 5.8))
    ax = figure.subplots()
    x, y, z = np.array(
        [[seen[f"gripper_{axis}"] for axis in "xyz"] for seen in places.readings]
    ).T
    touches, look = (
        places.distance <= CONTACT,
        {"cmap": "cividis", "vmin": z.min(), "vmax": z.max(), "zorder": 3},
    )
    for these, sign, name in (
        (~touches, "o", "out of contact"),
        (touches, "s", "in contact"),
    ):
        dots = ax.scatter(
            x[these],
            y[these],
            c=z[these],
            marker=sign,
            s=40,
            edgecolors=BLACK,
            label=name,
            **look,
        )
    ax.add_patch(Circle(OBJECT_PLACE[:2], OBJECT[0], color=ORANGE, alpha=0.6, zorder=1))
    ax.add_patch(Circle((0, 0), 0.06, color=BLUE, alpha=0.6))
    centred(ax, 0, 0, "foot", color="white")
    ax.plot(
        x[path],
        y[path],
        color=RED,
        linewidth=1.6,
        label="way of the arm",
        zorder=4,
    )
    ax.plot(
        x[path[-2:]],
        y[path[-2:]],
        "D",
        color=RED,
        markersize=8,
        label="its last two places",
        zorder=5,
    )
    ax.set(
        xlabel="x (m), away from the foot",
        ylabel="y (m), to the left",
        aspect="equal",
    )
    figure.headline(title)
    ax.set_xlim(-0.08, 0.36)
    figure.colorbar(dots, ax=ax, label="height (m)")
    legend_below(figure, 2)
    figure.alt = (
        f"{len(x)} places from above, {touches.sum()} of them in contact with the object. The arm goes to and fro "
        f"between {' and '.join(f'x = {x[i]:.2f}, y = {y[i]:.2f} m' for i in path[-2:])}."
    )
    return figure


def plot_means(
    groups: Mapping[str, Mapping[str, np.ndarray]], ylabel: str, title: str
) -> Picture:
    """Means with their 95 % intervals. groups: values by the name of a method, by the name of a group"""
    figure, ax = chart((8, 3.4), "", ylabel, title, grid="y")
    told = []
    for k, (method, (colour, _), sign) in enumerate(
        zip(next(iter(groups.values())), CURVES, "os^", strict=False)
    ):
        means, halves = zip(
            *(mean_and_half(group[method]) for group in groups.values()), strict=True
        )
        x = np.arange(len(groups)) + 0.15 * (k - 1)
        ax.errorbar(
            x, means, halves, fmt=sign, color=colour, capsize=3, label=plain(method)
        )
        pairs = zip(groups, means, halves, strict=True)
        told.append(
            f"{method}: {', '.join(f'{name} {mean:.2f} ± {half:.2f}' for name, mean, half in pairs)}"
        )
    ax.set_xticks(range(len(groups)), list(groups))
    ax.margins(x=0.2)
    legend_below(figure, 3)
    figure.alt = f"{title}. {'. '.join(told)}."
    return figure


def plot_episode(distances: np.ndarray, rewards: np.ndarray, title: str) -> Picture:
    """The distance to the object before and after each step of an episode [m]; the first rewards as numbers."""
    figure, ax = chart(
        (9, 3.2), "step of the episode (1 s each)", "distance (cm)", title
    )
    ax.plot(
        distances * 100,
        color=BLUE,
        marker=".",
        label="distance of the gripper to the object",
    )
    ax.axhline(100 * CONTACT, color=RED, linestyle="--", label="5 cm: contact")
    for t, r in enumerate(rewards[:TOLD], start=1):
        shift = -13 if distances[t] < distances[t - 1] else 6
        at = (t, distances[t] * 100)
        ax.annotate(
            f"{r:g}",
            at,
            (0, shift),
            textcoords="offset points",
            ha="center",
            fontsize=8,
        )
    ax.set_ylim(0, 100 * distances.max() + 3)
    legend_below(figure, 2)
    half = len(rewards) // 2
    near, far = np.sort(distances[half:])[[0, -1]] * 100
    figure.alt = (
        f"Distance of the gripper to the object over {len(rewards)} steps, from {100 * distances[0]:.1f} cm. In the "
        f"second half it stays between {near:.1f} and {far:.1f} cm, with {np.mean(rewards[half:]):.2f} a step on "
        "average."
    )
    return figure


def heaps(values: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A dot for each value, in heaps: the middle of its bin, and its height in the heap from 1 on; arrays (n,)."""
    where = np.clip(
        np.searchsorted(edges, np.sort(values), side="right") - 1, 0, len(edges) - 2
    )
    height = np.array(
        [i - np.searchsorted(where, where[i]) + 1 for i in range(len(where))], dtype=int
    )
    return (edges[where] + edges[where + 1]) / 2, height


def plot_many(
    groups: Mapping[str, np.ndarray],
    edges: np.ndarray,
    xlabel: str,
    title: str,
    marks: Mapping[float, str] | None = None,
) -> Picture:
    """One row a group, one dot an arm, heaped where they are alike.

    groups: a value for each arm by the group's name; edges: of the heaps; marks: lines to compare with, and their names
    """
    figure = Picture(figsize=(8, 0.7 + 1.15 * len(groups)))
    rows = figure.subplots(len(groups), 1, sharex=True, sharey=True, squeeze=False)[
        :, 0
    ]
    told, highest = [], 0
    for ax, (name, values) in zip(rows, groups.items(), strict=True):
        x, height = heaps(np.asarray(values), edges)
        ax.plot(x, height, "o", color=BLUE, markersize=5)
        for mark in marks or {}:
            ax.axvline(mark, color=BLACK, linestyle=":", linewidth=1)
        ax.set_title(plain(name), loc="right", fontsize=10)
        highest = max(highest, height.max())
        ax.set_ylabel("arms")
        ax.grid(alpha=0.3, axis="y")
        near = "; ".join(
            f"{np.sum(np.abs(values - m) < 0.25)} near {m:g}" for m in marks or {}
        )
        told.append(
            f"{name}: {len(values)} arms from {min(values):.2f} to {max(values):.2f}{', ' * bool(near)}{near}"
        )
    for mark, text in (marks or {}).items():
        rows[0].text(mark, 1.0, plain(text), ha="center", va="bottom", fontsize=9,
                     transform=rows[0].get_xaxis_transform())  # fmt: skip
    rows[-1].set(xlabel=xlabel, ylim=(0, 1.12 * highest + 1))
    figure.headline(title)
    figure.alt = f"{title}. One dot an arm. {'. '.join(told)}."
    return figure
