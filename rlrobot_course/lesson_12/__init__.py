"""Lesson 12, navigation.

`episodes` drives a robot episode by episode, `worlds` holds a corridor in which to and fro pays, `room` draws ways
into the room, and `figures` the corridor.
"""

from rlrobot_course.lesson_12.exercises import check as check
