"""The solutions of lesson 05a, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_05a.exercises.lam_for import lam_for
from rlrobot_course.lesson_05a.exercises.n_traces import n_traces

__all__ = ["n_traces", "lam_for"]  # noqa: RUF022
