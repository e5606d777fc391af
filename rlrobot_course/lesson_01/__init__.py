"""Lesson 01, states, actions, rewards; `figures` draws the bins that readings fall into.

`handles` with cuts.js lets the reader move the cut points.
"""

from rlrobot_course.lesson_01.exercises import check as check
