"""Connections to a robot: what each kind can do, and their names."""

import importlib
import inspect
from collections.abc import Callable, Sequence
from typing import Any, Protocol

from rlrobot_edu.checks import check_name, did_you_mean

LINKS = {"rosbridge": "rosbridge:Rosbridge", "dds": "dds:Dds"}


class Connection(Protocol):
    """One end of a way on which messages come and go. It is open from the beginning, until `close`.

    lost: why nothing comes or goes any more, in words; None while all is well
    """

    lost: str | None

    @property
    def complaints(self) -> Sequence[str]:
        """The latest complaints of the other side about what it was asked for."""

    def make(self, kind: str, **fields: Any) -> Any:
        """A message, or a part of one, of this kind with these fields (see messages.py)."""

    def hear(self, topic: str, kind: str, callback: Callable[[Any], None]) -> None:
        """From now on call `callback` with each message of this topic, in a thread of the connection's own."""

    def speak(self, topic: str, kind: str) -> Callable[[Any], None]:
        """A function that sends a message to this topic. It raises ConnectionError if the connection is lost."""

    def close(self) -> None:
        """End it; what was sent before still goes out. Nothing is heard after that, and nothing is left running."""


def connect(link: str, **where: Any) -> Connection:
    """A connection by the name of its kind.

    where: arguments of the connection's class

    Raises ValueError for an unknown name or argument, ImportError if what it needs is not installed (it says what to
    install), ConnectionError if nobody is there.
    """
    if link not in LINKS:
        raise ValueError(
            f"no link is called {link!r:.200}; {did_you_mean(link, LINKS)}there are {', '.join(LINKS)}"
        )
    module, name = LINKS[link].split(":")
    kind: Callable[..., Connection] = getattr(
        importlib.import_module(f"{__package__}.{module}"), name
    )
    for argument in where:
        check_name(argument, inspect.signature(kind).parameters, "argument", link)
    return kind(**where)
