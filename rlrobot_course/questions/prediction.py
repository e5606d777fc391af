"""Predict, then run: the reader clicks on an expected outcome, and learns afterwards what happened."""

import tomllib
from collections.abc import Sequence
from html import escape
from pathlib import Path

from rlrobot_course.learner.learners_files import enter, entries
from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.show.display import Displayed
from rlrobot_edu.show.palette import BLUE
from rlrobot_grading.answers.notebook import is_notebook
from rlrobot_grading.exercises.verdict import CARD, Verdict

ASKED = tomllib.loads(
    Path(__file__).with_name("questions.toml").read_text(encoding="utf-8")
)  # in all lessons


class Prediction(Displayed):
    """A question about what comes next, with a button for each of a few answers.

    name: the number of the lesson and a word, "03 turn"; under it the answer is kept in `my_predictions.json`, beside
        the notebooks, and the outcome stands in `questions.toml`
    question: what is to be predicted; answers: two to five, short

    In a notebook the last expression of a cell shows it; the cell that comes after what was predicted ends with
    ``outcome()``, which gives nothing away to who reads it before it runs. On a page that is not running a prediction
    is the question and its answers in plain text.
    """

    FILE = "my_predictions.json"  # where the answers are kept

    def __init__(self, name: str, question: str, answers: Sequence[str]) -> None:
        self.name, self.question, self.answers = name, question, tuple(answers)
        self._buttons = [
            ipywidgets.Button(description=answer, layout={"width": "auto"})
            for answer in self.answers
        ]
        for button in self._buttons:
            button.on_click(lambda clicked: self.choose(clicked.description))
        self._told = ipywidgets.HTML()
        self._told.add_class("rlrobot-prediction")
        row = ipywidgets.Box(self._buttons, layout={"flex_flow": "row wrap"})
        self.widget = ipywidgets.VBox([ipywidgets.HTML(self._card()), row, self._told])
        self.chosen = kept(self.FILE).get(name, "") if is_notebook() else ""
        self._show()

    def choose(self, answer: str) -> None:
        """Take `answer` as the reader's prediction and keep it; raises ValueError if it is none of the answers."""
        self._must_have(answer)
        self.chosen = answer
        told = enter(self.FILE, self.name, answer, _answer) if is_notebook() else ""
        self._show()
        self._told.value += f" ({escape(told)})" if told else ""

    def outcome(self) -> Verdict:
        """The outcome of the prediction and the reason; raises ValueError if `questions.toml` does not have it."""
        answer, why = _outcome_of(self.name)
        self._must_have(answer)
        if not self.chosen:
            # beside the buttons, so that it stands on no saved page
            self._told.value = "You made no prediction: next time, click first."
            return Verdict("outcome", f"It is “{answer}”. {why}")
        status = "right" if self.chosen == answer else "outcome"
        told = "as you said." if status == "right" else f"and you said “{self.chosen}”."
        return Verdict(status, f"It is “{answer}”, {told} {why}")

    def _must_have(self, answer: str) -> None:
        if answer not in self.answers:
            raise ValueError(
                f"the prediction {self.name} has no answer {answer!r}, only {', '.join(self.answers)}"
            )

    def _show(self) -> None:
        for button in self._buttons:
            is_chosen = button.description == self.chosen
            button.button_style, button.icon = (
                ("primary", "check") if is_chosen else ("", "")
            )
        self._told.value = self._said()

    def _headline(self) -> str:
        return "Predict."

    def _said(self) -> str:
        """What stands beneath the buttons."""
        return (
            f"You say “{escape(self.chosen)}”. Run on."
            if self.chosen
            else "Click on one, then run on."
        )

    def __repr__(self) -> str:
        answers = "".join(f"\n  ○ {answer}" for answer in self.answers)
        return f"{self._headline().rstrip('.')}: {self.question}{answers}"

    def _as_html(self) -> str:
        """The question and its answers, on a page that is not running."""
        answers = "".join(f"<li>{escape(answer)}</li>" for answer in self.answers)
        return self._card(f"<ul>{answers}</ul>")

    def _card(self, more: str = "") -> str:
        return f'<div style="{CARD.format(colour=BLUE)}"><b>{self._headline()}</b> {escape(self.question)}{more}</div>'


def kept(file: str, folder: str | Path = ".") -> dict[str, str]:
    """The answers given so far, by name; none if the file cannot be read."""
    return entries(Path(folder, file), _answer)


def _answer(entry: object) -> str:
    if not isinstance(entry, str):
        raise TypeError("an answer is a text")
    return entry


def _outcome_of(name: str) -> tuple[str, str]:
    """The right answer and the reason."""
    told = ASKED["prediction"]
    if name not in told:
        raise ValueError(
            f"questions.toml tells no outcome of the prediction {name!r}: write it there, as of '03 turn'"
        )
    return told[name]["answer"], told[name]["why"]
