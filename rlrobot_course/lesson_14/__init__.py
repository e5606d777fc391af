"""Lesson 14, sample models: a recording becomes a world to learn in, quick, and as small as what was seen."""

from rlrobot_course.lesson_14.exercises import check as check
