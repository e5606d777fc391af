"""A robot driven by hand: buttons, keys and its picture; the steps are a recording."""

from __future__ import annotations

import html
from collections import deque
from functools import cached_property, partial
from typing import Any, cast

import numpy as np

from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.learning.size import Env
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import THIS_COMPUTER, Source
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import robot_of
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.painting.room import painted
from rlrobot_edu.widgets.driving.keys import ARROWS, Button, buttons_of, keys_of
from rlrobot_edu.widgets.driving.page import Keyboard
from rlrobot_edu.widgets.room_picture import RoomPicture

LAST = 60  # steps that a saved notebook keeps


def teleoperate(env: Env) -> Pad:
    """Drive a robot by hand, with buttons or keys, and record the steps.

    Parameters
    ----------
    env : gymnasium.Env
        An environment with a robot, see `make_env`.

    Returns
    -------
    Pad
        What a notebook shows; ``pad.recording`` has the steps, for `learn_from`, `Recording.save`, or a model.

    Raises
    ------
    ValueError
        If the environment has no robot.
    """
    return Pad(env)


class Pad(Displayed):
    """The robot of `env`, driven by a person; each press is one step of its task."""

    def __init__(self, env: Env) -> None:
        self._robot = robot_of(env)
        self._task = cast(RobotEnv, env.unwrapped).task
        self._env = env
        self._state_number = state_numbers(env)
        self._rows: list[list[Any]] = []
        self._driven = deque[tuple[Scene, float]](maxlen=LAST)
        self._begin()

    def __repr__(self) -> str:
        return f"<{self._task.name}, driven by hand: {len(self._rows)} steps>"

    def __len__(self) -> int:
        return len(self._rows)

    def press(self, a: int) -> float:
        """Let the robot do one action.

        Parameters
        ----------
        a : int
            Number of the action, 0 to n_actions − 1.

        Returns
        -------
        float
            The reward.
        """
        if self._ended:
            self._begin()
        observation, r, terminated, truncated, _ = self._env.step(a)
        s_next = self._state_number(observation)
        self._rows.append([self._s, a, float(r), s_next, terminated, truncated])
        self._s = s_next
        self._ended = terminated or truncated
        scene = self._robot.scene()
        self._driven.append((scene, float(r)))
        self._way.append((scene, float(r)))
        return float(r)

    def start_again(self) -> None:
        """Put the robot back to its start; the episode so far is kept."""
        if self._rows:
            *_, terminated, truncated = self._rows[-1]
            self._rows[-1][-1] = truncated or not terminated
        self._begin()

    @property
    def recording(self) -> Recording:
        """All steps so far. Raises ValueError before the first step."""
        if not self._rows:
            raise ValueError("nothing has been driven yet: press a button first")
        transitions = Transitions.of_rows(self._rows)
        source = Source.of_task(self._task, method="by hand", **THIS_COMPUTER)
        return Recording(transitions, source, self._task)

    @property
    def film(self) -> Film:
        """The last steps, at most 60, as a film. Raises ValueError before the first step."""
        if not self._driven:
            raise ValueError("nothing has been driven yet: press a button first")
        return Film.of(self._driven)

    @cached_property
    def widget(self) -> ipywidgets.HBox:
        """Buttons, keys and picture."""
        self._said = ipywidgets.HTML()
        self._picture = RoomPicture(self._task)
        keys = keys_of(self._task)
        told = "those in brackets"
        if ARROWS.keys() <= keys.keys():
            told += ", and the arrows"
        self._keyboard = Keyboard(actions=keys, told=told)
        again = ipywidgets.Button(
            description="start again",
            icon="undo",
            tooltip="Put the robot back to its start",
        )
        again.on_click(self._pressed_again)
        # As wide as its buttons, and wider if there is room, so that the picture fits beside it on a narrow page, too
        side = ipywidgets.VBox(
            [self._grid(), again, self._keyboard, self._said],
            layout={"flex": "1 1 190px", "max_width": "22em"},
        )
        side.layout.min_width = "min-content"
        widget = ipywidgets.HBox(
            [side, self._picture], layout={"flex_flow": "row wrap", "grid_gap": "12px"}
        )
        self._show("nothing driven yet")
        widget.add_class("rl-drive")
        widget.add_class("rl-look")
        return widget

    def still(self) -> Still:
        """The last steps as a film, or the robot at its start."""
        if self._driven:
            return self.film.still()
        return painted([self._robot.scene()])

    def _begin(self) -> None:
        observation, _ = self._env.reset()
        self._s = self._state_number(observation)
        self._ended = False
        start: tuple[Scene, float | None] = (self._robot.scene(), None)
        self._way = deque([start], maxlen=LAST)  # of this episode

    def _grid(self) -> ipywidgets.GridBox:
        """The buttons, each in its row and column."""
        buttons = buttons_of(self._task)
        rows = sorted({button.place[0] for button in buttons})
        columns = sorted({button.place[1] for button in buttons})
        cells = []
        for row in rows:
            for column in columns:
                cells.append(self._cell(buttons, row, column))
        layout = {
            "grid_template_columns": f"repeat({len(columns)}, max-content)",
            "grid_gap": "4px",
        }
        return ipywidgets.GridBox(cells, layout=layout)

    def _cell(self, buttons: list[Button], row: int, column: int) -> ipywidgets.Widget:
        """The buttons of one place, in most cases a single one."""
        widgets = []
        for button in buttons:
            if button.place != (row, column):
                continue
            text = f"{button.text} [{button.key}]" if button.key else button.text
            widget = ipywidgets.Button(description=text, tooltip=_tooltip(button))
            widget.layout.width = "max-content"
            widget.add_class(f"rl-action-{button.a}")
            widget.on_click(partial(self._pressed, button))
            widgets.append(widget)
        return ipywidgets.VBox(widgets)

    def _pressed(self, button: Button, _: Any) -> None:
        r = self.press(button.a)
        mean = np.mean([row[2] for row in self._rows])
        n = len(self._rows)
        steps = "1 step" if n == 1 else f"{n} steps"
        text = f"{button.name}: reward {r:+.4g}. On average {mean:+.2f} in {steps}."
        if self._ended:
            text += " The episode has ended; the next press begins a new one."
        self._show(text.replace("-", "−"))

    def _pressed_again(self, _: Any) -> None:
        self.start_again()
        self._show("back at the start")

    def _show(self, text: str) -> None:
        """Show the robot and a text."""
        rewards = [row[2] for row in self._rows]
        last = rewards[-1] if rewards else None
        bar = {"step": len(rewards), "of": None, "reward": last, "sum": sum(rewards)}
        self._picture.show(self._way, bar)
        self._said.value = f'<p aria-live="polite">{html.escape(text)}</p>'
        self._keyboard.answered = len(self._rows)


def _tooltip(button: Button) -> str:
    """What the robot does at a button, and its command."""
    if button.name in (button.text, button.words):
        return button.words
    return f"{button.name}: {button.words}"
