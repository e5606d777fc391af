"""Lesson 10, TOSL+QBIASSR as a whole.

What the exercises share stands in `given`, the world that they are tried in in `worlds`. `speed` measures how long a
step takes.
"""

from rlrobot_course.lesson_10.exercises import check as check
