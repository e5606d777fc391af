"""The exercises of lesson 08, gathered from their files."""

from rlrobot_course.lesson_08.exercises.new_temperature import exercise as new_temperature
from rlrobot_course.lesson_08.exercises.push import exercise as push
from rlrobot_course.lesson_08.exercises.redundancy import exercise as redundancy
from rlrobot_course.lesson_08.exercises.steps_to_the_cap import exercise as steps_to_the_cap

__all__ = ["new_temperature", "push", "redundancy", "steps_to_the_cap"]
