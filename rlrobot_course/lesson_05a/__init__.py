"""Appendix 05a, when the bias misleads. Its figures are those of lesson 05."""

from rlrobot_course.lesson_05a.exercises import check as check
