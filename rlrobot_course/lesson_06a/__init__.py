"""Appendix 06a, the ideal behind true online SARSA(λ), and how large α may be.

`exercises` holds right answers, a page (`.md`) asks for each. The ideal itself and the figures are those of lesson 06.
"""

from rlrobot_course.lesson_06a.exercises import check as check
