"""Lesson 14, the paper's experiments and what they prove.

`solutions` holds the right answers, `check` the exercises; `figures` shuffles labels to say what a p-value means, and
draws few agents of many to say what few can show.
"""
