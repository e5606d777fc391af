"""Lesson 12a, a reward that can be milked.

`exercises` holds right answers, a page (`.md`) asks for each, `reward_exercise` judges a reward by all loops that the
arm can drive. `loops` finds the loop that pays most, `runs` lets many arms learn, `contact` is the task with a reward
for contact alone, and `figures` draws an episode and what many arms come to.
"""

from rlrobot_course.lesson_12a.exercises import check as check
