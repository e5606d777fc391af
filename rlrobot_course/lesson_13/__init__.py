"""Lesson 13, an arm at a table, and one on wheels; `figures` draws the arm.

The arm of geometry, with the learner's own formula in it, is `arm_world`, which lesson 13a uses, too.
"""

from rlrobot_course.lesson_13.exercises import check as check
