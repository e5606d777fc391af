"""How far a learner has come: which functions of the course are right in `my_functions.py`, and what is left."""

from html import escape
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
    written,
)
from rlrobot_edu.show import palette
from rlrobot_grading.exercises.exercise import Exercise

LAST = 18  # lesson of the road; those after it are optional
ROAD = "display:flex;flex-wrap:wrap;gap:.3em;list-style:none;padding:0;margin:.4em 0"
STONE = "border:1px solid {line};border-top:4px solid {top};border-radius:4px;padding:.2em .5em;width:9.5em;margin:0"


class Lesson(NamedTuple):
    """One lesson: its number and title, its functions that are `right` and that are still to `write`, its minutes."""

    number: str
    title: str
    right: list[str]
    write: list[str]
    minutes: int

    @property
    def counts(self) -> str:
        """How many of its functions are right, as in "2 of 3"."""
        return f"{len(self.right)} of {len(self.right) + len(self.write)}"


class Progress(NamedTuple):
    """All lessons in which functions are written, what is next, and how long the rest takes.

    As text: a table. In a notebook: a road with a stone for each lesson.
    """

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

    def __repr__(self) -> str:
        wide = max(len(lesson.title) for lesson in self.lessons)
        rows = []
        for x in self.lessons:
            mark = "   "
            if not x.write:
                mark = "  ✓"
            elif not x.right:
                mark = "  ·"
            rows.append(
                f"{x.number:<4}{x.title:<{wide}}  {x.counts}{mark}{x.minutes:5} min  {', '.join(x.write)}"
            )
        return "\n".join([*rows, "", self.next])

    def _repr_html_(self) -> str:
        here = next((lesson for lesson in self.lessons if lesson.write), None)
        stones = "".join(_stone(lesson, lesson is here) for lesson in self.lessons)
        road = f'<ol aria-label="The road" style="{ROAD}">{stones}</ol>'
        return f'<div style="max-width:60em">{road}<p>{escape(self.next)}</p></div>'


def _stone(lesson: Lesson, is_here: bool) -> str:
    """A lesson on the road, in HTML: its number and title, and how many of its functions are right."""
    top, said = palette.GREY, lesson.counts
    if not lesson.write:
        top, said = palette.GREEN, "✓ done"
    elif is_here:
        top, said = palette.BLUE, f"➤ you are here, {lesson.counts}"
    style = STONE.format(line=palette.GREY, top=top)
    title = escape(lesson.title)
    return f'<li style="{style}"><b>{lesson.number}</b> {title}<br><small>{said}</small></li>'


def so_far(lesson: str, folder: str | Path = ".") -> str:
    """How many functions of a lesson are in the learner's file, in a sentence; after the last, what comes next."""
    names = _functions(lesson)
    kept = written(lesson, folder).intersection(names)
    if len(kept) < len(names):
        return f"{len(kept)} of {len(names)} functions of this lesson are written."
    done = f"That was the last function of lesson {lesson}."
    number = int(lesson[:2])
    if number < LAST:
        done = f"{done} Next on the road: lesson {number + 1:02}."
    return done


def _functions(lesson: str) -> list[str]:
    """What a learner writes in a lesson."""
    check = vars(check_of(lesson))
    return [name for name, one in check.items() if isinstance(one, Exercise)]


def progress(folder: str | Path = FOLDER) -> Progress:
    """How far the learner of this folder has come; each function in its my_functions.py is checked once more.

    Where there is no such file yet, nothing is written: the first check that is green makes it.
    """
    lessons, known = [], facts(NOTEBOOKS.parent)
    for number in LESSONS:
        names = _functions(number)
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
