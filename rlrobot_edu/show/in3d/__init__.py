"""Scenes in three dimensions, in meshcat: the extra ``notebook``.

visualizer.py   `meshcat` and `show_scene`: begin here
looks.py        what the parts of a scene look like in meshcat
camera.py       where the camera stands, and the light
window.py       what the visualizer talks to instead of a server, and its page (page.html)
replay.py       the places of a film, packed (replay.js)
story.py        what its page tells: headline, moments, key (story.js)
bar.js          the page's own part: what it is told, and time
chase.js        camera and mouse; map.js: a film from above; chart.js: the curve of the rewards; begin.js: it begins
page_widget.py  the page in a notebook, which receives what is new (frame.js)
"""

import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

from rlrobot_edu.installing import to_install

_spec = find_spec("meshcat")
if _spec is None or _spec.origin is None:
    raise ImportError(
        f"3D views need meshcat: run {to_install('notebook')}; everything else works without it"
    )
MESHCAT = Path(_spec.origin).parent
# In a browser there is no place for meshcat's server, which it imports; we never start it.
if sys.platform == "emscripten":
    sys.modules["zmq"] = SimpleNamespace(Context=object)  # type: ignore[assignment]
    sys.modules["meshcat.servers.zmqserver"] = SimpleNamespace(
        start_zmq_server_as_subprocess=None
    )  # type: ignore[assignment]
