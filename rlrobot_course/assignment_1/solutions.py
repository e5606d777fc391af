"""The solutions of assignment 1, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.assignment_1.exercises.greedy import greedy
from rlrobot_course.assignment_1.exercises.replay import replay
from rlrobot_course.assignment_1.exercises.returns import returns
from rlrobot_course.assignment_1.exercises.state_of import state_of
from rlrobot_course.assignment_1.exercises.train import train

__all__ = ["state_of", "returns", "replay", "greedy", "train"]  # noqa: RUF022
