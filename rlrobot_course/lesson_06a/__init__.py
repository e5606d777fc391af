"""Appendix 06a, the ideal behind true online SARSA(λ), and how large α may be. Its figures are those of lesson 06."""

from rlrobot_course.lesson_06a.exercises import check as check
