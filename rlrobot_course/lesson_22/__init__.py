"""Lesson 22, the bias again: four other biases, and what a blind robot earns."""

from rlrobot_course.lesson_22.exercises import check as check
