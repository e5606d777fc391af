"""A robot that is to be mended: films of it, as it was given and mended."""

from rlrobot_course.drives.by_your_code import Reel, drive_of
from rlrobot_edu.show.film import Film
from rlrobot_grading.answers.values import Function
from rlrobot_grading.exercises.exercise import Exercise

SHOWN = 16  # steps: a notebook keeps the film


def broken(exercise: Exercise) -> Film:
    """The robot that drives by the function with the wrong line. Raises ValueError where none is given."""
    if exercise.given is None:
        raise ValueError(f"nothing is to be mended in {exercise.name}")
    return mended(exercise, exercise.given.wrong)


def mended(exercise: Exercise, answer: Function) -> Film:
    """The same robot, with the same luck, by another function, which must not fail.

    Raises ValueError where no robot drives by functions of this exercise.
    """
    drive = drive_of(exercise)
    if drive is None:
        raise ValueError(f"no robot drives by {exercise.name}")
    reel = Reel()
    drive(answer, reel)
    return Film.of(list(reel.shots)[:SHOWN])
