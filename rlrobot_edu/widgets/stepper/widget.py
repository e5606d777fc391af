"""The stepper: walk through what an agent learns, one step at a time, forwards and backwards."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from functools import cached_property
from pathlib import Path
from typing import Any

import gymnasium

from rlrobot_edu.checks import check_count
from rlrobot_edu.files import write_whole
from rlrobot_edu.jupyter import anywidget, traitlets
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import check_pair_of
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.widgets.page_file import page_html
from rlrobot_edu.widgets.stepper.credit_kernels import selection_kernel, update_kernels
from rlrobot_edu.widgets.stepper.environment_view import view_of
from rlrobot_edu.widgets.stepper.names import Names
from rlrobot_edu.widgets.stepper.numerals import given, number
from rlrobot_edu.widgets.stepper.page_data import feed, frame_data
from rlrobot_edu.widgets.stepper.replay import ReplayStart
from rlrobot_edu.widgets.stepper.saved_page import script, style
from rlrobot_edu.widgets.stepper.still import still
from rlrobot_edu.widgets.stepper.tape import Tape

# All views of a widget share one set of steps, whichever cells show them; a later view asks for what is new.
_SHOW = """
const kept = { frames: [], at: 0 };
function keep({ frames = [] }) {
  kept.frames.push(...frames.filter(({ t }) => t > (kept.frames.at(-1)?.t ?? -1)));
}
export default {
  initialize({ model }) {
    const { frames, at } = model.get("feed");
    Object.assign(kept, { frames: [...frames], at });
    model.on("msg:custom", keep);
  },
  render({ model, el }) {
    const stepper = new Stepper({ ...model.get("feed"), ...kept }, replayData, (question) => model.send(question));
    const hear = (news) => stepper.hear(news);
    stepper.mount(el);
    model.on("msg:custom", hear);
    model.send({ have: stepper.recorded.end });
    return () => {
      stepper.stop();
      kept.at = stepper.recorded.t;
      model.off("msg:custom", hear);
    };
  },
};
"""


@suggests_keywords
class Stepper(Displayed):
    """Any agent in any environment, step by step: a view of it, the choice, the update with its numbers, Q and traces.

    Parameters
    ----------
    agent : Agent
        The agent that learns.
    env : gymnasium.Env
        Where it learns, see `steps`. It is reset, and an episode begins.
    at : int
        The step to show first, at least 0.
    keep : int
        How many of the latest steps can be shown again, at least 1.

    Raises
    ------
    ValueError
        If agent and environment do not fit together.

    Notes
    -----
    The agent takes a new step when the view goes beyond the last one. Going back moves only the view: the agent keeps
    what it has learned, and going forward again shows the same steps. The first step is taken at once, also at t = 0.
    """

    def __init__(
        self,
        agent: Agent,
        env: gymnasium.Env,
        at: int = 1,
        *,
        keep: int = 2000,
    ) -> None:
        check_pair_of(agent, env)
        at = check_count("at", at, least=0)
        keep = check_count("keep", keep)
        self._names = Names(agent, env)
        self._replay_start = ReplayStart(agent, env)
        self._tape = Tape(agent, env, view_of(env, self._names), keep)
        self._tape.go(at)

    @property
    def t(self) -> int:
        """Number of steps up to the one shown."""
        return self._tape.t

    @cached_property
    def widget(self) -> StepperWidget:
        """The page's program in a notebook."""
        data = feed(self._tape, self._names, self.t)
        return StepperWidget(self._script(), data, self._hear)

    def forward(self, n: int = 1) -> None:
        """Show the step `n` steps later; the agent takes the steps that it has not taken yet.

        Parameters
        ----------
        n : int
            How many steps.

        Raises
        ------
        ValueError
            If `n` is not a whole number of at least 0.
        RuntimeError
            As `jump`.
        """
        self.jump(self.t + check_count("n", n, least=0))

    def back(self, n: int = 1) -> None:
        """Show the step `n` steps before, or the earliest that is kept.

        Parameters
        ----------
        n : int
            How many steps.

        Raises
        ------
        ValueError
            If `n` is not a whole number of at least 0.
        """
        self.jump(max(self.t - check_count("n", n, least=0), self._tape.first))

    def jump(self, t: int) -> None:
        """Show step `t`.

        Parameters
        ----------
        t : int
            Number of steps up to the one to show.

        Raises
        ------
        ValueError
            If that step is no longer kept, or `t` is not a whole number of at least 0.
        RuntimeError
            If agent or world has taken a step elsewhere in between, so that no new step can be taken.
        """
        end = self._tape.end
        self._tape.go(check_count("t", t, least=0))
        self._tell(end, at=self.t)

    def save(self, path: str | Path, steps: int | None = None) -> None:
        """Write the steps to one HTML page that any browser opens, without a kernel and without a network.

        The page begins with the earliest step that is kept. The view does not change.

        Parameters
        ----------
        path : str or Path
            The file, such as ``page.html``; the address ``page.html#31`` leads to step 31.
        steps : int, optional
            The last step of the page, by default the last one taken; the agent takes the steps up to it.

        Raises
        ------
        ValueError
            If that step is no longer kept, if `steps` is not a whole number, or if the file's name ends like that of
            another kind of file.
        RuntimeError
            As `jump`.
        OSError
            If the file cannot be written.
        """
        shown, end = self.t, self._tape.end
        last = check_count("steps", end if steps is None else steps, least=0)
        try:
            self._tape.go(last)
            write_whole(path, self._page(min(shown, last), last))
        finally:
            # The step shown is no longer kept if there are too many new ones.
            self._tape.go(max(shown, self._tape.first))
            self._tell(end)

    def picture(self) -> Picture:
        """What is shown now, as a still picture.

        Returns
        -------
        Picture
            A matplotlib figure with a description in words.
        """
        return still(self._tape, self._names)

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

    def _page(self, at: int, last: int) -> str:
        """The page with the steps up to `last`, which shows step `at` first."""
        data = feed(self._tape, self._names, at)
        frames = [frame for frame in data["frames"] if frame["t"] < last]
        columns = {}  # they pack better than rows
        if frames:
            for name in frames[0]:
                columns[name] = [frame[name] for frame in frames]
        data["frames"] = columns
        learner = "A robot" if self._names.task else "An agent"
        world = f" in {self._names.task.name}" if self._names.task else ""
        title = f"{learner} learns, one step at a time"
        description = (
            f"Each step of what learns by {self._tape.agent.method.name}{world}: its world, its choice, the update "
            "with the numbers of the step, and its tables."
        )
        return page_html(title, description, data, self._script(), style())

    def _script(self) -> str:
        """The page's program."""
        agent = self._tape.agent
        return script(
            self._replay_start.script(self._tape),
            update_kernels(agent, self._replay_start.parameters),
            selection_kernel(agent),
        )

    def _hear(self, question: dict[str, Any]) -> None:
        """Answer a page: ``take`` asks for so many new steps, ``have`` for all after these, ``at`` goes to a step."""
        tape = self._tape
        end = question.get("have", tape.end)
        error = ""
        try:
            if "take" in question:
                tape.go(tape.end + question["take"])
            elif "at" in question:
                tape.go(min(max(question["at"], tape.first), tape.end))
                return
        except Exception as failure:
            error = str(failure)
        self._tell(end, error=error)

    def _tell(self, end: int, **more: Any) -> None:
        """Send the steps after `end`, and `more`, to the pages if there are any."""
        if "widget" not in vars(self):
            return
        frames = [frame_data(frame, self._tape) for frame in self._tape.since(end)]
        parameters = asdict(self._tape.agent.parameters)
        self.widget.send({"frames": frames, "parameters": parameters, **more})


class StepperWidget(anywidget.AnyWidget):
    """A view of a stepper.

    script: the page's program; feed: its first data; hear: called with each question of the page
    """

    feed = traitlets.Dict().tag(sync=True)

    def __init__(
        self, script: str, feed: dict[str, Any], hear: Callable[[dict[str, Any]], None]
    ) -> None:
        self._esm = script + _SHOW
        self._css = style()
        super().__init__(feed=feed)
        self.on_msg(lambda _, question, buffers: hear(question))
