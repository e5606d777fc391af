"""What the grader is told of a course: its package, the folders that hold exercises, what a kernel needs."""

from __future__ import annotations

import importlib
import json
from dataclasses import asdict, dataclass
from importlib.util import find_spec
from pathlib import Path

from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question

LESSON = "lesson_"  # how the folder of a lesson begins; a lesson goes by its number


@dataclass(frozen=True)
class Course:
    """A course whose notebooks can be graded.

    Parameters
    ----------
    package : str
        Its name, as ``rlrobot_course``.
    folders : tuple of str
        Those in the package with an ``exercises.py``, as ``lesson_03`` and ``assignment_1``.
    kernel_setup : str
        A function that prepares the kernel of a submission, as ``module:function``. It is called with the lesson, the
        names of its exercises, the dictionary of the answers so far, and a list: to this it adds each function that it
        hands to the learner, since such a function is no answer.
    """

    package: str
    folders: tuple[str, ...]
    kernel_setup: str = ""

    @classmethod
    def from_json(cls, text: str) -> Course:
        """Return the course that `to_json` wrote."""
        fields = json.loads(text)
        return cls(fields["package"], tuple(fields["folders"]), fields["kernel_setup"])

    def to_json(self) -> str:
        """Return this course as text, for another process."""
        return json.dumps(asdict(self))

    @property
    def lessons(self) -> list[str]:
        """The lessons with exercises: a lesson by its number, 03, an assignment by its whole name."""
        return [folder.removeprefix(LESSON) for folder in self.folders]

    @property
    def path(self) -> Path:
        """The folder of the package."""
        spec = find_spec(self.package)
        if spec is None or spec.origin is None:
            raise ValueError(f"the course {self.package} is not installed")
        return Path(spec.origin).parent

    def folder_of(self, lesson: str) -> str:
        """Return the name of a lesson's folder. Raises ValueError if the lesson has no exercises."""
        for folder in self.folders:
            if folder.removeprefix(LESSON) == lesson:
                return folder
        raise ValueError(
            f"there are no exercises in a lesson {lesson!r}; the lessons with some are {', '.join(self.lessons)}"
        )

    def module_of(self, lesson: str) -> str:
        """Return the name of a lesson's package."""
        return f"{self.package}.{self.folder_of(lesson)}"

    def exercises_of(self, lesson: str) -> dict[str, Exercise | Question]:
        """Return the exercises of a lesson by name, in the order of its notebook; raises ValueError without any."""
        module = importlib.import_module(f"{self.module_of(lesson)}.exercises")
        exercises = {}
        for name, one in vars(module.check).items():
            if isinstance(one, Exercise | Question):
                exercises[name] = one
        return exercises


def title_of(lesson: str) -> str:
    """Return how reports call a lesson: lesson 03, assignment 1."""
    return lesson.replace("_", " ") if "_" in lesson else f"lesson {lesson}"
