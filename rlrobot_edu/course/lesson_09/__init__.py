"""Lesson 09, TOSL+QBIASSR as a whole.

`solutions` holds the right answers, `check` the exercises; `figures` shuffles labels to say what a p-value means.
"""
