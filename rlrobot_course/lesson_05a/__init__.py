"""Lesson 05a, the register: how many traces are enough, and which λ gives how long a memory.

`exercises` holds right answers, a page (`.md`) asks for each, `figures` draws the register.
"""

from rlrobot_course.lesson_05a.exercises import check as check
