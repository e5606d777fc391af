"""The exercises of lesson 03, gathered from their files."""

from rlrobot_course.lesson_03.exercises.by_hand import exercise as by_hand
from rlrobot_course.lesson_03.exercises.draw import exercise as draw
from rlrobot_course.lesson_03.exercises.epsilon_greedy import exercise as epsilon_greedy
from rlrobot_course.lesson_03.exercises.softmax import exercise as softmax

__all__ = ["by_hand", "draw", "epsilon_greedy", "softmax"]
