"""Lesson 16, your own task.

`situations` are those on which a reward for wall following is tried; `files` writes task files to play with, sound ones
and odd ones; `drive` lets a robot learn by the learner's reward.
"""

from rlrobot_course.lesson_16.exercises import check as check
