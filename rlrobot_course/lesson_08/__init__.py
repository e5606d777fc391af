"""Lesson 08, loop evasion.

`exercises` has a file for each exercise; `figures` draws a loop, and the way out of it.
"""

from rlrobot_course.lesson_08.exercises import check as check
