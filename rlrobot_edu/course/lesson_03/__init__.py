"""Lesson 03, exploration.

`exercises` has a file for each exercise; `figures` draws ties, samples, units and rules side by
side; `temperature_slider` is a widget.
"""
