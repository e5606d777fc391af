"""The solutions of lesson 14, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_14.exercises.agents_needed import agents_needed
from rlrobot_course.lesson_14.exercises.f_ratio import f_ratio
from rlrobot_course.lesson_14.exercises.p_value import p_value

__all__ = ["agents_needed", "f_ratio", "p_value"]
