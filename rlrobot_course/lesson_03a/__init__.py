"""Lesson 03a, temperatures, units and rules.

`temperature_slider` is a widget; `ties` counts where a learner walks that knows nothing yet; `figures` shows what units
do and which rule earns most.
"""

from rlrobot_course.lesson_03a.exercises import check as check
