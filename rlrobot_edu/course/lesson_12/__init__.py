"""Lesson 12, an arm at a table, and a reward that can be milked.

`exercises` has a file for each exercise, `reward_exercise` judges a reward by all loops that the arm
can drive. `arm_world` is the arm as geometry alone, with the learner's own formula in it; `loops` finds the loop that
pays most, `runs` lets many arms learn. `figures` draws all of them.
"""
