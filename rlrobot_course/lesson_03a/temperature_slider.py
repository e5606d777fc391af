"""What the temperature does to the probabilities of a softmax: curves, bars, and a slider."""

from collections.abc import Sequence

import ipywidgets
import numpy as np

from rlrobot_course.plots import BLACK, CURVES, Picture
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.widgets.kernels import probabilities
from rlrobot_edu.widgets.live_picture import LivePicture
from rlrobot_edu.widgets.page_script import NamedHandles

MIN_EXPONENT, MAX_EXPONENT = -1, 3  # of ten: temperatures from 0.1 to 1000


def plot_temperature(x: Sequence[float], temperature: float) -> Picture:
    """Left: the probability of each action over the temperature. Right: the same at `temperature`, as bars.

    x: preferences, array (n_actions,), at most seven of them
    """
    figure = Picture(figsize=(9, 3.6))
    left, right = figure.subplots(1, 2, width_ratios=(3, 2), sharey=True)
    grid = np.logspace(MIN_EXPONENT, MAX_EXPONENT, 200)
    curves = np.array([probabilities(x, t) for t in grid])
    now = probabilities(x, temperature)
    for a, (colour, dashes) in zip(range(len(x)), CURVES, strict=False):
        label = f"action {a}, x = {x[a]:g}"
        left.semilogx(grid, curves[:, a], color=colour, linestyle=dashes, linewidth=2, label=label)
        right.bar(a, now[a], color=colour, width=0.7)
        right.text(a, now[a] + 0.01, f"{now[a]:.3f}", ha="center", va="bottom")
    left.axvline(temperature, color=BLACK, linewidth=1, linestyle=":")
    box = {"facecolor": "white", "edgecolor": "none", "pad": 1}
    left.text(temperature, 1.06, f"T = {temperature:.3g}", va="bottom", ha="center", bbox=box)
    left.set(xlabel="temperature T (logarithmic)", ylabel="probability P(a)", ylim=(0, 1.15), xlim=(grid[0], grid[-1]))
    left.grid(alpha=0.3)
    left.legend(fontsize=9, loc="center right")
    right.set(xlabel="action", xticks=range(len(x)), title=f"At T = {temperature:.3g}")
    left.set_title("The same preferences, from cold to hot", pad=12)
    told = ", ".join(f"action {a} {p:.3f}" for a, p in enumerate(now))
    figure.alt = (
        f"Probability of each action over the temperature: near the best action alone when cold, all alike when hot. "
        f"At T = {temperature:.3g}: {told}."
    )
    return figure


class TemperatureSlider(Displayed):
    """A slider for the temperature, and the probabilities that follow from it.

    x: preferences, array (n_actions,); temperature: where the slider stands first, 0.1 to 1000
    """

    def __init__(self, x: Sequence[float], temperature: float = 1.0) -> None:
        self._x = x
        self.slider = ipywidgets.FloatLogSlider(
            value=temperature, min=MIN_EXPONENT, max=MAX_EXPONENT, step=0.1, readout_format=".3g",
            description="temperature T", style={"description_width": "max-content"},
            layout={"width": "36em", "max_width": "100%"},
        )  # fmt: skip
        self._image = LivePicture(lambda: plot_temperature(self._x, self.slider.value))
        self.widget = ipywidgets.VBox([NamedHandles(), self.slider, self._image.widget])
        self.slider.observe(lambda _: self._image.update(), "value")

    def still(self) -> Still:
        """The curves and bars as they are now."""
        return self._image.still()

    def __repr__(self) -> str:
        return f"<a slider for the temperature, and the probabilities of {len(self._x)} actions>"
