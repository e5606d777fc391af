"""The exercises of lesson 14, gathered from their files."""

from rlrobot_course.lesson_14.exercises.agents_needed import exercise as agents_needed
from rlrobot_course.lesson_14.exercises.f_ratio import exercise as f_ratio
from rlrobot_course.lesson_14.exercises.p_value import exercise as p_value

__all__ = ["agents_needed", "f_ratio", "p_value"]
