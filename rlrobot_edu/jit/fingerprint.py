"""A short name of what a function is made of: equal names, equal programs."""

import dis
import os
import re
import sys
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from types import CellType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from rlrobot_edu.files import sha256

PACKAGE = __name__.partition(".")[0]
# In the path of what nobody edits
INSTALLED = (os.path.dirname(os.__file__), "site-packages", "dist-packages")
ATOMS = (bool, int, float, complex, str, bytes, type(None), type(...))
_COUNTS = ("argcount", "posonlyargcount", "kwonlyargcount")
OF_CODE = ("code", "names", "varnames", "freevars", *_COUNTS, "flags", "consts")
# In what pickle cannot take apart
WITHIN = ("__module__", "__name__", "__wrapped__", "__func__", "fget", "fset")
READS_GLOBAL = (
    "LOAD_GLOBAL",
    "LOAD_NAME",
    "LOAD_FROM_DICT_OR_GLOBALS",
)  # in Python's words


def code_of(thing: object, toolkit: bool = False, file: str = "") -> str:
    """Short name of a function or a value, the same in every process: its code, and all that this refers to.

    What Python or an installed package brings goes by its name; so does the toolkit, unless `toolkit` is True. The code
    of functions in `file` is left out: who asks knows its text.
    """
    seen: dict[
        int, tuple[int, Any]
    ] = {}  # the things read so far, by their address, each held till the end

    def read(x: Any) -> Any:
        """What `x` is made of, as text in tuples; a thing that was read before goes by its number."""
        x = getattr(x, "py_func", x)  # what numba compiles
        if isinstance(x, bytes):
            return sha256(x)  # a table may be large
        if type(x) in ATOMS or isinstance(x, np.dtype):
            return repr(x)
        if type(x) is tuple:
            return tuple(map(read, x))
        if id(x) in seen:
            return seen[id(x)][0]
        seen[id(x)] = len(seen), x
        return tuple(map(read, _parts(x, toolkit, file)))

    return sha256(repr(read(thing)).encode())[:16]


def _parts(x: Any, toolkit: bool, file: str) -> tuple[Any, ...]:
    """What a thing is made of, see `code_of`: one part after the other, in the same order in every process."""
    if isinstance(x, set | frozenset):
        return "set", *sorted(x, key=lambda y: re.sub(" at 0x[0-9a-f]+", "", repr(y)))
    if isinstance(x, CodeType):
        return tuple(getattr(x, f"co_{part}") for part in OF_CODE)
    if isinstance(x, FunctionType):
        if goes_by_name(x.__globals__.get("__name__"), toolkit):
            return f"{x.__module__}.{x.__qualname__}", *enclosed(x)
        text = (
            x.__code__
            if x.__code__.co_filename != file
            else (x.__qualname__, x.__code__.co_firstlineno)
        )
        return text, x.__defaults__, x.__kwdefaults__, vars(x), *references(x, toolkit)
    if isinstance(x, type):
        if goes_by_name(x.__module__, toolkit):
            return x.__module__, x.__qualname__
        return x.__bases__, *(
            (name, y) for name, y in vars(x).items() if name[:2] != "__" or callable(y)
        )
    try:
        parts = x.__reduce_ex__(4)  # as pickle takes it apart
    except Exception:
        parts = ""
    if isinstance(parts, str):
        return type(x), parts, *(getattr(x, name, None) for name in WITHIN)
    return tuple(tuple(part) if isinstance(part, Iterator) else part for part in parts)


def references(function: Any, toolkit: bool = False) -> Iterator[tuple[str, Any]]:
    """What a function refers to, by its name there: globals, what it takes from modules, and what encloses it."""
    steps = _steps(function.__code__)
    space = function.__globals__
    found = [
        (name, space[name])
        for op, name in steps
        if op in READS_GLOBAL and name in space
    ]
    found += [
        (name, import_module(name))
        for op, name in steps
        if op == "IMPORT_NAME" and find_spec(name)
    ]
    for name, value in found:
        if not isinstance(value, ModuleType):
            yield name, value
        elif goes_by_name(value.__name__, toolkit):
            yield name, value.__name__
        elif name.count(".") < 9:  # modules may contain one another
            found += [
                (f"{name}.{part}", vars(value)[part])
                for _, part in steps
                if part in vars(value)
            ]
    yield from enclosed(function)


def enclosed(function: Any) -> list[tuple[str, Any]]:
    """What a function refers to of those in which it was made, by its name there."""
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=True)
    # an empty cell waits for something that is yet to come
    return [(name, cell.cell_contents) for name, cell in cells if cell != CellType()]


@cache
def _steps(code: CodeType) -> list[tuple[str, str]]:
    """The instructions with a name in `code`, and in the functions inside it."""
    codes = [code]
    for one in codes:
        codes += [inner for inner in one.co_consts if isinstance(inner, CodeType)]
    steps = {
        (step.opname, step.argval)
        for one in codes
        for step in dis.get_instructions(one)
    }
    return sorted(
        (step, name)
        for step, name in steps
        if isinstance(name, str) and name[:2] != "__"
    )


def goes_by_name(module: str | None, toolkit: bool = False) -> bool:
    """Whether a module is Python's, an installed package's or the toolkit's: a version says what is in it."""
    root = str(module).partition(".")[0]  # None: made by hand
    path = getattr(sys.modules.get(root), "__file__", None) or ""
    is_installed = root in sys.builtin_module_names or any(
        place in path for place in INSTALLED
    )
    return not toolkit if root == PACKAGE else is_installed and root != "__main__"
