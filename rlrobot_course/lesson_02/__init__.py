"""Lesson 02, Q-learning.

`exercises` holds right answers, a page (`.md`) asks for each.
"""

from rlrobot_course.lesson_02.exercises import check as check
