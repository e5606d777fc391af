"""Lesson 08a, when heat helps.

`exercises` has a file for each question; `figures` draws how long robots are caught.
"""

from rlrobot_course.lesson_08a.exercises import check as check
