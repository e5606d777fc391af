"""Lesson 09, TOSL+QBIASSR as a whole.

`check` holds the exercises; `figures` shuffles labels to say what a p-value means.
"""
