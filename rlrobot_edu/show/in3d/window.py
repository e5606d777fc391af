"""What a meshcat visualizer talks to instead of a server: it keeps the commands, for a page and for listeners."""

from __future__ import annotations

import base64
import html
import json
import zlib
from collections.abc import Callable
from importlib.resources import files
from string import Template
from typing import Any

import umsgpack

from rlrobot_edu.show.in3d import MESHCAT
from rlrobot_edu.show.room.scene_data import room_script
from rlrobot_edu.show.room.tokens import tokens

# Path, kind and property of a command. A later command with the same key replaces it.
Key = tuple[str, str, str]
# An object comes before the other commands about it, and our camera before what a user says of it.
ORDER = (
    "set_object",
    "stands",
    "set_transform",
    "set_property",
    "set_animation",
    "replay",
)
SCRIPTS = (
    "bar.js",
    "story.js",
    "replay.js",
    "chart.js",
    "chase.js",
    "map.js",
    "begin.js",
)
NO_SERVER = "this view has no server: show it in a notebook, or write its page with save('scene.html')"


class Window:
    """Keeps the last command of each kind for each place of the scene.

    title: the view in words; rewards: of the steps so far, for the bar below the picture
    listeners: called with each command, as meshcat's viewer reads it
    """

    def __init__(self, title: str) -> None:
        self.title = title
        self.rewards: list[float] = []
        self.listeners: list[Callable[[Key, bytes], None]] = []
        self._kept: dict[Key, bytes] = {}

    def send(self, command: Any) -> None:
        """Take one of meshcat's commands."""
        self.take(command.lower())

    def take(self, fields: dict[str, Any]) -> None:
        """Take a command as the page reads it."""
        path, kind = fields["path"], fields["type"]
        key = (path, kind, fields.get("property", ""))
        packed = umsgpack.packb(fields)
        if kind == "delete":
            inside = [other for other in self._kept if _is_in(other[0], path)]
            for other in inside:
                del self._kept[other]
        else:
            self._kept[key] = packed
        for tell in self.listeners:
            tell(key, packed)

    def commands(self) -> list[tuple[Key, bytes]]:
        """All commands that a page needs which is opened now."""
        return sorted(self._kept.items(), key=lambda item: ORDER.index(item[0][1]))

    def packed(self) -> bytes:
        """All commands that a page needs which is opened now, as one piece."""
        return zlib.compress(umsgpack.packb([told for _, told in self.commands()]), 9)

    def page(self) -> str:
        """A stand-alone HTML page, whose content is packed."""
        return _page(self.title, self.packed(), self.rewards)

    get_scene = page  # by this name meshcat asks for a page

    @property
    def web_url(self) -> str:
        """Raises RuntimeError: nothing listens."""
        raise RuntimeError(NO_SERVER)

    def open(self) -> None:
        """Raises RuntimeError: nothing listens."""
        raise RuntimeError(NO_SERVER)

    wait = get_image = open


def live_page() -> str:
    """The page without a scene: it shows what the page around it sends."""
    return _page("A robot in 3D", b"", [])


def _page(title: str, packed: bytes, rewards: list[float]) -> str:
    folder = files(__package__)
    template = folder.joinpath("page.html").read_text("utf-8")
    scripts = [folder.joinpath(name).read_text("utf-8") for name in SCRIPTS]
    library = (MESHCAT / "viewer/dist/main.min.js").read_text("utf-8")
    return Template(template).substitute(
        title=html.escape(title),
        library=_as_text(zlib.compress(library.encode(), 9)),
        scene=_as_text(packed),
        rewards=json.dumps(rewards),
        colours=tokens().replace(
            "html:has(> body.rl-look), :not(body).rl-look", ":root"
        ),
        script="\n".join([room_script(), *scripts]),
    )


def _is_in(path: str, folder: str) -> bool:
    """Whether a path is this folder or lies in it."""
    return f"{path}/".startswith(f"{folder}/")


def _as_text(packed: bytes) -> str:
    return base64.b64encode(packed).decode()
