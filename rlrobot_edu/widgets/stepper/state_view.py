"""A state by its meaning: each input with its bins, the present one filled. For environments without a picture."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes

from rlrobot_edu.show.palette import BLUE
from rlrobot_edu.show.picture import plain
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.tape import Tape

MOST_BINS = 12  # an input with more is written as a number


class StateView:
    """The inputs of an environment, one a row."""

    heading = "The state, input by input"

    def __init__(self, names: Names) -> None:
        self._names = names

    def look(self, s: int) -> int:
        """The state."""
        return s

    def constant_data(self) -> dict[str, Any]:
        """Only its kind, because the page has the names."""
        return {"kind": "state"}

    def look_data(self, look: int) -> None:
        """None, because the number of the state is enough."""

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The present state only, on matplotlib axes."""
        names = self._names
        s = tape.looks()[-1]
        for row, (n, i) in enumerate(zip(names.shape, names.bins(s), strict=True)):
            if n <= MOST_BINS:
                _draw_bins(ax, row, n, i)
            else:
                ax.text(0, row, f"{i} of {n}", va="center")
        labels = []
        for name, reading in zip(names.inputs, names.readings(s), strict=True):
            labels.append(plain(f"{name}\n{reading}"))
        ax.set_yticks(range(len(labels)), labels, fontsize=8)
        most = min(max(names.shape), MOST_BINS)
        ax.set(xlim=(-0.1, most + 0.1), ylim=(len(labels) - 0.4, -0.6), xticks=[])
        ax.set_xlabel("bin")
        ax.spines[:].set_visible(False)


def _draw_bins(ax: Axes, row: int, n: int, i: int) -> None:
    """The n bins of an input in a row, with bin i filled."""
    ax.barh(
        row,
        [1] * n,
        left=range(n),
        height=0.6,
        color="white",
        edgecolor="black",
        linewidth=0.6,
    )
    ax.barh(row, 1, left=i, height=0.6, color=BLUE)
