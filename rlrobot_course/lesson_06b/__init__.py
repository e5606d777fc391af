"""Lesson 06b, what exactness is worth.

`exercises` holds right answers, a page (`.md`) asks for each. Its ideal, its figures and its laboratory are those of
lesson 06.
"""

from rlrobot_course.lesson_06b.exercises import check as check
