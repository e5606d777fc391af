"""Sliders that change how an agent learns, and the learning curve that follows from it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from rlrobot_edu.experiments.compare import repeat
from rlrobot_edu.experiments.runs import Runs
from rlrobot_edu.experiments.statistics import mean_band
from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.widgets.page_script import NamedHandles


class Slider(NamedTuple):
    """The slider of a parameter: its symbol, its kind in ipywidgets, and the ends, step and name of its scale."""

    symbol: str
    kind: type[ipywidgets.FloatSlider | ipywidgets.FloatLogSlider]
    low: float
    high: float
    step: float
    name: str


_SLIDERS = {
    "alpha": Slider("α", ipywidgets.FloatSlider, 0.01, 1, 0.01, "α (alpha)"),
    "gamma": Slider("γ", ipywidgets.FloatSlider, 0, 0.99, 0.01, "γ (gamma)"),
    "lam": Slider("λ", ipywidgets.FloatSlider, 0, 0.99, 0.01, "λ (lambda)"),
    "temperature": Slider(
        "temperature", ipywidgets.FloatLogSlider, -1, 2, 0.1, "temperature"
    ),
}


@suggests_keywords
class ParameterSliders(Displayed):
    """Learning curves for parameters that the reader sets, compared with the defaults.

    Parameters
    ----------
    world : SampleModel
        Where to learn. A robot is not fast enough to follow a slider.
    method : str
        ``ALGORITHM+SELECTION``, see `Agent`.
    parameters : sequence of str
        Which of alpha, gamma, lam and temperature get a slider; `sliders` holds them by name.
    steps : int
        Length of each learning process.
    repetitions : int
        How many learning processes a curve averages.

    Raises
    ------
    ValueError
        For a world that is no SampleModel, and for an unknown parameter or method.
    """

    def __init__(
        self,
        world: SampleModel,
        method: str = "TOSL+QBIASSR",
        parameters: Sequence[str] = ("temperature", "lam"),
        *,
        steps: int = 3600,
        repetitions: int = 20,
    ) -> None:
        if not isinstance(world, SampleModel):
            raise ValueError(
                "sliders need a world that is fast enough to follow them, a SampleModel; "
                f"got a {type(world).__name__}"
            )
        is_list = bool(parameters) and not isinstance(parameters, str)
        if not is_list or not set(parameters) <= set(_SLIDERS):
            raise ValueError(
                f"parameters must be a list with some of {', '.join(_SLIDERS)}, got {parameters!r}"
            )
        # All settings have the same seed, so that only the settings differ.
        self._run = partial(
            repeat,
            world,
            method,
            repetitions=repetitions,
            steps=steps,
            seed=0,
            n_jobs=1,
            progress=False,
        )
        self._method = method
        self._defaults = self._run()
        defaults = Agent(world, method).parameters
        # The value of each slider at first
        self._start = {name: getattr(defaults, name) for name in parameters}
        self.sliders = {
            name: _new_slider(_SLIDERS[name], value)
            for name, value in self._start.items()
        }
        self._curves = ipywidgets.HTML(self.still().html)
        parts = [NamedHandles(), *self.sliders.values(), self._curves]
        self.widget = ipywidgets.VBox(parts)
        for slider in self.sliders.values():
            slider.observe(self._draw, "value")

    def picture(self, **settings: float) -> Picture:
        """The curves for these settings and for the defaults.

        Parameters
        ----------
        **settings : float
            Values of the parameters, by name.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.

        Raises
        ------
        ValueError
            If a value is out of its domain.
        """
        yours = self._run(**settings)
        start = {name: self._start[name] for name in settings}
        labels = ["yours", "defaults"]
        picture = plot_learning(
            yours,
            self._defaults,
            labels=labels,
            title=compared(yours, self._defaults, _in_symbols(settings)),
        )
        # from 0, so that a small difference looks small
        low, high = picture.axes[0].get_ylim()
        picture.axes[0].set_ylim(min(0, low), max(0, high))
        for label, values in zip(labels, (settings, start), strict=True):
            said = f"{label}: {_in_symbols(values)}"
            picture.alt = picture.alt.replace(f"{label} ends", f"{said} ends")
        return picture

    def still(self) -> Still:
        """The curves as they are now.

        Returns
        -------
        Still
            The picture and its description.
        """
        settings = {name: slider.value for name, slider in self.sliders.items()}
        return self.picture(**settings).still()

    def _draw(self, _: object) -> None:
        """Draw the curves of a slider's new value."""
        self._curves.value = self.still().html

    def __repr__(self) -> str:
        symbols = " and ".join(_SLIDERS[name].symbol for name in self.sliders)
        n = len(self.sliders)
        count = "1 slider" if n == 1 else f"{n} sliders"
        return f"<{count}, {symbols}, and a learning curve>"


def compared(yours: Runs, defaults: Runs, settings: str) -> str:
    """Whether these settings earn more or less than the defaults, or too little else to tell, as a sentence."""
    ends = [runs.curves[:, -1] for runs in (yours, defaults)]
    means = [float(end.mean()) for end in ends]
    difference = means[0] - means[1]
    half = 0.0
    if min(map(len, ends)) > 1:
        bands = [mean_band(end[:, None]) for end in ends]
        half = math.hypot(*(float(high[0] - low[0]) / 2 for low, high in bands))
    if difference == 0:
        return f"With {settings} the robot earns what it earns with the defaults"
    if abs(difference) <= half:
        return f"With {settings} the robot earns about what it earns with the defaults: too close to tell"
    side = "more" if difference > 0 else "less"
    return f"With {settings} the robot earns {abs(difference):.2f} a step {side} than with the defaults"


def _new_slider(slider: Slider, value: float) -> Any:
    return slider.kind(
        value=value,
        min=slider.low,
        max=slider.high,
        step=slider.step,
        description=slider.name,
        style={"description_width": "max-content"},
        layout={"width": "32em", "max_width": "100%"},
    )


def _in_symbols(settings: Mapping[str, float]) -> str:
    """Settings in words, such as ``temperature 3.2, λ 0.9``."""
    pairs = settings.items()
    return ", ".join(f"{_SLIDERS[name].symbol} {value:.2g}" for name, value in pairs)
