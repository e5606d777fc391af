"""Lesson 10, the wandering robot.

`solutions` holds the right answers, `check` the exercises; `rings` draws what the lasers see and into which bins it
falls, `motions` what the wheels do with the robot, `situations` what an agent does in the states that it met most.
"""
