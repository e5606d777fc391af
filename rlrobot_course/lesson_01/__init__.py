"""Lesson 01, states, actions, rewards.

`exercises` has a file for each exercise; `figures` draws bins and the spread of values.
"""

from rlrobot_course.lesson_01.exercises import check as check
