"""The exercises of lesson 13, gathered from their files."""

from rlrobot_edu.course.lesson_13.exercises.enough import exercise as enough
from rlrobot_edu.course.lesson_13.exercises.estimate import exercise as estimate
from rlrobot_edu.course.lesson_13.exercises.sample import exercise as sample
from rlrobot_edu.course.lesson_13.exercises.second_look import exercise as second_look

__all__ = ["enough", "estimate", "sample", "second_look"]
