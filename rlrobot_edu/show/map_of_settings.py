"""A map of settings: what a method earns, over two of its parameters."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection

from rlrobot_edu.checks import check_name
from rlrobot_edu.show.palette import BLACK
from rlrobot_edu.show.style import SHADES_OF_WORTH

LABELS = {
    "alpha": "α, learning rate",
    "gamma": "γ, discount",
    "lam": "λ, decay of traces",
    "temperature": "T, temperature",
    "epsilon": "ε, exploration",
}
LOGARITHMIC = ("alpha", "temperature", "epsilon")


def plot_settings(
    ax: Axes,
    settings: Sequence[Mapping[str, Any]],
    earned: np.ndarray,
    x: str = "temperature",
    y: str = "alpha",
    **look: Any,
) -> PathCollection:
    """Draw a dot for each setting, coloured by what it earned: the best are dark, and drawn last.

    earned: array (settings,); x, y: names of parameters; look: arguments of matplotlib's `scatter`
    Raises ValueError if the settings have no such parameter.
    """
    for name in (x, y):
        check_name(name, list(settings[0]), "parameter", "these settings")
    order = np.argsort(earned)
    xs = [settings[i][x] for i in order]
    ys = [settings[i][y] for i in order]
    style: dict[str, Any] = {"cmap": SHADES_OF_WORTH, "s": 60, "edgecolors": BLACK}
    style.update({"linewidths": 0.4, **look})
    dots = ax.scatter(xs, ys, c=earned[order], **style)
    ax.set(xlabel=LABELS.get(x, x), ylabel=LABELS.get(y, y))
    if x in LOGARITHMIC:
        ax.set_xscale("log")
    if y in LOGARITHMIC:
        ax.set_yscale("log")
    return dots
