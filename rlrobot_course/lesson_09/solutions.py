"""The solutions of lesson 09, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_09.exercises.choose import choose
from rlrobot_course.lesson_09.exercises.learn import learn
from rlrobot_course.lesson_09.exercises.learn_and_evade import learn_and_evade
from rlrobot_course.lesson_09.exercises.preferences import preferences

__all__ = ["preferences", "choose", "learn", "learn_and_evade"]  # noqa: RUF022
