"""Appendix 07a, when the bias misleads.

`exercises` holds the right answer, `best_adviser.md` asks for it. The figures are those of lesson 07.
"""

from rlrobot_course.lesson_07a.exercises import check as check
