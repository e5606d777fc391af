"""Lesson 11, the wandering robot.

`rings` draws what the lasers see and into which bins it falls, `motions` what the wheels do with the robot,
`situations` what an agent does in the states that it met most.
"""

from rlrobot_course.lesson_11.exercises import check as check
