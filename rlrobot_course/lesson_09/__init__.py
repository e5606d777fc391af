"""Lesson 09, TOSL+QBIASSR as a whole.

`exercises` has a file for each exercise; what they share stands in `given`, the mistakes of both learners in
`learners`, the worlds that they are tried in in `worlds`. `figures` draws what robots that were watched have earned.
"""

from rlrobot_course.lesson_09.exercises import check as check
