"""Lesson 01a, returns and values.

`exercises` has a file for each exercise; `figures` draws how values spread through a grid.
"""

from rlrobot_course.lesson_01a.exercises import check as check
