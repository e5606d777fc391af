"""The controls of the stepper: buttons, the speed, and two ways to choose a step."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import ipywidgets

from rlrobot_edu.course.stepper.tape import Tape

SPEEDS = (0.5, 1, 2, 5, 10, 20, 30)  # steps a second

# name of a button: its text, what it says to the mouse, and its width
_BUTTONS = {
    "first": ("|◀ First", "Go to the earliest step that is kept (Home)", "80px"),
    "back": ("◀ Back", "Show the step before (left arrow)", "80px"),
    "step": ("Step ▶", "Show the next step (right arrow)", "80px"),
    "play": ("▶▶ Play", "Go on by itself, or stop (space)", "90px"),
    "last": ("Last ▶|", "Go to the last step that the agent has taken (End)", "80px"),
}


class Controls:
    """The buttons and sliders for the reader; `widgets` are their two rows.

    press: for each button, by name, what a click does; jump: called with the number of a step that was chosen
    """

    def __init__(self, press: Mapping[str, Callable[[], None]], jump: Callable[[int], None]) -> None:
        self._jump = jump
        self._showing = False  # the controls are being set to what is shown, nobody moved them
        self.buttons = {name: _button(name, press[name]) for name in _BUTTONS}
        self.speed = ipywidgets.SelectionSlider(
            options=[(f"{speed:g} steps/s", speed) for speed in SPEEDS], value=2, description="speed",
            tooltip="How many steps a second it plays", layout={"width": "260px"},
        )  # fmt: skip
        self.field = ipywidgets.IntText(
            description="go to step", layout={"width": "175px"},
            tooltip="Number of a step, then Enter; the agent takes the steps up to there, and Pause stops it",
        )  # fmt: skip
        self.slider = ipywidgets.IntSlider(
            description="step", min=0, max=1, value=0, layout={"width": "98%"}, tooltip="The steps that are kept"
        )
        for control in (self.field, self.slider):
            control.observe(self._moved, "value")
        row = {"flex_flow": "row wrap", "align_items": "center"}
        above = ipywidgets.HBox([*self.buttons.values(), self.speed, self.field], layout=row)
        self.widgets = (above, self.slider)

    def show(self, tape: Tape) -> None:
        """Bring field and slider in line with the position of `tape`."""
        self._showing = True
        try:
            self.slider.max = tape.end
            self.slider.value = tape.t
            self.slider.min = tape.first  # last, or else the page would move a value that is now too low, and say so
            self.field.value = tape.t
        finally:
            self._showing = False

    def say_playing(self, playing: bool) -> None:
        """The play button says what a click on it would do."""
        self.buttons["play"].description = "‖ Pause" if playing else "▶▶ Play"

    def _moved(self, change: dict[str, Any]) -> None:
        if not self._showing:
            self._jump(change["new"])


def _button(name: str, press: Callable[[], None]) -> ipywidgets.Button:
    text, tooltip, width = _BUTTONS[name]
    button = ipywidgets.Button(description=text, tooltip=tooltip, layout={"width": width})
    button.add_class(f"rl-{name}")
    button.on_click(lambda _: press())
    return button
