"""Lesson 07, QBIASSR.

`arrivals` notes what an agent knows each time it comes to a state; `figures` draws what the bias is worth then, for
lessons 07a and 07b as well.
"""

from rlrobot_course.lesson_07.exercises import check as check
