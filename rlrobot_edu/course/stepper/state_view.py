"""A state by its meaning: each input with its bins, the present one filled. For environments without a picture."""

from __future__ import annotations

import html

from matplotlib.axes import Axes

from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.show.palette import BLUE
from rlrobot_edu.show.picture import plain

MOST_BINS = 12  # an input with more is written as a number


class StateView:
    """The inputs of an environment, one a row."""

    heading = "The state, input by input"
    wide = False

    def __init__(self, names: Names) -> None:
        self._names = names

    def look(self, s: int) -> int:
        """The state."""
        return s

    def html(self, tape: Tape) -> str:
        """A strip of bins for each input, the present one filled, the one before framed."""
        looks = tape.looks()
        s, before = looks[-1], looks[-2] if len(looks) > 1 else looks[-1]
        names, rows = self._names, []
        columns = zip(names.inputs, names.shape, names.bins(s), names.bins(before), names.readings(s), strict=True)
        for name, n, i, i_before, reading in columns:
            strip = f"{i} of {n}"
            if n <= MOST_BINS:
                kinds = ["now" if k == i else "was" if k == i_before else "" for k in range(n)]
                strip = "".join(f'<i class="{kind}"></i>' for kind in kinds)
            rows.append(f"<tr><th>{html.escape(name)}</th><td>{strip}</td><td>{html.escape(reading)}</td></tr>")
        return f'<p class="big">state {s}</p><table class="bins">{"".join(rows)}</table>'

    def draw(self, ax: Axes, tape: Tape) -> None:
        """The present state only, on matplotlib axes."""
        names, s = self._names, tape.looks()[-1]
        for row, (n, i) in enumerate(zip(names.shape, names.bins(s), strict=True)):
            if n <= MOST_BINS:
                ax.barh(row, [1] * n, left=range(n), height=0.6, color="white", edgecolor="black", linewidth=0.6)
                ax.barh(row, 1, left=i, height=0.6, color=BLUE)
            else:
                ax.text(0, row, f"{i} of {n}", va="center")
        labels = [plain(f"{name}\n{reading}") for name, reading in zip(names.inputs, names.readings(s), strict=True)]
        ax.set_yticks(range(len(labels)), labels, fontsize=8)
        ax.set(xlim=(-0.1, min(max(names.shape), MOST_BINS) + 0.1), ylim=(len(labels) - 0.4, -0.6), xticks=[])
        ax.set_xlabel("bin")
        ax.spines[:].set_visible(False)
