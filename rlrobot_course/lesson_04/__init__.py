"""Lesson 04, exploration; `figures` shows how an action is drawn, and what rules of exploration earn.

`handles` lets the reader move u, ε and T; chances.js is its picture.
"""

from rlrobot_course.lesson_04.exercises import check as check
