"""Lesson 12, an arm at a table, and one on wheels.

`exercises` holds right answers, a page (`.md`) asks for each; `figures` draws the arm. The arm of geometry, with the
learner's own formula in it, is `course.arm_world`, which lesson 12a uses, too.
"""

from rlrobot_course.lesson_12.exercises import check as check
