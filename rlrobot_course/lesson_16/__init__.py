"""Lesson 16, planning: a robot thinks between its steps, at random or of what has changed."""
