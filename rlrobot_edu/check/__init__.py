"""Checks for the exercises of the course: one module a lesson, one name an exercise.

    from rlrobot_edu.check import lesson_02 as check
    check.update(update)

A check replays a recorded tape on the learner's function. It never raises: it waits, it says that all is right, or it
names the first wrong step with what was expected, what came out, and a hint at the likely cause.
"""
