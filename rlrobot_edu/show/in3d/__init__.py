"""Scenes in three dimensions, in meshcat: the extra ``lab``.

visualizer.py  `meshcat` and `show_scene`: begin here
looks.py       what room, things and robots look like
window.py      what the visualizer talks to instead of a server, and its page (page.html)
bar.js         the page's own part: time, chase camera, curve of the rewards
page_widget.py     the page in a notebook, told what is new (frame.js)
photograph.py  a picture of a page
"""

import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

_spec = find_spec("meshcat")
if _spec is None or _spec.origin is None:
    raise ImportError(
        "3D views need meshcat: run pip install meshcat; everything else works without it"
    )
MESHCAT = Path(_spec.origin).parent
if (
    sys.platform == "emscripten"
):  # meshcat imports its server, for which a browser has no place; it is never started
    sys.modules["zmq"] = SimpleNamespace(Context=object)  # type: ignore[assignment]
    sys.modules["meshcat.servers.zmqserver"] = SimpleNamespace(
        start_zmq_server_as_subprocess=None
    )  # type: ignore[assignment]
