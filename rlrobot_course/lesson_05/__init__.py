"""Lesson 05, QBIASSR. `figures` draws which states have a say, `challenge` tries a bias of the learner's own."""

from rlrobot_course.lesson_05.exercises import check as check
