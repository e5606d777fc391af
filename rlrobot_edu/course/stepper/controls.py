"""The controls of the stepper: buttons, how fast it plays, and where to go."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import ipywidgets

SPEEDS = (0.5, 1, 2, 5, 10, 20, 30)  # steps a second
FAR = 10_000  # steps; so far ahead of the last one the jump field may go, for a jump cannot be interrupted


def _button(text: str, tip: str, name: str, width: str = "80px") -> ipywidgets.Button:
    """A button that the page's style and keyboard know as ``rl-name``."""
    button = ipywidgets.Button(description=text, tooltip=tip, layout={"width": width})
    button.add_class(f"rl-{name}")
    return button


class Controls:
    """What a reader moves; what it does is for the stepper to say.

    buttons: first, back, step, play and last, as they stand in `row`, with speed and field; slider: below it
    """

    def __init__(self) -> None:
        self.buttons = (
            _button("|◀ First", "Go to the earliest step that is kept (Home)", "first"),
            _button("◀ Back", "Show the step before (left arrow)", "back"),
            _button("Step ▶", "Show the next step (right arrow)", "step"),
            _button("", "Go on by itself, or stop (space)", "play", "90px"),
            _button("Last ▶|", "Go to the last step that the agent has taken (End)", "last"),
        )
        self.play = self.buttons[3]
        self._showing = False  # field and slider are being set to what is shown, nobody moved them
        self.say_playing(False)
        self.speed = ipywidgets.SelectionSlider(
            options=[(f"{speed:g} steps/s", speed) for speed in SPEEDS], value=2, description="speed",
            tooltip="How many steps a second it plays", layout={"width": "260px"},
        )  # fmt: skip
        self.field = ipywidgets.BoundedIntText(
            description="go to step", min=0, max=FAR, layout={"width": "165px"},
            tooltip=f"Number of a step, then Enter; the agent takes the steps up to there, {FAR} at most",
        )  # fmt: skip
        self.slider = ipywidgets.IntSlider(
            description="step", min=0, max=1, value=0, layout={"width": "98%"}, tooltip="The steps that are kept"
        )
        wrap = {"flex_flow": "row wrap", "align_items": "center"}
        self.row = ipywidgets.HBox([*self.buttons, self.speed, self.field], layout=wrap)

    def on_move(self, go: Callable[[int], None]) -> None:
        """Call `go` with the step to which the reader moves the field or the slider."""

        def moved(change: dict[str, Any]) -> None:
            if not self._showing:
                go(change["new"])

        for control in (self.field, self.slider):
            control.observe(moved, "value")

    def show(self, first: int, last: int, t: int) -> None:
        """Stand at step `t` of those from the first that is kept to the last that was taken."""
        self._showing = True
        try:
            for control, end in ((self.slider, last), (self.field, last + FAR)):
                with control.hold_trait_notifications():
                    control.min, control.max, control.value = first, end, t
        finally:
            self._showing = False

    def say_playing(self, playing: bool) -> None:
        """Name what the play button does next."""
        self.play.description = "‖ Pause" if playing else "▶▶ Play"
