"""How far a learner has come: which functions of the course are right in `my_functions.py`, and what is left."""

from pathlib import Path
from typing import NamedTuple

from rlrobot_course.authoring.lists import facts
from rlrobot_course.learner.my_course import FOLDER, LAB, NOTEBOOKS
from rlrobot_course.learner.my_functions import (
    FILE,
    LESSONS,
    check_of,
    is_right,
    syntax_error,
)
from rlrobot_grading.exercises.exercise import Exercise


class Lesson(NamedTuple):
    """One lesson: its number and title, its functions that are `right` and that are still to `write`, its minutes."""

    number: str
    title: str
    right: list[str]
    write: list[str]
    minutes: int


class Progress(NamedTuple):
    """All lessons in which functions are written. As text: a table, what is next, and how long the rest takes."""

    lessons: list[Lesson]

    @property
    def next(self) -> str:
        """What is next, and how much is left, in a sentence."""
        left = [lesson for lesson in self.lessons if lesson.write]
        if not left:
            return "All functions of the course are written, and right."
        first, hours = left[0], sum(lesson.minutes for lesson in left) / 60
        done = sum(len(lesson.right) for lesson in self.lessons)
        if not done:
            return (
                f"You have not begun yet, so all is still ahead, some {hours:.0f} hours: {LAB} opens the course. "
                f"Lesson {first.number} {first.title} asks for the first function, {first.write[0]}."
            )
        todo = done + sum(len(lesson.write) for lesson in left)
        return (
            f"{done} of {todo} functions are right. Next: lesson {first.number} {first.title}, "
            f"{', '.join(first.write)}. What is left takes about {hours:.0f} hours."
        )

    def __str__(self) -> str:
        wide = max(len(lesson.title) for lesson in self.lessons)
        rows = []
        for x in self.lessons:
            mark = "   "
            if not x.write:
                mark = "  ✓"
            elif not x.right:
                mark = "  ·"
            counts = f"{len(x.right)} of {len(x.right) + len(x.write)}"
            rows.append(
                f"{x.number:<4}{x.title:<{wide}}  {counts}{mark}{x.minutes:5} min  {', '.join(x.write)}"
            )
        return "\n".join([*rows, "", self.next])


def progress(folder: str | Path = FOLDER) -> Progress:
    """How far the learner of this folder has come; each function in its my_functions.py is checked once more.

    Where there is no such file yet, nothing is written: the first check that is green makes it.
    """
    lessons, known = [], facts(NOTEBOOKS.parent)
    for number in LESSONS:
        names = [
            name
            for name, one in vars(check_of(number)).items()
            if isinstance(one, Exercise)
        ]
        done = [name for name in names if is_right(number, name, folder)]
        if names:
            left = [name for name in names if name not in done]
            title, minutes = (
                (known[number].title, known[number].minutes)
                if number in known
                else (number, 0)
            )
            lessons.append(Lesson(number, title, done, left, minutes))
    return Progress(lessons)


def show(folder: str | None) -> None:
    """Print how far the learner is, and whether Python cannot read my_functions.py.

    Raises FileNotFoundError if there is no such folder.
    """
    if folder and not Path(folder).is_dir():
        raise FileNotFoundError(f"{folder}: there is no such folder")
    folder = folder or FOLDER
    print(progress(folder))
    mistake = syntax_error(Path(folder, FILE))
    if mistake:
        print(mistake)
