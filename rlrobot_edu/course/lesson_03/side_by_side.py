"""Learning curves in several panels that share their labels: one panel a world, one curve a method."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.picture import Picture

if TYPE_CHECKING:
    from rlrobot_edu.learning.history import History


def plot_side_by_side(
    panels: Mapping[str, Sequence[Sequence[History]]], labels: Sequence[str], title: str, columns: int = 2
) -> Picture:
    """Panels of learning curves, `columns` in a row, all with the same axis of rewards.

    panels: title of a panel -> for each label the repetitions to average, see `plot_learning`; as the repetitions of
        panels may differ in number, that number belongs in the panel's title
    """
    rows = -(-len(panels) // columns)
    figure, told = Picture(figsize=(8.5, 1 + 2.6 * rows), layout="constrained"), []
    axes = figure.subplots(rows, columns, sharey=True, squeeze=False)
    for ax, (name, groups) in zip(axes.flat, panels.items(), strict=True):
        plot_learning(*groups, labels=labels, ax=ax, title=name)
        ax.get_legend().remove()
        if ax is not axes[ax.get_subplotspec().rowspan.start, 0]:
            ax.set_ylabel("")
        ends = [np.mean([history.average_reward[-1] for history in group]) for group in groups]
        told.append(f"{name}: " + ", ".join(f"{label} {end:.2f}" for label, end in zip(labels, ends, strict=True)))
    # the bands of the first steps are as wide as the rewards themselves; the means decide what is shown
    means = np.concatenate([line.get_ydata() for ax in figure.axes for line in ax.lines])
    axes[0, 0].set_ylim(means.min() - 0.1 * np.ptp(means), means.max() + 0.1 * np.ptp(means))
    figure.suptitle(title)
    note = "means, and bands of their 95 % intervals"
    figure.legend(axes[0, 0].lines, labels, loc="outside lower center", ncols=len(labels), title=note)
    figure.alt = f"Learning curves, average reward at the end. {'; '.join(told)}."
    return figure
