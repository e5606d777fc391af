"""Values as text: what a kernel sends to the grader. Of a learner's objects nothing but data arrives, never code."""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Mapping
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import (
    CONTAINERS,
    Unkept,
    as_data,
    is_large,
    safely,
    show,
)

LONGEST = 1_000_000  # characters of a message that is read
ARRAYS = {
    "b": "bool",
    "i": "int64",
    "u": "uint64",
    "f": "float64",
    "c": "complex128",
}  # what stands in an array
LISTS: dict[str, type] = {kind.__name__: kind for kind in CONTAINERS}


def written(value: Any) -> str:
    """`value` as text; of what is neither a number nor a text nor a container of such, only how it looks."""
    data = as_data(value)
    if not safely(True, is_large, data):
        whole = safely("", lambda: json.dumps(_plain(data)))
        if whole:
            return whole
    return json.dumps({"unkept": show(value)})


def read(text: str) -> Any:
    """The value that `written` wrote. Raises ValueError for any other text."""
    if len(text) > LONGEST:
        raise ValueError(f"a value of {len(text):,} characters is too long to be read")
    try:
        return _value(json.loads(text))
    except (RecursionError, TypeError, KeyError, AttributeError) as error:
        raise ValueError(f"this text is no value: {type(error).__name__}") from error


def _plain(value: Any) -> Any:
    if value is None or type(value) in (bool, int, float, str):
        return value
    if value is ...:
        return {"dots": 1}
    if type(value) is complex:
        return {"complex": [value.real, value.imag]}
    if type(value) is np.ndarray:
        kind = value.dtype.kind
        numbers = value.ravel().view(float) if kind == "c" else value.ravel()
        return {
            "array": numbers.tolist(),
            "shape": list(value.shape),
            "kind": ARRAYS[kind],
        }
    if type(value) is dict:
        return {"dict": [[_plain(key), _plain(entry)] for key, entry in value.items()]}
    if type(value) not in CONTAINERS:
        return {"unkept": show(value)}
    entries = [_plain(entry) for entry in value]
    if isinstance(value, set | frozenset):  # its order is another one in each process
        entries.sort(key=json.dumps)
    return {type(value).__name__: entries}


def _value(plain: Any) -> Any:
    if not isinstance(plain, Mapping):
        if isinstance(plain, list):
            raise TypeError("a list stands under its name")
        return plain
    if "array" in plain:
        if (
            plain["kind"] not in ARRAYS.values()
        ):  # a text of any length could be claimed, which would fill the memory
            raise ValueError("an array holds numbers")
        is_complex = plain["kind"] == ARRAYS["c"]
        numbers = np.array(plain["array"], dtype=float if is_complex else plain["kind"])
        if is_complex:
            numbers = numbers.view(complex)
        return numbers.reshape(plain["shape"])
    if "dict" in plain:
        return {_value(key): _value(entry) for key, entry in plain["dict"]}
    if "complex" in plain:
        return complex(*plain["complex"])
    if "dots" in plain:
        return ...
    if "unkept" in plain:
        return Unkept(str(plain["unkept"]))
    ((name, entries),) = plain.items()
    return LISTS[name](_value(entry) for entry in entries)


def state_of(thing: Any) -> Any:
    """What can be changed in an argument: itself, or the attributes of an object; None where nothing can."""
    if isinstance(thing, np.ndarray | list | dict | set | deque):
        return thing
    return safely(None, _attributes, thing)


def _attributes(thing: Any) -> dict[str, Any] | None:
    if type(thing).__module__ in ("builtins", "types"):
        return None
    return dict(vars(thing))


def change(thing: Any, state: Any) -> None:
    """Give an argument the state that its twin in the kernel has, in place."""
    if isinstance(thing, np.ndarray):
        fits = (
            isinstance(state, np.ndarray)
            and state.shape == thing.shape
            and state.dtype.kind in "biuf"
        )
        if fits:
            thing[...] = state
        elif thing.dtype.kind == "f":
            thing[...] = np.nan
        else:
            thing[...] = -1
    elif isinstance(thing, list | deque | set):
        thing.clear()
        add = thing.update if isinstance(thing, set) else thing.extend
        add(state if isinstance(state, list | deque | set) else [state])
    elif isinstance(thing, dict) or (state is not None and hasattr(thing, "__dict__")):
        now = thing if isinstance(thing, dict) else vars(thing)
        now.clear()
        now.update(state if isinstance(state, dict) else {"": state})
