"""Lesson 13, an arm at a table and a reward that can be milked.

`reward_exercise` judges a reward by all loops that the arm can drive. `loops` finds the loop that pays most, `runs`
lets many arms learn, `contact` is the task with a reward for contact alone, `arm_figure` and `figures` draw the arm,
and `many` what thirty of them come to. The arm of geometry, with the learner's own formula in it, is `arm_world`.
"""

from rlrobot_course.lesson_13.exercises import check as check
