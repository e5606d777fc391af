"""Somebody's own kernels, with the functions of theirs that they call."""

import math
from collections.abc import Callable
from types import CellType, FunctionType
from typing import Any, cast

from rlrobot_edu.jit import python_math
from rlrobot_edu.jit.dispatcher import IS_PLAIN, Kernel, compiled, is_ours
from rlrobot_edu.jit.fingerprint import goes_by_name


def in_numba(kernel: Kernel) -> Kernel:
    """The kernel, compiled; somebody's own in our way, and not as they may have compiled it. Its `math` is Python's."""
    function = function_of(kernel)
    if IS_PLAIN or is_ours(function):
        return compiled(kernel)

    def made(thing: Any) -> Any:
        if thing is math:
            return python_math
        if is_theirs(thing) and function_of(thing) is not function:
            return in_numba(thing)
        return python_math.INSTEAD.get(thing, thing) if callable(thing) else thing

    return cast(Kernel, compiled(_with(function, made)))


def in_python(kernel: Any) -> Any:
    """The kernel as plain Python, and so what it calls of theirs."""
    function = function_of(kernel)
    if is_ours(function):
        return function

    def made(thing: Any) -> Any:
        if is_theirs(thing) and function_of(thing) is not function:
            return in_python(thing)
        return thing

    return _with(function, made)


def function_of(kernel: Any) -> Any:
    """The function of Python that numba has compiled; anything else as it is."""
    return getattr(kernel, "py_func", kernel)


def is_theirs(thing: Any) -> bool:
    """Whether this is a function, compiled or not, that belongs to no installed package."""
    function = function_of(thing)
    return isinstance(function, FunctionType) and not goes_by_name(function.__module__)


def _with(function: Any, made: Callable[[Any], Any]) -> Any:
    """A copy of a function, to which its names mean what `made` makes of them."""
    code = function.__code__
    around = dict(function.__globals__)
    for name in set(code.co_names).intersection(around):
        around[name] = made(around[name])
    cells = [CellType(made(cell.cell_contents)) for cell in function.__closure__ or ()]
    defaults = function.__defaults__
    copy = FunctionType(code, around, function.__name__, defaults, tuple(cells))
    copy.__kwdefaults__ = function.__kwdefaults__
    return copy
