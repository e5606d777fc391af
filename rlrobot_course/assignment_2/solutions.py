"""The solutions of assignment 2, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.assignment_2.exercises.double_learn import double_learn
from rlrobot_course.assignment_2.exercises.double_update import double_update
from rlrobot_course.assignment_2.exercises.epsilon_at import epsilon_at
from rlrobot_course.assignment_2.exercises.policy_value import policy_value
from rlrobot_course.assignment_2.exercises.who import who

__all__ = ["epsilon_at", "policy_value", "who", "double_update", "double_learn"]  # noqa: RUF022
