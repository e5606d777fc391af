"""A person drives the robot; the steps are a recording, from which an agent can learn.

keys.py  the key of each action, and the place of its button
page.py  what the page does by itself: keys press buttons
pad.py   `teleoperate`: the robot, its buttons and its picture
teaching.py  `learn_from`: an agent learns from a recording, of a drive or of any other source
"""
