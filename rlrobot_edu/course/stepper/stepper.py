"""The stepper: walk through what an agent learns, one step at a time, forwards and backwards."""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial
from pathlib import Path

import gymnasium
import ipywidgets

from rlrobot_edu.course.stepper.controls import Controls
from rlrobot_edu.course.stepper.environment_view import view_of
from rlrobot_edu.course.stepper.names import Names
from rlrobot_edu.course.stepper.numerals import given, number
from rlrobot_edu.course.stepper.panes import code_pane, view_html, what_to_hide
from rlrobot_edu.course.stepper.player import Player
from rlrobot_edu.course.stepper.saved_page import save_steps
from rlrobot_edu.course.stepper.script import KEYS, answer, framed
from rlrobot_edu.course.stepper.still import still
from rlrobot_edu.course.stepper.style import STYLE
from rlrobot_edu.course.stepper.tape import Tape
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task


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
    hide : collection of str
        What stays covered until a click: ``"a_next"``, the next action of an algorithm that learns from it.

    Raises
    ------
    ValueError
        If agent, environment and task do not fit together, or if there is no such thing to hide.

    Notes
    -----
    The agent takes a new step when the view goes beyond the last one. Going back moves the view alone: what the agent
    has learned stays learned, and going forward again shows the same steps. (The first step is taken at once, at t = 0
    as well.)
    """

    def __init__(
        self,
        agent: Agent,
        env: gymnasium.Env,
        at: int = 1,
        *,
        keep: int = 2000,
        task: Task | None = None,
        hide: Collection[str] = (),
    ) -> None:
        if not isinstance(agent, Agent) or not isinstance(env, gymnasium.Env):
            types = f"{type(agent).__name__} and {type(env).__name__}"
            raise ValueError(
                f"a Stepper takes an Agent and an environment (see rl.make_env), in this order; got {types}"
            )
        if keep < 1:
            raise ValueError(f"a Stepper keeps at least 1 step, got keep={keep}")
        self._hide = what_to_hide(hide)
        self._names = Names(agent, env, task)
        self._environment_view = view_of(env, self._names)
        self._tape = Tape(agent, env, self._environment_view, keep)
        self._answers = 0
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
        try:
            self._tape.go(t)
        finally:
            self._show()

    def play(self) -> None:
        """Go forward by itself, until `pause`.

        Raises
        ------
        RuntimeError
            In a program without a running event loop, which a notebook has.
        """
        self._player.play()

    def pause(self) -> None:
        """Stop playing, at once."""
        self._player.stop()

    def save(self, path: str | Path, steps: int | None = None) -> None:
        """Write the steps to one HTML page that any browser opens, without a kernel and without a network.

        The page begins with the earliest step that is kept. The view stays where it is.

        Parameters
        ----------
        path : str or Path
            The file, such as ``page.html``; the address ``page.html#31`` leads to step 31.
        steps : int, optional
            The last step of the page, by default the last one taken; the agent takes those that it has not taken yet.

        Raises
        ------
        ValueError
            If that step is no longer kept.
        """
        try:
            save_steps(path, self._tape, self._names, self._html, steps)
        finally:
            self._show()

    def picture(self) -> Picture:
        """What is shown now, as a still picture.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.
        """
        return still(self._tape, self._names, self._environment_view, self._hide)

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

    def _build(self) -> None:
        """The page, from top to bottom."""
        moves = {
            "first": lambda: self.jump(self._tape.first), "back": self.back,
            "step": self.forward, "last": lambda: self.jump(self._tape.end),
        }  # fmt: skip
        press = {name: partial(self._move, move) for name, move in moves.items()}
        self.controls = Controls({**press, "play": self._play_or_pause}, lambda t: self._move(partial(self._go, t)))
        self._player = Player(self._tape, self.controls, self._show, self._say)
        self._view, self._answer = ipywidgets.HTML(), ipywidgets.HTML()
        shown = ipywidgets.Button(layout={"display": "none"})
        shown.add_class("rl-shown")
        shown.on_click(lambda _: self._player.page_has_shown())
        keys, code = ipywidgets.HTML(STYLE + KEYS), ipywidgets.HTML(code_pane(self._tape.agent))
        self.widget = ipywidgets.VBox([*self.controls.widgets, keys, self._answer, self._view, code, shown])
        self.widget.add_class("rl-stepper")

    def _move(self, move: Callable[[], None]) -> None:
        self._do(move, self._player.stop())  # what the reader moves stops playing first

    def _play_or_pause(self) -> None:
        if self._player.runs:
            self._do(lambda: None, self._player.stop())
        else:
            self._do(self.play)

    def _go(self, t: int) -> None:
        """Jump to step `t`, at once, or if that is far away and something else can run meanwhile, on a journey."""
        if self._player.must_travel(t):
            self._player.travel(t)
        else:
            self.jump(t)

    def _do(self, act: Callable[[], None], said: str = "") -> None:
        """Do what a control asks for, and show a message; an error is shown on the page."""
        kind = "status"
        try:
            act()
        except Exception as error:
            said, kind = str(error), "alert"
            self.controls.show(self._tape)
        self._say(said, kind)

    def _show(self) -> None:
        self._view.value = self._html()
        self.controls.show(self._tape)

    def _html(self) -> str:
        return framed(view_html(self._tape, self._names, self._environment_view, self._hide))

    def _say(self, text: str, kind: str = "alert") -> None:
        self._answers += 1
        self._answer.value = answer(text, kind, self._answers)
