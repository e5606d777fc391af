"""The exercises of assignment 1, gathered from their files."""

from rlrobot_course.assignment_1.exercises.greedy import exercise as greedy
from rlrobot_course.assignment_1.exercises.replay import exercise as replay
from rlrobot_course.assignment_1.exercises.returns import exercise as returns
from rlrobot_course.assignment_1.exercises.state_of import exercise as state_of
from rlrobot_course.assignment_1.exercises.train import exercise as train

__all__ = ["greedy", "replay", "returns", "state_of", "train"]
