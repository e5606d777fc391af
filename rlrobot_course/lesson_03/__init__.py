"""Lesson 03, Q-learning.

`figures` draws how a number of the table develops; `handles` with alpha.js and corridor.js lets the reader move the
learning rate, and drives down a corridor.
"""

from rlrobot_course.lesson_03.exercises import check as check
