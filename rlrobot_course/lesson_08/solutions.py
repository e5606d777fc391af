"""The solutions of lesson 08, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_08.exercises.new_temperature import new_temperature
from rlrobot_course.lesson_08.exercises.push import push
from rlrobot_course.lesson_08.exercises.redundancy import redundancy
from rlrobot_course.lesson_08.exercises.steps_to_the_cap import steps_to_the_cap

__all__ = ["push", "redundancy", "new_temperature", "steps_to_the_cap"]  # noqa: RUF022
