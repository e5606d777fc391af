"""Sliders that change how an agent learns, and the learning curve that follows from it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import ipywidgets

from rlrobot_edu.experiments.compare import repeat
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.widgets.page_script import NamedHandles

# name of the parameter: its symbol, and its slider
_LINEAR, _LOGARITHMIC = ipywidgets.FloatSlider, ipywidgets.FloatLogSlider
_SLIDERS = {
    "alpha": (
        "α",
        _LINEAR,
        {"min": 0.01, "max": 1, "step": 0.01, "description": "α (alpha)"},
    ),
    "gamma": (
        "γ",
        _LINEAR,
        {"min": 0, "max": 0.99, "step": 0.01, "description": "γ (gamma)"},
    ),
    "lam": (
        "λ",
        _LINEAR,
        {"min": 0, "max": 0.99, "step": 0.01, "description": "λ (lambda)"},
    ),
    "temperature": (
        "temperature",
        _LOGARITHMIC,
        {"min": -1, "max": 2, "step": 0.1, "description": "temperature"},
    ),
}


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
        if (
            isinstance(parameters, str)
            or not parameters
            or not set(parameters) <= set(_SLIDERS)
        ):
            raise ValueError(
                f"parameters must be a list with some of {', '.join(_SLIDERS)}, got {parameters!r}"
            )
        # the same seed for every setting: only the setting differs
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
        self._method, self._defaults = method, self._run()
        defaults = Agent(world, method).parameters
        self._start = {
            name: getattr(defaults, name) for name in parameters
        }  # where the sliders stand first
        look = {
            "style": {"description_width": "max-content"},
            "layout": {"width": "32em", "max_width": "100%"},
        }
        self.sliders = {
            name: _SLIDERS[name][1](value=value, **_SLIDERS[name][2], **look)
            for name, value in self._start.items()
        }
        self._curves = ipywidgets.HTML(self.still().html)
        self.widget = ipywidgets.VBox(
            [NamedHandles(), *self.sliders.values(), self._curves]
        )
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
        mine = self._run(**settings)
        named = (", ".join(f"{_SLIDERS[name][0]} {value:.2g}" for name, value in chosen.items()) for chosen in
                 (settings, {name: self._start[name] for name in settings}))  # fmt: skip
        labels = [
            f"{prefix}: {text}"
            for prefix, text in zip(("yours", "defaults"), named, strict=True)
        ]
        return plot_learning(
            mine,
            self._defaults,
            labels=labels,
            title=f"{self._method} with your settings",
        )

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
        names = " and ".join(_SLIDERS[name][0] for name in self.sliders)
        return f"<{len(self.sliders)} sliders, {names}, and a learning curve>".replace(
            "1 sliders", "1 slider"
        )
