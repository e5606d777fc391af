"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit.
"""

import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar, cast

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
    """The kernel, to be compiled when it is first called; as it is where kernels stay plain, or if that was done.

    Outside an array, and where a divisor is zero, it stops with an error, as Python does. A kernel in the folder of
    built ones is kept on disk.
    """
    if IS_PLAIN or hasattr(kernel, "py_func"):
        return kernel
    dispatcher = numba.njit(
        nogil=True,
        boundscheck=True,
        error_model="python",
        # one function in the end, however many it is written in: that alone halves a step
        forceinline=True,
        no_cfunc_wrapper=True,  # C calls none: compiling takes a quarter less
        cache=FOLDER in Path(kernel.__code__.co_filename).parents,
    )(kernel)
    return cast(Kernel, dispatcher)
