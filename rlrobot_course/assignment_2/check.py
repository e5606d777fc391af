"""The exercises of assignment 2, gathered from their files."""

from rlrobot_course.assignment_2.exercises.double_learn import exercise as double_learn
from rlrobot_course.assignment_2.exercises.double_update import exercise as double_update
from rlrobot_course.assignment_2.exercises.epsilon_at import exercise as epsilon_at
from rlrobot_course.assignment_2.exercises.policy_value import exercise as policy_value
from rlrobot_course.assignment_2.exercises.who import exercise as who

__all__ = ["double_learn", "double_update", "epsilon_at", "policy_value", "who"]
