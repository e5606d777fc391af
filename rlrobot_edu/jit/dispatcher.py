"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit.
"""

import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

numba: Any
try:
    import numba
except ImportError:
    numba = None

IS_PLAIN = numba is None or bool(numba.config.DISABLE_JIT)
OURS = ("rlrobot_edu", "rlrobot_course")  # packages whose kernels are tested
Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def cache_folder() -> Path | None:
    """Folder of this user's compiled kernels; None if it cannot be written."""
    with suppress(OSError, RuntimeError):  # RuntimeError: this user has no home
        folder = Path("~/.cache/rlrobot_edu/kernels").expanduser()
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

    The toolkit's own kernels are tested to stay within their arrays and to divide by no zero. Others are compiled so
    that they stop with an error there, as Python does. A kernel in the folder of built ones is kept on disk.
    """
    if IS_PLAIN:
        return kernel
    function = getattr(kernel, "py_func", kernel)
    if not is_ours(function):
        return numba.njit(nogil=True, error_model="python", boundscheck=True)(function)
    if function is not kernel:
        return kernel
    file = Path(function.__code__.co_filename)
    return numba.njit(
        nogil=True,
        error_model="numpy",
        # one function in the end, however many it is written in: that alone more than halves a step
        forceinline=True,
        cache=FOLDER is not None and FOLDER in file.parents,
    )(function)
