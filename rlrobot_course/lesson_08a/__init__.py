"""Appendix 08a, the ideal behind true online SARSA(λ), and how large α may be. Its figures are those of lesson 08."""

from rlrobot_course.lesson_08a.exercises import check as check
