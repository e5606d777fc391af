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
INSTALLED = (os.path.dirname(os.__file__), "site-packages", "dist-packages")  # in the path of what nobody edits
ATOMS = (bool, int, float, complex, str, bytes, type(None), type(...))
OF_CODE = ("code", "names", "varnames", "freevars", "argcount", "posonlyargcount", "kwonlyargcount", "flags", "consts")
WITHIN = ("__module__", "__name__", "__wrapped__", "__func__", "fget", "fset")  # what pickle cannot take apart
READS_GLOBAL = ("LOAD_GLOBAL", "LOAD_NAME", "LOAD_FROM_DICT_OR_GLOBALS")  # in Python's words


def code_of(thing: object, toolkit: bool = False, file: str = "") -> str:
    """Short name of a function or a value, the same in every process: its code, and all that this refers to.

    What Python or an installed package brings goes by its name; so does the toolkit, unless `toolkit` is True. The code
    of functions in `file` is left out: who asks knows its text.
    """

    def content(x: Any, seen: dict[int, tuple[int, Any]]) -> Any:
        """What `x` is made of, as text in tuples; what was seen before goes by its number, and is held till the end."""
        if getattr(x, "targetoptions", {}).get("fastmath"):
            return "fastmath", content(x.py_func, seen)
        x = getattr(x, "py_func", getattr(x, "_defn", x))  # what numba compiled, or is to generate
        if type(x) in ATOMS or isinstance(x, np.dtype):
            return sha256(x) if isinstance(x, bytes) else repr(x)  # a table may be large
        if isinstance(x, set | frozenset):  # neither its order nor an address is the same in every process
            x = "set", *sorted(x, key=lambda y: re.sub(" at 0x[0-9a-f]+", "", repr(y)))
        if isinstance(x, CodeType):
            x = tuple(getattr(x, f"co_{part}") for part in OF_CODE)
        if type(x) is not tuple:
            if id(x) in seen:
                return seen[id(x)][0]
            seen[id(x)] = len(seen), x
            x = _parts(x, toolkit, file)
        return tuple(content(y, seen) for y in x)

    return sha256(repr(content(thing, {})).encode())[:16]


def _parts(x: Any, toolkit: bool, file: str) -> tuple[Any, ...]:
    """What a function, a class or an object is made of, see `code_of`."""
    if isinstance(x, FunctionType):
        if goes_by_name(x.__globals__.get("__name__"), toolkit):
            return f"{x.__module__}.{x.__qualname__}", *enclosed(x)
        text = x.__code__ if x.__code__.co_filename != file else (x.__qualname__, x.__code__.co_firstlineno)
        return text, x.__defaults__, x.__kwdefaults__, vars(x), *references(x, toolkit)
    if isinstance(x, type):
        if goes_by_name(x.__module__, toolkit):
            return x.__module__, x.__qualname__
        return x.__bases__, *((name, y) for name, y in vars(x).items() if name[:2] != "__" or callable(y))
    try:
        parts = x.__reduce_ex__(4)  # as pickle takes it apart
    except Exception:
        parts = ""
    if isinstance(parts, str):
        return type(x), parts, *(getattr(x, name, None) for name in WITHIN)
    return tuple(tuple(part) if isinstance(part, Iterator) else part for part in parts)


def references(function: Any, toolkit: bool = False) -> Iterator[tuple[str, Any]]:
    """What a function refers to, by its name there: globals, what it takes from modules, and what encloses it."""
    steps, known = _steps(function.__code__), function.__globals__
    found = [(name, known[name]) for step, name in steps if step in READS_GLOBAL and name in known]
    found += [(name, import_module(name)) for step, name in steps if step == "IMPORT_NAME" and find_spec(name)]
    for name, value in found:
        if not isinstance(value, ModuleType):
            yield name, value
        elif goes_by_name(value.__name__, toolkit):
            yield name, value.__name__
        elif name.count(".") < 9:  # modules may contain one another
            found += [(f"{name}.{part}", vars(value)[part]) for _, part in steps if part in vars(value)]
    yield from enclosed(function)


def enclosed(function: Any) -> list[tuple[str, Any]]:
    """What a function refers to of those in which it was made, by its name there."""
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=True)
    return [(name, cell.cell_contents) for name, cell in cells if cell != CellType()]  # unless it is yet to come


@cache
def _steps(code: CodeType) -> list[tuple[str, str]]:
    """The instructions with a name in `code`, and in the functions inside it."""
    codes = [code]
    for one in codes:
        codes += [inner for inner in one.co_consts if isinstance(inner, CodeType)]
    steps = {(step.opname, step.argval) for one in codes for step in dis.get_instructions(one)}
    return sorted((step, name) for step, name in steps if isinstance(name, str) and name[:2] != "__")


def goes_by_name(module: str | None, toolkit: bool = False) -> bool:
    """Whether a module is Python's, an installed package's or the toolkit's: a version says what is in it."""
    root = str(module).partition(".")[0]  # None: made by hand
    path = getattr(sys.modules.get(root), "__file__", None) or ""
    is_installed = root in sys.builtin_module_names or any(place in path for place in INSTALLED)
    return not toolkit if root == PACKAGE else is_installed and root != "__main__"
