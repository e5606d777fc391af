"""Lesson 11, navigation.

`exercises` holds right answers, a page (`.md`) asks for each; `episodes` drives a robot episode by episode, `worlds`
holds a corridor in which to and fro pays and a robot that is paid by the learner's own function, `figures` draws
values as maps.
"""

from rlrobot_course.lesson_11.exercises import check as check
