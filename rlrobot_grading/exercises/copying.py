"""What is told to a function that changes an argument which it should only read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

NEW_ARRAY = "or write x = x - y, a new array, where x -= y changes the old one."
CHANGEABLE = (np.ndarray, list, dict, set)


def work_on_a_copy(name: str, value: Any) -> str:
    """The remedy, for an argument of this name and value."""
    return f"work on a copy, as in {_copied(name, value)}; {NEW_ARRAY}"


def _copied(name: str, value: Any) -> str:
    """The line that copies an argument with all in it that can be changed."""
    parts = _parts(value)
    if not any(isinstance(part, CHANGEABLE) for part in parts):
        return f"{name} = {name}.copy()"
    if isinstance(value, list) and not any(
        isinstance(inner, CHANGEABLE) for part in parts for inner in _parts(part)
    ):
        return f"{name} = [one.copy() for one in {name}]"
    return f"{name} = copy.deepcopy({name}), with import copy in a cell above"


def _parts(value: Any) -> list[Any]:
    """What a list or a dictionary holds; numbers and arrays hold nothing that is to be copied for itself."""
    if isinstance(value, Mapping):
        return list(value.values())
    return list(value) if isinstance(value, list | tuple) else []
