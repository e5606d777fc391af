"""Lesson 13, sample models: a recording becomes a world to learn in, quick, and as small as what was seen."""

from rlrobot_course.lesson_13.exercises import check as check
