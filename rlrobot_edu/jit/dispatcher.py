"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit.
"""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

numba: Any
try:
    import numba
except ModuleNotFoundError as missing:
    if missing.name != "numba":
        raise
    numba = None

PACKAGE = Path(__file__).parents[1]
IS_PLAIN = numba is None or bool(numba.config.DISABLE_JIT)
# Kernels of these packages are compiled as they are. Those of others are first made to behave as in Python, see own.py.
OURS = ("rlrobot_edu", "rlrobot_course")
Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def cache_folder() -> Path | None:
    """Folder of the compiled kernels, which is made; None if no place is writable."""
    # the second place is for a package that was installed where this user cannot write
    for parent in (PACKAGE / "__pycache__", Path("~/.cache/rlrobot_edu")):
        try:
            folder = parent.expanduser() / "kernels"
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):  # proves that it is writable
                pass
        except (OSError, RuntimeError):  # RuntimeError: this user has no home
            continue
        return folder
    return None


FOLDER = None if IS_PLAIN else cache_folder()


def is_ours(kernel: Callable[..., Any]) -> bool:
    """Whether the toolkit brings this kernel, or has put it together."""
    return str(kernel.__module__).partition(".")[0] in OURS


def compiled(kernel: Kernel) -> Kernel:
    """Wrap a kernel, so that numba compiles it when it is first called.

    The kernel is returned unchanged if there is no numba, if numba is switched off, or if it is wrapped already.
    As in Python, an index outside an array and a division by zero are errors. numba keeps what it compiles on disk if
    the kernel's file is in `FOLDER`, where building.py alone writes modules.
    """
    if IS_PLAIN or hasattr(kernel, "py_func"):
        return kernel
    is_built = FOLDER in Path(kernel.__code__.co_filename).parents
    dispatcher = numba.njit(
        nogil=True,
        boundscheck=True,
        error_model="python",
        # All calls are inlined, so that a step is one machine function: it takes half the time.
        forceinline=True,
        # No kernel is called from C; without the wrapper for it, compiling takes a quarter less.
        no_cfunc_wrapper=True,
        cache=is_built,
    )(kernel)
    return cast(Kernel, dispatcher)
