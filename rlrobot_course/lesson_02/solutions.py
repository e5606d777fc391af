"""The solutions of lesson 02, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_02.exercises.by_hand import by_hand
from rlrobot_course.lesson_02.exercises.learn import learn
from rlrobot_course.lesson_02.exercises.target import target
from rlrobot_course.lesson_02.exercises.update import update

__all__ = ["by_hand", "target", "update", "learn"]  # noqa: RUF022
