"""What the `exercises.py` of a lesson is made of, to be imported in one line."""

import re
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from rlrobot_course.exercises.design import Design as Design
from rlrobot_course.learner.my_functions import keep
from rlrobot_course.learner.progress import so_far
from rlrobot_edu.learning.progress import watched
from rlrobot_grading.answers.replay import Case as Case
from rlrobot_grading.answers.values import safely
from rlrobot_grading.exercises import page
from rlrobot_grading.exercises.exercise import Exercise as Exercise
from rlrobot_grading.exercises.mistake import Mistake as Mistake
from rlrobot_grading.exercises.mistake import wrong_choices as wrong_choices
from rlrobot_grading.exercises.question import Question as Question
from rlrobot_grading.hints.formula import Formula as Formula


def with_pages(
    names: dict[str, Any], **exercises: Exercise | Question
) -> SimpleNamespace:
    """The exercises of a lesson, each with its page; right answers are kept in the learner's file.

    Below the card of a wrong one stands a button where the lesson's `drive.py` has the robot drive by it.

    names: the ``globals()`` of the lesson's `exercises.py`. See `rlrobot_grading.exercises.page.with_pages`
    """
    return page.with_pages(names, keep=_kept, offer=_offered, **exercises)


def _kept(exercise: Exercise, answer: Callable[..., Any]) -> str:
    """Keep a right answer for later lessons; says so. In an assignment nothing is kept."""
    lesson = re.search(r"lesson_(\w+)", exercise.right.__module__)
    if lesson is None:
        return ""
    told = "(Not kept for later lessons.)"
    name = exercise.right.__name__
    told = safely(told, keep, answer, lesson[1], name, exercise.judge)
    return f"{told} {safely('', so_far, lesson[1])}".strip()


def _offered(exercise: Exercise, answer: Callable[..., Any]) -> Any:
    """A button that shows what the robot does by a wrong answer; None where no robot drives by it, or nobody looks.

    Raises ImportError where the packages of a notebook are missing.
    """
    # Imported here: lessons can be checked without those packages.
    from rlrobot_course.drives.button import DriveButton
    from rlrobot_course.drives.by_your_code import drive_of

    drive = drive_of(exercise)
    if drive is None or not watched():
        return None
    return DriveButton(drive, exercise.right, answer)
