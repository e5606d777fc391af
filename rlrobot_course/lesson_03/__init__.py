"""Lesson 03, exploration.

`exercises` has a file for each exercise; `figures` draws how an action is drawn.
"""

from rlrobot_course.lesson_03.exercises import check as check
