"""Lesson 09, TOSL+QBIASSR as a whole.

`solutions` holds the right answers, `check` the exercises (the learners in `learners`, the worlds they are tried in in
`worlds`); `figures` draws what robots that were watched have earned.
"""
