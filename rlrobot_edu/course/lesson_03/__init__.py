"""Lesson 03, exploration.

`solutions` holds the right answers, `check` the exercises; `figures` draws ties, samples, units and rules side by
side; `temperature_slider` is a widget.
"""
