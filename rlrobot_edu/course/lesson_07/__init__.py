"""Lesson 07, QBIASSR.

`check` holds the exercises; `arrivals` notes what an agent knows each time it comes to a state; `figures` draws what
the bias is worth then.
"""
