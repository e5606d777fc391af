"""Lesson 15, the paper's experiments and what they prove.

`figures` shuffles labels to say what a p-value means, and draws few agents of many to say what few can show;
`whole_paper` compares all of the paper's differences with the report's.
"""

from rlrobot_course.lesson_15.exercises import check as check
