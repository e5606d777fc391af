"""Lesson 07, QBIASSR.

`solutions` holds the right answers, `check` the exercises; `arrivals` notes what an agent knows each time it comes to
a state; `figures` draws what the bias is worth then.
"""
