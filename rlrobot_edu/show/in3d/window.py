"""What a meshcat visualizer talks to here: no server, but the commands so far, for a page and for whoever listens."""

from __future__ import annotations

import base64
import html
import io
import json
import zlib
from collections.abc import Callable
from importlib.resources import files
from string import Template
from typing import Any

import umsgpack
from PIL import Image

from rlrobot_edu.show.in3d import MESHCAT
from rlrobot_edu.show.in3d.photograph import photograph

Key = tuple[
    str, str, str
]  # path, kind and property of a command; one that comes later takes its place
ORDER = (
    "set_object",
    "set_transform",
    "set_property",
    "set_animation",
)  # what is said of an object comes after it
NO_SERVER = "this view has no server: show it in a notebook, or write its page with save('scene.html')"


class Window:
    """Keeps the last command of each kind for each place of the scene.

    title: the view in words; rewards: of the steps so far, for the bar below the picture
    listeners: called with each command, as meshcat's viewer reads it
    """

    def __init__(self, title: str) -> None:
        self.title, self.rewards = title, list[float]()
        self.listeners: list[Callable[[Key, bytes], None]] = []
        self._kept: dict[Key, bytes] = {}

    def send(self, command: Any) -> None:
        """Take one of meshcat's commands."""
        told = command.lower()
        key = told["path"], told["type"], told.get("property", "")
        packed = umsgpack.packb(told)
        if told["type"] == "delete":
            self._kept = {
                k: v
                for k, v in self._kept.items()
                if not f"{k[0]}/".startswith(f"{told['path']}/")
            }
        else:
            self._kept[key] = packed
        for tell in self.listeners:
            tell(key, packed)

    def commands(self) -> list[tuple[Key, bytes]]:
        """All that a page needs which comes now."""
        return sorted(self._kept.items(), key=lambda item: ORDER.index(item[0][1]))

    def page(self, *, live: bool = False) -> str:
        """A stand-alone HTML page, whose bytes are packed; live: the page around it says what to show."""
        template, script = (
            files(__package__).joinpath(name).read_text("utf-8")
            for name in ("page.html", "bar.js")
        )
        library = (MESHCAT / "viewer/dist/main.min.js").read_text("utf-8")
        commands = (
            []
            if live
            else [base64.b64encode(packed).decode() for _, packed in self.commands()]
        )
        packed = zlib.compress(
            json.dumps([library, commands, self.rewards]).encode(), 9
        )
        return Template(template).substitute(
            title=html.escape(self.title),
            packed=base64.b64encode(packed).decode(),
            script=script,
        )

    get_scene = page  # by this name meshcat asks for a page

    def get_image(self) -> Image.Image:
        """The picture, by a Chromium that is installed. Raises RuntimeError where there is none."""
        return Image.open(io.BytesIO(photograph(self.page())))

    @property
    def web_url(self) -> str:
        """Raises RuntimeError: nothing listens."""
        raise RuntimeError(NO_SERVER)

    def open(self) -> None:
        """Raises RuntimeError: nothing listens."""
        raise RuntimeError(NO_SERVER)

    wait = open
