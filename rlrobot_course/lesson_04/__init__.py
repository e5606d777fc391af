"""Lesson 04, SARSA.

`exercises` holds right answers, a page (`.md`) asks for each.
"""

from rlrobot_course.lesson_04.exercises import check as check
