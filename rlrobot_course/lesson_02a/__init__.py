"""Lesson 02a, what α and γ do.

`exercises` holds right answers, a page (`.md`) asks for each; `figures` follows one entry of the Q table.
"""

from rlrobot_course.lesson_02a.exercises import check as check
