"""Lesson 10, TOSL+QBIASSR as a whole.

What the exercises share stands in `fixtures`, the world that they are tried in in `worlds`; `drive` lets a robot
drive by the learner's functions.
"""

from rlrobot_course.lesson_10.exercises import check as check
