"""Compile the kernels with numba where it is installed; otherwise the same source runs as plain Python.

Set ``NUMBA_DISABLE_JIT=1`` to run every kernel as plain Python: slower, the same numbers to the last bit as long as a
kernel stays within its arrays. Compiled kernels do not check that: outside, plain Python raises an IndexError.
"""

import tempfile
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any, TypeVar, cast

numba: Any
try:
    import numba
except ImportError:
    numba = None
else:
    from rlrobot_edu.jit.caching import KernelCache


PACKAGE = Path(__file__).parents[1]
IS_PLAIN = numba is None or bool(numba.config.DISABLE_JIT)
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


def compiled(kernel: Kernel) -> Kernel:
    """The kernel, to be compiled when it is first called; as it is where kernels stay plain, or if that was done."""
    if IS_PLAIN or hasattr(kernel, "py_func"):
        return kernel
    # forceinline: one function in the end, however many it is written in; that alone more than halves a step
    njit = partial(numba.njit, nogil=True, error_model="numpy", forceinline=True)
    dispatcher, inner = (
        njit()(kernel),
        njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)(kernel),
    )
    dispatcher._cache, inner._cache = (
        KernelCache(dispatcher, FOLDER),
        KernelCache(inner, FOLDER),
    )
    # for other kernels: without the way in from Python, which takes a third of the time of compiling
    dispatcher.get_call_template, dispatcher.get_overload = (
        inner.get_call_template,
        inner.get_overload,
    )
    dispatcher.inner = inner
    return cast(Kernel, dispatcher)


def _lend(context: Any, arrays: Any) -> Any:
    """The named tuple `arrays`, its arrays without their counters, as an intrinsic function of numba."""

    def uncounted(context: Any, builder: Any, kind: Any, value: Any) -> Any:
        if isinstance(kind, numba.types.Array):
            array = context.make_array(kind)(context, builder, value)
            array.meminfo = array.meminfo.type(None)  # null: not counted
            array.parent = array.parent.type(None)
            return array._getvalue()
        for i, inner in enumerate(
            kind.types if isinstance(kind, numba.types.BaseTuple) else ()
        ):
            part = uncounted(context, builder, inner, builder.extract_value(value, i))
            value = builder.insert_value(value, part, i)
        return value

    def generate(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        return uncounted(context, builder, arrays, values[0])

    return arrays(arrays), generate


# A named tuple of arrays, for the kernels that a kernel calls. numba counts references whenever a function takes an
# array out of a tuple, which is most of the time of a step. The caller of a kernel holds the arrays until the kernel
# returns, so inside it nobody has to count; what is borrowed must not be returned.
borrowed = (lambda arrays: arrays) if IS_PLAIN else numba.extending.intrinsic(_lend)
