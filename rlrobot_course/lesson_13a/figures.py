"""The figures of lesson 13a: an episode, and what many arms come to."""

from collections.abc import Mapping

import numpy as np

from rlrobot_course.plots import BLACK, BLUE, CURVES, VERMILION, Picture, chart, plain

CONTACT = 0.05  # [m]


def plot_episode(distances: np.ndarray, rewards: np.ndarray, title: str, told: int = 24) -> Picture:
    """The distance to the object before and after each step of an episode [m]; the first rewards as numbers."""
    figure, ax = chart((9, 3.2), "step of the episode (1 s each)", "distance (cm)", title)
    ax.plot(distances * 100, color=BLUE, marker=".", label="distance of the gripper to the object")
    ax.axhline(100 * CONTACT, color=VERMILION, linestyle="--", label="5 cm: contact")
    for t, r in enumerate(rewards[:told], start=1):
        shift = -13 if distances[t] < distances[t - 1] else 6
        at = (t, distances[t] * 100)
        ax.annotate(f"{r:g}", at, (0, shift), textcoords="offset points", ha="center", fontsize=8)
    ax.set_ylim(0, 100 * distances.max() + 3)
    figure.legend(loc="outside lower center", ncols=2)
    near, far = np.sort(distances[len(distances) // 2 :])[[0, -1]] * 100
    figure.alt = (
        f"Distance of the gripper to the object over {len(rewards)} steps, from {100 * distances[0]:.1f} cm. In the "
        f"second half it stays between {near:.1f} and {far:.1f} cm, with {np.mean(rewards):.2f} a step on average."
    )
    return figure


def heaps(values: np.ndarray, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A dot for each value, in heaps: the middle of its bin, and its height in the heap from 1 on; arrays (n,)."""
    where = np.clip(np.searchsorted(edges, np.sort(values), side="right") - 1, 0, len(edges) - 2)
    height = np.array([i - np.searchsorted(where, where[i]) + 1 for i in range(len(where))], dtype=int)
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
    rows = figure.subplots(len(groups), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    told, highest = [], 0
    for ax, (name, values), (colour, _), sign in zip(rows, groups.items(), CURVES, "os^Dv<>", strict=False):
        x, height = heaps(np.asarray(values), edges)
        ax.plot(x, height, sign, color=colour, markersize=5)
        for mark in marks or {}:
            ax.axvline(mark, color=BLACK, linestyle=":", linewidth=1)
        ax.set_title(plain(name), loc="right", fontsize=10)
        highest = max(highest, height.max())
        ax.set_ylabel("arms")
        ax.grid(alpha=0.3, axis="y")
        near = "; ".join(f"{np.sum(np.abs(values - m) < 0.25)} near {m:g}" for m in marks or {})
        told.append(f"{name}: {len(values)} arms from {min(values):.2f} to {max(values):.2f}{', ' * bool(near)}{near}")
    for mark, text in (marks or {}).items():
        rows[0].text(mark, 1.0, plain(text), ha="center", va="bottom", fontsize=9,
                     transform=rows[0].get_xaxis_transform())  # fmt: skip
    rows[-1].set(xlabel=xlabel, ylim=(0, 1.12 * highest + 1))
    figure.suptitle(plain(title), fontsize=11)
    figure.alt = f"{title}. One dot an arm. {'. '.join(told)}."
    return figure
