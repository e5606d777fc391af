"""Lesson 02, returns and values; `figures` draws how values spread through a grid.

`handles` with gamma.js and sweeps.js lets the reader move the discount rate and the sweeps.
"""

from rlrobot_course.lesson_02.exercises import check as check
