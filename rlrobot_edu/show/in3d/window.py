"""The page that draws scenes: offline, or told what is new.

meshcat gives three.js and its camera's controls to it, nothing else.
"""

import html
import json
from importlib.resources import files
from string import Template

from rlrobot_edu.show.in3d import MESHCAT
from rlrobot_edu.show.in3d.feed import Told


def page(title: str, feed: Told) -> str:
    """A stand-alone HTML page; title: what is to be seen, in words.

    feed: a ``room`` and its ``frames``, each of them ``seconds`` long; or ``live``: the
        page around this one tells them
    """
    names = ("page.html", "room.js", "reward.js", "player.js", "keys.js")
    template, *scripts = (files(__package__).joinpath(name).read_text(encoding="utf-8") for name in names)
    library = (MESHCAT / "viewer/dist/main.min.js").read_text(encoding="utf-8")
    # "</script" and "<!--" would end the script element too early or too late
    told = json.dumps(feed).replace("<", "\\u003c")
    return Template(template).substitute(title=html.escape(title), library=library, feed=told, scripts="".join(scripts))
