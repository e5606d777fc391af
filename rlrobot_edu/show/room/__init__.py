"""A room from above on a page's canvas, and the look that all pages share.

room.js         the drawing, for any page; how to use it stands at its top
scene_data.py   what room.js draws, as JSON: walls, solids, beams, the robot's place
tokens.py       colours of `show/palette.py` as CSS, light and dark
look.css        type, buttons, cards and the mark of the keyboard's place
"""
