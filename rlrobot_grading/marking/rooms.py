"""The rooms that hold exercises: a lesson's, `lesson_03`, goes by its number, 02; an assignment's by its whole name."""

from pathlib import Path

COURSE = Path(__file__).parents[2] / "rlrobot_course"
LESSONS = sorted(
    path.parent.name.removeprefix("lesson_") for path in COURSE.glob("*/exercises.py")
)


def room_of(lesson: str) -> str:
    """The name of a room: of 02 lesson_03, of assignment_1 itself."""
    return lesson if lesson.startswith("assignment_") else f"lesson_{lesson}"
