"""The exercises of assignment 5, gathered from their files."""

from rlrobot_course.assignment_5.exercises.inputs import exercise as inputs
from rlrobot_course.assignment_5.exercises.interval import exercise as interval
from rlrobot_course.assignment_5.exercises.park_reward import exercise as park_reward
from rlrobot_course.assignment_5.exercises.value_of import exercise as value_of
from rlrobot_course.assignment_5.exercises.verdict import exercise as verdict

__all__ = ["inputs", "interval", "park_reward", "value_of", "verdict"]
