"""A short name of what a function is made of: equal names, equal programs.

The text of a function would not do. It may have none, and what it calls and the numbers that it uses stand elsewhere.
"""

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
OF_CODE = (
    "co_code",
    "co_names",
    "co_varnames",
    "co_freevars",
    "co_argcount",
    "co_posonlyargcount",
    "co_kwonlyargcount",
    "co_flags",
    "co_consts",
)
# In what pickle cannot take apart
WITHIN = ("__module__", "__name__", "__wrapped__", "__func__", "fget", "fset")
# In Python's words
READS_GLOBAL = ("LOAD_GLOBAL", "LOAD_NAME", "LOAD_FROM_DICT_OR_GLOBALS")
DEEPEST = (
    9  # dots in the name of what a module contains: modules may contain one another
)


def code_of(thing: object, file: str = "") -> str:
    """Short name of a function or a value, the same in every process: its code, and all that this refers to.

    What Python, an installed package or the toolkit brings goes by its name. The code of functions in `file` is left
    out: who asks knows its text.
    """
    # the things read so far: by their address, the number of each, and itself, so that the address stays its own
    seen: dict[int, tuple[int, Any]] = {}

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
        return tuple(map(read, _parts(x, file)))

    return sha256(repr(read(thing)).encode())[:16]


def _parts(x: Any, file: str) -> tuple[Any, ...]:
    """What a thing is made of, see `code_of`: one part after the other, in the same order in every process."""
    if isinstance(x, set | frozenset):
        return ("set", *sorted(x, key=_without_address))
    if isinstance(x, CodeType):
        return tuple(getattr(x, name) for name in OF_CODE)
    if isinstance(x, FunctionType):
        return _parts_of_function(x, file)
    if isinstance(x, type):
        return _parts_of_class(x)
    try:
        parts = x.__reduce_ex__(4)  # as pickle takes it apart
    except Exception:
        parts = ""
    if isinstance(parts, str):
        within = [getattr(x, name, None) for name in WITHIN]
        return (type(x), parts, *within)
    return tuple(tuple(part) if isinstance(part, Iterator) else part for part in parts)


def _without_address(x: object) -> str:
    return re.sub(" at 0x[0-9a-f]+", "", repr(x))


def _parts_of_function(x: FunctionType, file: str) -> tuple[Any, ...]:
    if goes_by_name(x.__globals__.get("__name__")):
        return (f"{x.__module__}.{x.__qualname__}", *enclosed(x))
    text: Any = x.__code__
    if x.__code__.co_filename == file:
        text = (x.__qualname__, x.__code__.co_firstlineno)
    return (text, x.__defaults__, x.__kwdefaults__, vars(x), *references(x))


def _parts_of_class(x: type) -> tuple[Any, ...]:
    if goes_by_name(x.__module__):
        return (x.__module__, x.__qualname__)
    members = [
        (name, member)
        for name, member in vars(x).items()
        if not name.startswith("__") or callable(member)
    ]
    return (x.__bases__, *members)


def references(function: Any) -> Iterator[tuple[str, Any]]:
    """What a function refers to, by its name there: globals, what it takes from modules, and what encloses it."""
    names = _names_in(function.__code__)
    space = function.__globals__
    found: list[tuple[str, Any]] = []
    for operation, name in names:
        if operation in READS_GLOBAL and name in space:
            found.append((name, space[name]))
    for operation, name in names:
        if operation == "IMPORT_NAME" and find_spec(name):
            found.append((name, import_module(name)))
    for name, value in found:
        if not isinstance(value, ModuleType):
            yield name, value
        elif goes_by_name(value.__name__):
            yield name, value.__name__
        elif name.count(".") < DEEPEST:
            contents = vars(value)
            taken = [part for _, part in names if part in contents]
            found += [(f"{name}.{part}", contents[part]) for part in taken]
    yield from enclosed(function)


def enclosed(function: Any) -> list[tuple[str, Any]]:
    """What a function refers to of those in which it was made, by its name there."""
    cells = zip(function.__code__.co_freevars, function.__closure__ or (), strict=True)
    # an empty cell waits for something that is yet to come
    return [(name, cell.cell_contents) for name, cell in cells if cell != CellType()]


@cache
def _names_in(code: CodeType) -> list[tuple[str, str]]:
    """The names in `code`, and in the functions inside it, each with the operation that uses it."""
    codes = [code]
    for one in codes:
        codes += [inner for inner in one.co_consts if isinstance(inner, CodeType)]
    used = set()
    for one in codes:
        for step in dis.get_instructions(one):
            name = step.argval
            if isinstance(name, str) and not name.startswith("__"):
                used.add((step.opname, name))
    return sorted(used)


def goes_by_name(module: str | None) -> bool:
    """Whether a module is Python's, an installed package's or the toolkit's: a version says what is in it."""
    root = str(module).partition(".")[0]  # None: made by hand
    if root == PACKAGE:
        return True
    if root == "__main__":
        return False
    path = getattr(sys.modules.get(root), "__file__", None) or ""
    is_installed = any(place in path for place in INSTALLED)
    return root in sys.builtin_module_names or is_installed
