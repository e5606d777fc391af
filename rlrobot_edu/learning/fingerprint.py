"""A short name of what a function does: equal names, equal code."""

import re
from types import CodeType, FunctionType, ModuleType

from rlrobot_edu.files import sha256


def code_of(function: object) -> str:
    """Short name of what a function does, the same in every process: its code, and all that this reaches by name."""
    return sha256(repr(_code(function, set())).encode())[:16]


def _code(x: object, seen: set[object]) -> object:
    x = getattr(x, "py_func", getattr(x, "_defn", x))  # what numba compiled, or is to generate
    if isinstance(x, CodeType):
        return [x.co_code, x.co_names, [_code(constant, seen) for constant in x.co_consts]]
    if isinstance(x, FunctionType) and x not in seen:
        seen.add(x)
        reached = [(name, x.__globals__[name]) for name in x.__code__.co_names if name in x.__globals__]
        enclosed = [("", cell.cell_contents) for cell in x.__closure__ or ()]
        return [_code(x.__code__, seen), x.__defaults__, [(name, _code(y, seen)) for name, y in reached + enclosed]]
    if isinstance(x, tuple | list):
        return [_code(part, seen) for part in x]
    if isinstance(x, ModuleType):
        return x.__name__  # and not where it is installed
    return re.sub(" at 0x[0-9a-f]+", "", repr(x))  # without addresses, which are never the same
