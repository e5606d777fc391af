"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit.
"""

import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import CellType, FunctionType
from typing import Any, TypeVar, cast

from rlrobot_edu.jit.fingerprint import goes_by_name

numba: Any
try:
    import numba
except ImportError:
    numba = None

PACKAGE = Path(__file__).parents[1]
IS_PLAIN = numba is None or bool(numba.config.DISABLE_JIT)
OURS = ("rlrobot_edu", "rlrobot_course")  # packages whose kernels are tested
Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def cache_folder() -> Path | None:
    """Folder of the compiled kernels; None if no place is writable."""
    # the second is for a package that was installed where this user cannot write
    for parent in (PACKAGE / "__pycache__", Path("~/.cache/rlrobot_edu")):
        with suppress(OSError, RuntimeError):  # RuntimeError: this user has no home
            folder = parent.expanduser() / "kernels"
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                return folder
    return None


FOLDER = None if IS_PLAIN else cache_folder()


def is_ours(kernel: Callable[..., Any]) -> bool:
    """Whether the toolkit brings this kernel, or has put it together."""
    return str(kernel.__module__).partition(".")[0] in OURS


def compiled(kernel: Kernel) -> Kernel:
    """The kernel, to be compiled when it is first called; as it is where kernels stay plain.

    Outside an array, and where a divisor is zero, it stops with an error, as Python does. What somebody has compiled
    in another way is compiled anew. A kernel in the folder of built ones is kept on disk.
    """
    if IS_PLAIN:
        return kernel
    function = getattr(kernel, "py_func", kernel)
    if not is_ours(function):
        function = _with_helpers(function, compiled)
    elif function is not kernel:
        return kernel
    dispatcher = numba.njit(
        nogil=True,
        boundscheck=True,
        error_model="python",
        # one function in the end, however many it is written in: that alone halves a step
        forceinline=True,
        no_cfunc_wrapper=True,  # C calls none: compiling takes a quarter less
        cache=FOLDER in Path(function.__code__.co_filename).parents,
    )(function)
    return cast(Kernel, dispatcher)


def uncompiled(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The kernel as plain Python; of somebody's own also the functions of theirs that it calls."""
    function = getattr(kernel, "py_func", kernel)
    return function if is_ours(function) else _with_helpers(function, uncompiled)


def _with_helpers(function: Any, make: Callable[..., Any]) -> Any:
    """A copy of somebody's function, in which `make` has made those of theirs that it calls by name."""

    def made(thing: Any) -> Any:
        called = getattr(thing, "py_func", thing)
        is_theirs = isinstance(called, FunctionType) and called is not function
        if not is_theirs or goes_by_name(called.__module__):
            return thing
        return make(called)

    code = function.__code__
    around = dict(function.__globals__)
    for name in set(code.co_names).intersection(around):
        around[name] = made(around[name])
    cells = [CellType(made(cell.cell_contents)) for cell in function.__closure__ or ()]
    defaults = function.__defaults__
    copy = FunctionType(code, around, function.__name__, defaults, tuple(cells))
    copy.__kwdefaults__ = function.__kwdefaults__
    return copy
