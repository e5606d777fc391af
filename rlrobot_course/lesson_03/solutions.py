"""The solutions of lesson 03, gathered from the files of its exercises, in the order of the notebook."""

from rlrobot_course.lesson_03.exercises.by_hand import by_hand
from rlrobot_course.lesson_03.exercises.draw import draw
from rlrobot_course.lesson_03.exercises.epsilon_greedy import epsilon_greedy
from rlrobot_course.lesson_03.exercises.softmax import softmax

__all__ = ["by_hand", "epsilon_greedy", "draw", "softmax"]  # noqa: RUF022
