"""Three old questions at the end of a lesson: what the lessons before have taught, asked again at growing distances.

The questions stand in `questions.toml`, by lesson.
"""

import zlib
from collections import Counter
from html import escape
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rlrobot_course.questions.prediction import ASKED, Prediction, kept
from rlrobot_edu.jupyter import ipywidgets
from rlrobot_edu.show.display import Displayed

DISTANCES = (1, 3, 6, 2, 4, 5)  # lessons back; the first three that there are


class Question(NamedTuple):
    """A question about a lesson.

    lesson: its number; name: the number of the lesson and of the question in it, "05 1"; ask: the question
    right: the right answer; wrong: two or three others, each a misunderstanding; why: one sentence
    at: the lesson in which to look again, which may be an appendix of it
    """

    lesson: str
    name: str
    ask: str
    right: str
    wrong: tuple[str, ...]
    why: str
    at: str

    @property
    def answers(self) -> list[str]:
        """All answers, in an order that tells nothing and is always the same."""
        order = np.random.default_rng(zlib.crc32(self.ask.encode())).permutation(
            1 + len(self.wrong)
        )
        return [[self.right, *self.wrong][i] for i in order]


QUESTIONS = {
    number: [
        Question(
            number,
            f"{number} {i}",
            **{"at": number} | one | {"wrong": tuple(one["wrong"])},
        )
        for i, one in enumerate(questions, 1)
    ]
    for number, questions in ASKED["old_question"].items()
}


def due(lesson: str, answered: dict[str, str] | None = None) -> list[Question]:
    """The three questions at the end of a lesson, from three lessons before it where there are so many.

    lesson: its number, from "02" on; answered: the latest answers of the lessons before it, by name. A lesson is asked
        about again and again, each time by its next question; but one that was answered wrong comes first
    """
    asked: Counter[int] = Counter()
    for number in range(2, int(lesson[:2]) + 1):
        before = [
            number - back for back in DISTANCES if f"{number - back:02}" in QUESTIONS
        ]
        chosen = []
        for source in (before * 3)[:3]:
            questions = QUESTIONS[f"{source:02}"]
            chosen.append(questions[asked[source] % len(questions)])
            asked[source] += 1
    answered = answered or {}
    found: list[Question] = []
    for question in chosen:
        failed = [
            q
            for q in QUESTIONS[question.lesson]
            if answered.get(q.name, q.right) != q.right
        ]
        waiting = [q for q in failed if q not in (*chosen, *found)]
        found.append(waiting[0] if waiting else question)
    return found


class _Asked(Prediction):
    """One of them, with a button for each answer; unlike a prediction it tells at once whether the answer is right.

    The answer is kept under the lesson that asks and the name of the question, "04: 01 2", for it may be asked again.
    """

    FILE = "my_old_questions.json"

    def __init__(self, question: Question, lesson: str) -> None:
        self.about = question
        super().__init__(f"{lesson}: {question.name}", question.ask, question.answers)

    def choose(self, answer: str) -> None:
        """Take `answer`, if it is the first: after that the right one is shown."""
        if not self.chosen:
            super().choose(answer)

    def _headline(self) -> str:
        return f"From lesson {self.about.at}."

    def _said(self) -> str:
        if not self.chosen:
            return ""
        if self.chosen == self.about.right:
            return f"✓ Right. {escape(self.about.why)}"
        right = escape(self.about.right)
        return f"✗ It is “{right}”. {escape(self.about.why)} Look again in lesson {self.about.at}."


class OldQuestions(Displayed):
    """The three old questions of a lesson: buttons in a notebook, plain text on a page that is not running.

    lesson: the number of the lesson that asks, "05"; the answers are kept in `my_old_questions.json`
    """

    def __init__(self, lesson: str) -> None:
        self.asked = [
            _Asked(question, lesson)
            for question in due(lesson, latest_answers(before=lesson))
        ]
        self.widget = ipywidgets.VBox([one.widget for one in self.asked])

    def __repr__(self) -> str:
        return "\n".join(map(repr, self.asked))

    def _as_html(self) -> str:
        """The questions and their answers, on a page that is not running."""
        return "".join(one._as_html() for one in self.asked)


def latest_answers(folder: str | Path = ".", before: str = "99") -> dict[str, str]:
    """The latest answer to each old question, by its name; before: only those of lessons before this one."""
    answers = sorted(kept(_Asked.FILE, folder).items())
    return {key.partition(": ")[2]: answer for key, answer in answers if key < before}
