"""The exercises of lesson 15a, gathered from their files."""

from rlrobot_course.lesson_15a.exercises.last_action import exercise as last_action
from rlrobot_course.lesson_15a.exercises.learn_from import exercise as learn_from
from rlrobot_course.lesson_15a.exercises.two_targets import exercise as two_targets

__all__ = ["last_action", "learn_from", "two_targets"]
