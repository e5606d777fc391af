"""Where compiled kernels are kept, so that a machine compiles each of them once."""

import functools
import pickle
import sys
import warnings
from contextlib import suppress
from typing import Any

import numba
from numba.core.caching import NullCache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from rlrobot_edu.files import remove_old, sha256, write_whole
from rlrobot_edu.jit.fingerprint import code_of, goes_by_name, references

_warn_once = functools.cache(warnings.warn)  # not once for each kernel
UNUSED = 30 * 24 * 3600  # age at which a kernel that no process has asked for goes [s]


class KernelCache(NullCache):
    """The compiled forms of one kernel in a folder: a file for each kind of arguments.

    numba's own cache looks for a change only in the file of the function it compiles. Here a file is named after all
    that the kernel is made of, what it calls and refers to included: a learner who edits an algorithm sees the edit
    run, an edit anywhere else costs nothing, and versions side by side keep their own.

    A file that cannot be read is made anew, and what cannot be written is compiled again by the next process. The files
    are as trustworthy as Python's own bytecode next to them: a user who can change one can change the other.
    """

    def __init__(self, dispatcher: Any, folder: Any) -> None:
        self._kernel, self._options = dispatcher.py_func, dispatcher.targetoptions
        self._folder = folder  # without one nothing is kept

    def _path(self, signature: Any, codegen: Any) -> Any:
        how = self._options, numba.__version__, sys.implementation.cache_tag
        kind = (
            code_of(self._kernel, toolkit=True),
            str(signature),
            codegen.magic_tuple(),
            *how,
        )
        name = f"{self._kernel.__module__.rpartition('.')[2]}.{self._kernel.__name__}"
        return self._folder / f"{name}-{sha256(repr(kind).encode())[:16]}.nbc"

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The kernel compiled for the types `sig`; None if it is not there, or not whole: then it is compiled."""
        target_context.refresh()
        with suppress(Exception):  # a file that was cut off may raise anything
            path = self._path(sig, target_context.codegen())
            result = CompileResult._rebuild(
                target_context, *pickle.loads(path.read_bytes())
            )
            with suppress(OSError):
                path.touch()
            return result
        for _, part in references(self._kernel):
            # one of the learner's, compiled before with globals as they were then
            if hasattr(part, "recompile") and not goes_by_name(part.__module__):
                getattr(part, "inner", part).recompile()
        return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a kernel, if there is room."""
        if (
            self._folder is None or data.lifted or data.library.has_dynamic_globals
        ):  # what numba cannot keep
            return
        try:
            remove_old(
                self._folder.glob("*.nbc"), UNUSED
            )  # of former versions and edits
            write_whole(self._path(sig, data.codegen), dumps(data._reduce()))
        except Exception as error:
            why = getattr(error, "strerror", error)
            _warn_once(f"{self._folder}: compiled kernels cannot be kept ({why})")
