"""Lesson 13a, a reward that can be milked.

`reward_exercise` judges a reward by all loops that the arm can drive. `loops` finds the loop that pays most, `runs`
lets many arms learn, `contact` is the task with a reward for contact alone, and `figures` draws what they come to.
"""

from rlrobot_course.lesson_13a.exercises import check as check
