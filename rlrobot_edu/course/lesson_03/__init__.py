"""Lesson 03, exploration.

`check` holds the exercises; `figures` draws ties, samples, units and rules side by side; `temperature_slider` is a
widget.
"""
