"""Lesson 05, QBIASSR.

`arrivals` notes what an agent knows each time it comes to a state; `figures` draws what the bias is worth then, for
lessons 05a and 05b as well.
"""

from rlrobot_course.lesson_05.exercises import check as check
