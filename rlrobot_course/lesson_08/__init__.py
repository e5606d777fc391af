"""Lesson 08, loop evasion.

`exercises` holds right answers, a page (`.md`) asks for each; `figures` draws a loop, and the way out of it.
"""

from rlrobot_course.lesson_08.exercises import check as check
