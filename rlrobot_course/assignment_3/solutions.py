"""The solutions of assignment 3, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.assignment_3.exercises.n_step_return import n_step_return
from rlrobot_course.assignment_3.exercises.td_episode import td_episode
from rlrobot_course.assignment_3.exercises.trace_after import trace_after
from rlrobot_course.assignment_3.exercises.true_online_episode import true_online_episode
from rlrobot_course.assignment_3.exercises.watkins_update import watkins_update

__all__ = ["n_step_return", "trace_after", "td_episode", "true_online_episode", "watkins_update"]  # noqa: RUF022
