"""Lesson 01, states, actions, rewards.

`exercises` holds right answers, a page (`.md`) asks for each; `figures` draws bins and the spread of values.
"""

from rlrobot_course.lesson_01.exercises import check as check
