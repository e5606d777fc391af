"""The exercises of lesson 16, gathered from their files."""

from rlrobot_edu.course.lesson_16.exercises.by_hand import exercise as by_hand
from rlrobot_edu.course.lesson_16.exercises.dyna import exercise as dyna
from rlrobot_edu.course.lesson_16.exercises.how_far import exercise as how_far
from rlrobot_edu.course.lesson_16.exercises.overlaps import exercise as overlaps
from rlrobot_edu.course.lesson_16.exercises.two_biases import exercise as two_biases

__all__ = ["by_hand", "dyna", "how_far", "overlaps", "two_biases"]
