"""A person drives the robot, and what was driven is a recording that teaches an agent.

keys.py  which key does which action, and where its button stands
page.py  what the page does by itself: keys press buttons
pad.py   `teleoperate`: the robot, its buttons and its picture
teaching.py  `learn_from`: an agent learns from what was driven, or recorded by anybody
"""
