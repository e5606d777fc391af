"""Lesson 02, Q-learning.

`exercises` has one file an exercise, which `solutions` and `check` gather; `given` is what the loop of the last one
calls.
"""

from rlrobot_course.lesson_02.exercises import check as check
