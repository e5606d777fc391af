"""The solutions of lesson 15a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_15a.exercises.last_action import last_action
from rlrobot_course.lesson_15a.exercises.learn_from import learn_from
from rlrobot_course.lesson_15a.exercises.two_targets import two_targets

__all__ = ["learn_from", "two_targets", "last_action"]  # noqa: RUF022
