"""Pictures of a robot's world that are kept, by a painter of our own: the same scene gives the same bytes anywhere.

parts.py    what a room, things and robots are made of (meshcat draws the same parts)
mesh.py     the shapes as corners and faces
lens.py     from places in the scene to places on a picture: a map, or a camera that stands before the room
painter.py  faces, lines and shadows on a picture
room.py     a room and the robot in it: begin here
frames.py   the pictures of a film, each above a bar with its step and its reward
"""
