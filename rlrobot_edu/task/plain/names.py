"""What the names in a function stand for, outside of it."""

import ast
import builtins
import math
from types import CodeType, FunctionType, ModuleType
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.task.plain.arithmetic import LARGEST


class Kind(NamedTuple):
    """What an argument of a plain function is: readings, a number, or a text, which is known before it runs."""

    what: str
    text: str = ""


READINGS, NUMBER = Kind("readings"), Kind("number")
UNKNOWN = object()
# Python's functions that have a plain one in their place, by what they are and not by what somebody calls them
FUNCTIONS = (
    (builtins.abs, "abs"),
    (builtins.min, "smaller"),
    (builtins.max, "larger"),
    (builtins.round, "rounded"),
    (math.sqrt, "root"),
)
_SEVERAL_ARGUMENTS = 0x04 | 0x08  # *args, **kwargs
_NO_PLAIN_CALL = 0x20 | 0x80 | 0x100 | 0x200  # generators, coroutines


def is_local(code: CodeType, name: str) -> bool:
    """Whether a name is an argument or a variable of the function with this code."""
    return name in code.co_varnames or name in code.co_cellvars


def meaning(function: FunctionType, node: ast.expr) -> Any:
    """What a name, or a name in a module, stands for now; UNKNOWN where it stands for nothing or for a variable."""
    if isinstance(node, ast.Attribute):
        module = meaning(function, node.value)
        if isinstance(module, ModuleType):
            return vars(module).get(node.attr, UNKNOWN)
        return UNKNOWN
    if not isinstance(node, ast.Name) or is_local(function.__code__, node.id):
        return UNKNOWN
    if node.id in function.__code__.co_freevars:
        return _enclosed(function, node.id)
    if node.id in function.__globals__:
        return function.__globals__[node.id]
    surroundings: Any = function  # for mypy, it has no such attribute
    return surroundings.__builtins__.get(node.id, UNKNOWN)


def _enclosed(function: FunctionType, name: str) -> Any:
    """What a name of the surrounding function stands for."""
    cell = (function.__closure__ or ())[function.__code__.co_freevars.index(name)]
    try:
        return cell.cell_contents
    except ValueError:  # it has no value yet
        return UNKNOWN


def word_of(value: Any) -> str | None:
    """The name of the plain function in place of one of Python's; None for anything else."""
    for function, word in FUNCTIONS:
        if value is function:
            return word
    return None


def plain_number(value: Any) -> float | None:
    """A value as a plain function's number; None if it is none, see `why_no_number`."""
    return None if why_no_number(value) else float(value)


def why_no_number(value: Any) -> str:
    """Why a value is no number of a plain function; an empty text if it is one."""
    if value is UNKNOWN:
        return "it has no value here"
    if isinstance(value, np.number):
        return "it is a number of NumPy, which divides by 0 without an error; write float(...) where it is made"
    if type(value) not in (float, int, bool):
        return f"it is no number, but of type {type(value).__name__}"
    if isinstance(value, int) and abs(value) >= LARGEST:
        return "it is too large"
    if value != value:
        return "it is NaN"
    return ""


def unusual(function: FunctionType) -> str:
    """Why a function cannot be plain, whatever it says; an empty text if nothing is in the way."""
    flags = function.__code__.co_flags
    if flags & _SEVERAL_ARGUMENTS:
        return "*args or **kwargs"
    if flags & _NO_PLAIN_CALL:
        return "a generator or an async function"
    if vars(function):
        return "a function with a decorator or with attributes"
    return ""
