"""The button below a red card."""

from html import escape

from rlrobot_course.drives.beside import Beside, beside
from rlrobot_course.drives.by_your_code import Drive
from rlrobot_course.figures.plots import SideBySide
from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.show.display import Displayed
from rlrobot_edu.show.film import KEY
from rlrobot_grading.answers.values import Function, safely

ASKS = "See what your code does"
WORKS = "The robot drives …"
FAILS = "What your code does cannot be shown here."
AT_THE_CARD = {"width": "auto", "align_self": "flex-start"}
TEXT = "max-width: 60em; line-height: 1.45"


class DriveButton(Displayed):
    """A button; pressed, it makes room for two films, of a robot by the learner's code and by the right code.

    drive: how a robot drives by a function; right, answer: the right function, and the learner's
    A saved notebook shows nothing of it.
    """

    def __init__(self, drive: Drive, right: Function, answer: Function) -> None:
        self._drive, self._right, self._answer = drive, right, answer
        self.button = ipywidgets.Button(
            description=ASKS, icon="play", layout=AT_THE_CARD
        )
        self.button.on_click(lambda _: self.press())
        self.widget = ipywidgets.VBox([self.button])

    def __repr__(self) -> str:
        return ""

    def _as_html(self) -> str:
        return ""

    def press(self) -> None:
        """Let both drive, and show the films; raises nothing."""
        self.button.disabled, self.button.description = True, WORKS
        try:
            found = safely(
                Beside({}, FAILS), beside, self._drive, self._right, self._answer
            )
            self.widget.children = shown(found)
        except KeyboardInterrupt:  # the reader waits no longer
            self.button.disabled, self.button.description = False, ASKS


def shown(found: Beside) -> list[ipywidgets.Widget]:
    """Two films with what differs above them; in 3D where that is possible, else flat."""
    text = ipywidgets.HTML(f'<div style="{TEXT}">{escape(found.said)}</div>')
    if not found.films:
        return [text]
    both = SideBySide(found.films, in3d=True)
    if both.widget is None:
        return [text, ipywidgets.HTML(both._as_html())]
    return [text, both.widget, ipywidgets.HTML(f"<small>{KEY}</small>")]
