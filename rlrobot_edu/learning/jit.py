"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit.
"""

from __future__ import annotations

import hashlib
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

try:
    import numba
except ImportError:
    numba = None

PACKAGE = Path(__file__).parents[1]


def cache_folder() -> Path:
    """Folder of the compiled kernels, named after the source they were compiled from.

    numba looks for a change only in the file of the function it compiles, not in what this function calls. A learner
    who edits an algorithm must see the edit run, so any change in a kernel's folder leads to a fresh cache.
    """
    digest = hashlib.sha256()
    for source in sorted([*PACKAGE.glob("learning/*.py"), *PACKAGE.glob("models/*.py")]):
        digest.update(source.read_bytes())
    name = f"kernels-{digest.hexdigest()[:16]}"
    try:
        folder = PACKAGE / "__pycache__" / name
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return folder
    except OSError:  # installed where this user cannot write
        return Path.home() / ".cache" / "rlrobot_edu" / name


def _decorator() -> Callable:
    if numba is None or numba.config.DISABLE_JIT:
        return lambda kernel: kernel
    folder = str(cache_folder())

    def compile_kernel(kernel: Callable) -> Callable:
        before, numba.config.CACHE_DIR = numba.config.CACHE_DIR, folder  # read by numba while it decorates
        try:
            return numba.njit(cache=True, nogil=True, error_model="numpy")(kernel)
        finally:
            numba.config.CACHE_DIR = before

    return compile_kernel


compiled = _decorator()


def announce_compilation(kernel: Callable) -> None:
    """Say on stderr that the next call of `kernel` will take a while, if it was never compiled on this machine."""
    if not hasattr(kernel, "signatures") or kernel.signatures:
        return
    name = f"{kernel.py_func.__module__.rpartition('.')[2]}.{kernel.py_func.__name__}-*.nbi"
    if not any(Path(kernel.stats.cache_path).glob(name)):
        print("Compiling the learning kernels: this happens once and takes about 15 seconds …", file=sys.stderr)
