"""Lesson 12, navigation.

`episodes` drives a robot episode by episode, `worlds` holds a corridor in which to and fro pays, and `figures` draws
values as maps.
"""

from rlrobot_course.lesson_12.exercises import check as check
