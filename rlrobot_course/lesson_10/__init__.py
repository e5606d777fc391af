"""Lesson 10, the wandering robot.

`exercises` has a file for each exercise; `rings` draws what the lasers see and into which bins it
falls, `motions` what the wheels do with the robot, `situations` what an agent does in the states that it met most.
"""
