"""The robot that nobody has seen: the final project of the course (docs/unknown_robot.md).

secret.py    `unlock`: what a secret stands for: weaknesses and a wall
body.py      `SecretBody`, the robot that has them and logs its true rewards
scoring.py   `score`: a signed log between chance and the best that we can find for such a robot
commands.py  ``serve-robot`` and ``score``
"""
