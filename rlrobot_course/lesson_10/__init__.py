"""Lesson 10, the wandering robot.

`rings` draws what the lasers see and into which bins it falls, `motions` what the wheels do with the robot,
`situations` what an agent does in the states that it met most.
"""

from rlrobot_course.lesson_10.exercises import check as check
