"""Two sliders that change how an agent learns, and the learning curve that follows from it."""

from __future__ import annotations

import base64

import ipywidgets

from rlrobot_edu.experiments.repeat import repeat
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.show.curves import plot_learning
from rlrobot_edu.show.picture import Picture


class ParameterSliders:
    """Learning curves on a sample model for a temperature and a λ that the reader sets, beside the defaults.

    model: the world to learn in; method: see `Agent`
    steps, repetitions: of each learning process; seed: the same for every setting, so that only the setting differs
    """

    def __init__(
        self, model: SampleModel, method: str = "TOSL+QBIASSR", steps: int = 3600, repetitions: int = 20, seed: int = 0
    ) -> None:
        if not isinstance(model, SampleModel):
            raise ValueError(f"the sliders need a SampleModel, which learns fast enough, not a {type(model).__name__}")
        self._run = lambda **settings: repeat(
            model, method, repetitions=repetitions, steps=steps, seed=seed, n_jobs=1, **settings
        )
        self._method, self._defaults = method, self._run()
        slider = {"continuous_update": False, "style": {"description_width": "7em"}, "layout": {"width": "30em"}}
        self.temperature = ipywidgets.FloatLogSlider(1.0, min=-1, max=2, step=0.1, description="temperature", **slider)
        self.lam = ipywidgets.FloatSlider(value=0.9, min=0, max=0.99, step=0.01, description="λ (lambda)", **slider)
        self._image = ipywidgets.Image(format="png", layout={"max_width": "585px"})
        self.widget = ipywidgets.VBox([self.temperature, self.lam, self._image])
        for control in (self.temperature, self.lam):
            control.observe(lambda _: self._draw(), "value")
        self._draw()

    def picture(self, temperature: float, lam: float) -> Picture:
        """The curves for these settings and for the defaults."""
        mine = self._run(temperature=temperature, lam=lam)
        labels = [f"temperature {temperature:.2g}, λ {lam:g}", "defaults: temperature 1, λ 0.9"]
        return plot_learning(mine, self._defaults, labels=labels, title=f"{self._method} with your settings")

    def _draw(self) -> None:
        picture = self.picture(self.temperature.value, self.lam.value)
        self._alt, self._image.value = picture.alt, picture.png()

    def _repr_mimebundle_(self, include=None, exclude=None) -> tuple[dict, dict]:
        # The picture is the still twin of the widget: it is what a saved notebook shows.
        still = base64.b64encode(self._image.value).decode("ascii")
        data = {**self.widget._repr_mimebundle_(), "text/plain": "<two sliders and a learning curve>"}
        return {**data, "image/png": still}, {"image/png": {"alt": self._alt}}
