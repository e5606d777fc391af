"""Lesson 16, your own task.

`situations` are those on which a reward for wall following is tried; `files` writes task files to play with, sound ones
and odd ones; `figures` shows what three sets of cut points lead to.
"""

from rlrobot_course.lesson_16.exercises import check as check
