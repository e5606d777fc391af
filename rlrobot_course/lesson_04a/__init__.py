"""Lesson 04a, temperatures, units and rules.

`ties` counts where a learner walks that knows nothing yet; `figures` shows what the temperature and units do, and which
rule earns most.
"""

from rlrobot_course.lesson_04a.exercises import check as check
