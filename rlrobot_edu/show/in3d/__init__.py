"""Scenes in three dimensions, drawn by three.js in the browser, which meshcat brings: the extra ``view3d``.

views.py   `SceneView`, a still or a replay: begin here
feed.py    what a page is told of a scene
window.py  the page (page.html), whole or told what is new
room.js    what room, things and robots look like: shapes, materials, lamps
reward.js  the trail in the colours of its rewards, the curve of their moving average
player.js  time, camera and pointer: replay, live (widgets/live_view.py), chase, beams, caption
keys.js    a replay's buttons, keys and links, and what a screen reader hears of it
"""

from importlib.util import find_spec
from pathlib import Path

_spec = find_spec("meshcat")
if _spec is None or _spec.origin is None:
    raise ImportError("3D views need meshcat: run pip install 'rlrobot-edu[view3d]'; everything else works without it")
MESHCAT = Path(_spec.origin).parent  # not imported: it would import its server, for which a browser has no place
