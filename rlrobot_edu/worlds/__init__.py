"""Worlds of one's own: rooms that are drawn with characters in a task's file.

Drawing   a room and where a robot starts in it: what the characters say, and what they come to in metres (drawing.py)

It stands below the tasks, whose scene it can be, and imports nothing of ours. `robots.arenas.arena_of` builds it.
"""
