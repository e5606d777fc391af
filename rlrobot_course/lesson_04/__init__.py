"""Lesson 04, SARSA.

`exercises` has a file for each exercise.
"""

from rlrobot_course.lesson_04.exercises import check as check
