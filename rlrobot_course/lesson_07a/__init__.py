"""Appendix 07a, when the bias misleads. Its figures are those of lesson 07."""

from rlrobot_course.lesson_07a.exercises import check as check
