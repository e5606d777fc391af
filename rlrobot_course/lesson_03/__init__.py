"""Lesson 03, exploration.

`exercises` holds right answers, a page (`.md`) asks for each; `figures` draws how an action is drawn.
"""

from rlrobot_course.lesson_03.exercises import check as check
