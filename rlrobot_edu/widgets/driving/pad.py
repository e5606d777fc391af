"""A robot driven by hand: buttons, keys and its picture; what was driven is a recording."""

from __future__ import annotations

import html
import io
from collections import deque
from functools import cached_property, partial
from typing import Any, cast

import ipywidgets
import numpy as np
from PIL import Image

from rlrobot_edu.learning.observations import state_numbers
from rlrobot_edu.learning.size import Env
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import THIS_COMPUTER, Source
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import describe, path_of, robot_of
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film import PIXELS, Film
from rlrobot_edu.show.top_down import Camera, plot_scene
from rlrobot_edu.widgets.driving.keys import ARROWS, Button, buttons_of, keys_of
from rlrobot_edu.widgets.driving.page import Keyboard

LAST = 60  # steps that a saved notebook keeps of those that were driven


def teleoperate(env: Env) -> Pad:
    """Drive a robot by hand, with buttons or keys, and record it.

    Parameters
    ----------
    env : gymnasium.Env
        An environment with a robot, see `make_env`.

    Returns
    -------
    Pad
        What a notebook shows; ``pad.recording`` is what was driven, for `learn_from`, `Recording.save`, or a model.

    Raises
    ------
    ValueError
        If the environment has no robot.
    """
    return Pad(env)


class Pad(Displayed):
    """The robot of `env` under a person's hands; each press is one step of its task."""

    def __init__(self, env: Env) -> None:
        self._robot, self._task = robot_of(env), cast(RobotEnv, env.unwrapped).task
        self._env, self._state_number = env, state_numbers(env)
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
        self._s, self._ended = s_next, terminated or truncated
        self._driven.append((self._robot.scene(), float(r)))
        self._way.append(self._driven[-1][0])
        return float(r)

    def start_again(self) -> None:
        """Put the robot back to its start; the episode so far is kept."""
        if self._rows:
            self._rows[-1][5] = (
                self._rows[-1][5] or not self._rows[-1][4]
            )  # cut off, unless it had ended for good
        self._begin()

    @property
    def recording(self) -> Recording:
        """All that was driven. Raises ValueError before the first step."""
        if not self._rows:
            raise ValueError("nothing has been driven yet: press a button first")
        return Recording(
            Transitions.of_rows(self._rows),
            Source.of_task(self._task, method="by hand", **THIS_COMPUTER),
            self._task,
        )

    @property
    def film(self) -> Film:
        """The last steps, at most 60, as a film. Raises ValueError before the first step."""
        if not self._driven:
            raise ValueError("nothing has been driven yet: press a button first")
        return Film.of(self._driven)

    @cached_property
    def widget(self) -> ipywidgets.HBox:
        """Buttons, keys and picture."""
        buttons = buttons_of(self._task)
        keys = keys_of(self._task)
        told = "those in brackets" + (
            ", and the arrows" if ARROWS.keys() <= keys.keys() else ""
        )
        self._said, self._camera = (
            ipywidgets.HTML(),
            Camera(self._robot.scene(), PIXELS),
        )
        self._picture = ipywidgets.HTML()
        again = ipywidgets.Button(
            description="start again",
            icon="undo",
            tooltip="Put the robot back to its start",
        )
        again.on_click(lambda _: (self.start_again(), self._show("back at the start")))
        columns = sorted({b.place[1] for b in buttons})
        pad = ipywidgets.GridBox(
            [
                self._cell(buttons, row, column)
                for row in sorted({b.place[0] for b in buttons})
                for column in columns
            ],
            layout={
                "grid_template_columns": f"repeat({len(columns)}, max-content)",
                "grid_gap": "4px",
            },
        )
        self._keyboard = Keyboard(actions=keys, told=told)
        # as wide as its buttons, and wider where there is room: so the picture stands beside it on a narrow page, too
        side = ipywidgets.VBox(
            [pad, again, self._keyboard, self._said],
            layout={"flex": "1 1 190px", "max_width": "22em"},
        )
        side.layout.min_width = "min-content"
        widget = ipywidgets.HBox(
            [side, self._picture], layout={"flex_flow": "row wrap", "grid_gap": "12px"}
        )
        self._show("nothing driven yet")
        widget.add_class("rl-drive")
        return widget

    def still(self) -> Still:
        """What was driven as a film, or the robot at its start."""
        return (
            self.film.still()
            if self._driven
            else plot_scene(self._robot.scene()).still()
        )

    def _begin(self) -> None:
        self._s, self._ended = self._state_number(self._env.reset()[0]), False
        self._way = deque([self._robot.scene()], maxlen=LAST)  # of this episode

    def _cell(self, buttons: list[Button], row: int, column: int) -> ipywidgets.Widget:
        """The buttons of one place, often one."""
        widgets = []
        for button in (b for b in buttons if b.place == (row, column)):
            widget = ipywidgets.Button(
                description=f"{button.text} [{button.key}]"
                if button.key
                else button.text,
                tooltip=button.words,
            )
            widget.layout.width = "max-content"
            widget.add_class(f"rl-action-{button.a}")
            widget.on_click(partial(self._pressed, button))
            widgets.append(widget)
        return ipywidgets.VBox(widgets)

    def _pressed(self, button: Button, _: Any) -> None:
        r = self.press(button.a)
        mean = np.mean([row[2] for row in self._rows])
        ended = (
            " The episode has ended; the next press begins a new one."
            if self._ended
            else ""
        )
        steps = "1 step" if len(self._rows) == 1 else f"{len(self._rows)} steps"
        self._show(
            f"{button.text}: reward {r:+.4g}. On average {mean:+.2f} in {steps}.{ended}".replace(
                "-", "−"
            )
        )

    def _show(self, text: str) -> None:
        """Say and show how the robot is."""
        scene = self._robot.scene()
        buffer = io.BytesIO()
        Image.fromarray(
            self._camera.frame(scene, f"step {len(self._rows)}", path_of(self._way))
        ).save(buffer, "PNG")
        self._picture.value = Still(describe(scene), buffer.getvalue(), PIXELS).html
        self._said.value = f'<p aria-live="polite">{html.escape(text)}</p>'
        self._keyboard.answered = len(self._rows)
