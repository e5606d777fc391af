"""Where compiled kernels are kept, so that a machine compiles each of them once."""

import functools
import pickle
import sys
import warnings
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numba
from numba.core.caching import CompileResultCacheImpl
from numba.core.serialize import dumps

from rlrobot_edu.files import remove_old, sha256, write_whole
from rlrobot_edu.learning.fingerprint import code_of

UNUSED = 30 * 24 * 3600  # age at which a kernel that no process has asked for goes [s]


class KernelCache:
    """The compiled forms of one kernel in a folder: a file for each kind of arguments.

    numba's own cache looks for a change only in the file of the function it compiles. Here a file is named after all
    that the kernel is made of, what it calls included: a learner who edits an algorithm sees the edit run, an edit
    anywhere else costs nothing, and versions side by side keep their own.

    A file that cannot be read is made anew, and what cannot be written is compiled again by the next process. The files
    are as trustworthy as Python's own bytecode beside them: a user who can change the one can change the other.
    """

    def __init__(self, kernel: Callable[..., Any], folder: Path) -> None:
        self._kernel, self._folder = kernel, folder
        self.cache_path = str(folder)  # in numba's words
        self._form = CompileResultCacheImpl.__new__(CompileResultCacheImpl)  # only what it does to a result is wanted

    @functools.cached_property
    def _name(self) -> str:
        """Of the kernel; asked for when it is first called, since what it calls may stand below it."""
        module, made_of = self._kernel.__module__.rpartition(".")[2], code_of(self._kernel)
        return f"{module}.{self._kernel.__name__}-{made_of}"

    def _path(self, signature: Any, codegen: Any) -> Path:
        kind = (str(signature), codegen.magic_tuple(), numba.__version__, sys.implementation.cache_tag)
        return self._folder / f"{self._name}-{sha256(repr(kind).encode())[:16]}.nbc"

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The kernel compiled for the types `sig`; None if it is not there, or not whole."""
        target_context.refresh()
        try:
            path = self._path(sig, target_context.codegen())
            result = self._form.rebuild(target_context, pickle.loads(path.read_bytes()))
        except Exception:  # a file that was cut off may raise anything
            return None
        with suppress(OSError):
            path.touch()
        return result

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a kernel, if there is room."""
        if data.lifted or data.library.has_dynamic_globals:  # what numba cannot keep
            return
        try:
            _remove_unused(self._folder)
            write_whole(self._path(sig, data.codegen), dumps(self._form.reduce(data)))
        except Exception as error:
            _warn_once(f"{self.cache_path}: compiled kernels cannot be kept ({getattr(error, 'strerror', error)})")


@functools.cache
def _remove_unused(folder: Path) -> None:
    """Once a process, remove the kernels of former versions and edits."""
    remove_old(folder.glob("*.nbc"), UNUSED)


@functools.cache
def _warn_once(text: str) -> None:
    warnings.warn(text, stacklevel=3)  # not once for each kernel
