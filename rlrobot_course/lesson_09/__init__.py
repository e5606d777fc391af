"""Lesson 09, loop evasion; `figures` draws a loop, and what the way out of it is worth.

`queues` draws what the rule sees in two robots' queues; `handles` lets the reader move along it, drawn by loops.js.
"""

from rlrobot_course.lesson_09.exercises import check as check
