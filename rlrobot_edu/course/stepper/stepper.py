"""The stepper: walk through what an agent learns, one step at a time, forwards and backwards."""

from __future__ import annotations

import asyncio
import html
from collections.abc import Callable
from functools import partial

import gymnasium
import ipywidgets

from rlrobot_edu.course.stepper.controls import Controls
from rlrobot_edu.course.stepper.environment_view import view_of
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number
from rlrobot_edu.course.stepper.panes import view_html
from rlrobot_edu.course.stepper.still import still
from rlrobot_edu.course.stepper.style import KEYS, STYLE, framed
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task

AHEAD = 2  # steps; so far ahead of the page it may play


class Stepper(Displayed):
    """Any agent in any environment, step by step: a view of it, the choice, the update with its numbers, Q and traces.

    Parameters
    ----------
    agent : Agent
        What learns.
    env : gymnasium.Env
        Where it learns, see `steps`. It is reset, and an episode begins.
    at : int
        The step to show first, at least 0.
    keep : int
        So many of the latest steps can be looked at again, at least 1.
    task : Task, optional
        Names of states and actions for an environment that has no task itself, such as a sample model.

    Raises
    ------
    ValueError
        If agent, environment and task do not fit together.

    Notes
    -----
    The agent takes a new step when the view goes beyond the last one. Going back moves the view alone: what the agent
    has learned stays learned, and going forward again shows the same steps. (The first step is taken at once, at t = 0
    as well.)
    """

    def __init__(
        self, agent: Agent, env: gymnasium.Env, at: int = 1, *, keep: int = 2000, task: Task | None = None
    ) -> None:
        if not isinstance(agent, Agent) or not isinstance(env, gymnasium.Env):
            types = f"{type(agent).__name__} and {type(env).__name__}"
            raise ValueError(
                f"a Stepper takes an Agent and an environment (see rl.make_env), in this order; got {types}"
            )
        if keep < 1:
            raise ValueError(f"a Stepper keeps at least 1 step, got keep={keep}")
        self._names = Names(agent, env, task)
        self._environment_view = view_of(env, self._names)
        self._tape = Tape(agent, env, self._environment_view, keep)
        self._task: asyncio.Task[None] | None = None
        self._shown = 0  # steps that a page has told it has shown, since play began
        self._build()
        self.jump(at)

    @property
    def t(self) -> int:
        """Number of steps up to the one shown."""
        return self._tape.t

    @property
    def html(self) -> str:
        """The view, as HTML."""
        return self._view.value

    def forward(self, n: int = 1) -> None:
        """Show the step that comes `n` steps later; the agent takes those that it has not taken yet.

        Parameters
        ----------
        n : int
            How many steps.
        """
        self.jump(self.t + n)

    def back(self, n: int = 1) -> None:
        """Show the step `n` steps before, or the earliest that is kept.

        Parameters
        ----------
        n : int
            How many steps.
        """
        self.jump(max(self.t - n, self._tape.first))

    def jump(self, t: int) -> None:
        """Show step `t`.

        Parameters
        ----------
        t : int
            Number of steps up to the one to show.

        Raises
        ------
        ValueError
            If that step is no longer kept.
        """
        tape = self._tape
        if t < tape.first:
            raise ValueError(
                f"there is no step {t} to show: the earliest that is kept is {tape.first} (keep= sets how many)"
            )
        try:
            while tape.t < t:
                tape.forward()
            while tape.t > t:
                tape.back()
        finally:
            self._show()

    def play(self) -> None:
        """Go forward by itself, until `pause`.

        Raises
        ------
        RuntimeError
            In a program without a running event loop, which a notebook has.
        """
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:
            raise RuntimeError(
                "play() needs a running event loop, which a notebook has and a plain program has not: use forward()"
            ) from None
        if self._task is None or self._task.done():
            self._task = loop.create_task(self._play())
            self.controls.say_playing(True)

    def pause(self) -> None:
        """Stop playing, at once."""
        if self._task is not None:
            self._task.cancel()
            self._task = None
            self.controls.say_playing(False)

    def picture(self) -> Picture:
        """What is shown now, as a still picture.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.
        """
        return still(self._tape, self._names, self._environment_view)

    def still(self) -> Still:
        """What is shown now, as a saved notebook keeps it.

        Returns
        -------
        Still
            The picture and its description.
        """
        return self.picture().still()

    def __repr__(self) -> str:
        frame = self._tape.frame
        if frame is None:
            return "<Stepper before the first step>"
        step = frame.step
        return (
            f"<Stepper at step {self.t}: state {step.s}, action {step.a}, reward {given(step.r)}, next state "
            f"{step.s_next}, TD error {number(step.delta)}>"
        )

    async def _play(self) -> None:
        """Play without running ahead of the page by more than AHEAD steps, or else a pause would seem to come late."""
        loop = asyncio.get_running_loop()
        sent = self._shown = 0
        try:
            while True:
                due = loop.time() + 1 / self.controls.speed.value
                self.forward()
                sent += 1
                await asyncio.sleep(max(due - loop.time(), 0.001))
                while 0 < self._shown < sent - AHEAD and loop.time() < due + 1:  # a page that was closed tells nothing
                    await asyncio.sleep(0.005)
        except Exception as error:
            self._task = None
            self.controls.say_playing(False)
            self._say(str(error))

    def _build(self) -> None:
        """The page, from top to bottom."""
        moves = {
            "first": lambda: self.jump(self._tape.first), "back": self.back,
            "step": self.forward, "last": lambda: self.jump(self._tape.end),
        }  # fmt: skip
        press = {name: partial(self._move, move) for name, move in moves.items()}
        self.controls = Controls({**press, "play": self._play_or_pause}, lambda t: self._move(partial(self.jump, t)))
        self._view, self._error = ipywidgets.HTML(), ipywidgets.HTML()
        shown = ipywidgets.Button(layout={"display": "none"})
        shown.add_class("rl-shown")
        shown.on_click(self._on_shown)
        keys = ipywidgets.HTML(STYLE + KEYS)
        self.widget = ipywidgets.VBox([*self.controls.widgets, keys, self._error, self._view, shown])
        self.widget.add_class("rl-stepper")

    def _move(self, move: Callable[[], None]) -> None:
        """What the reader moves stops playing first."""
        self.pause()
        self._do(move)

    def _play_or_pause(self) -> None:
        self._do(self.play if self._task is None else self.pause)

    def _do(self, act: Callable[[], None]) -> None:
        """What a control does; an error is told on the page."""
        self._say("")
        try:
            act()
        except Exception as error:
            self._say(str(error))

    def _on_shown(self, _: ipywidgets.Button) -> None:
        self._shown += 1

    def _show(self) -> None:
        self._view.value = framed(view_html(self._tape, self._names, self._environment_view))
        self.controls.show(self._tape)

    def _say(self, text: str) -> None:
        self._error.value = f'<p class="rl-error" role="alert">{html.escape(text)}</p>' if text else ""
