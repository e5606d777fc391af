"""Lesson 09, TOSL+QBIASSR as a whole.

`exercises` holds right answers, a page (`.md`) asks for each; what they share stands in `given`, the worlds that they
are tried in in `worlds`. `figures` draws what robots that were watched have earned.
"""

from rlrobot_course.lesson_09.exercises import check as check
