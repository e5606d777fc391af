"""Lesson 19, who paid: of which rewards a value is made. `figures` draws what one reward has paid."""

from rlrobot_course.lesson_19.exercises import check as check
