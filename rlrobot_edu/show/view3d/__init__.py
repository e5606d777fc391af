"""Scenes in three dimensions, drawn by meshcat (three.js) in the browser; all that needs meshcat is in here.

views.py    `SceneView`, a still or a replay, and `LiveView`: begin here
drawing.py  a scene as meshcat's bodies, lights and key frames
window.py   where the drawing commands go: into `page.html`, or to browsers that look on
"""

try:
    import meshcat  # noqa: F401
except ImportError as error:
    raise ImportError("3D views need meshcat: pip install meshcat; everything else works without it") from error
