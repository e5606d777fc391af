"""Where compiled kernels are kept: numba's own cache on disk, which a damaged file or a full disk does not stop."""

import functools
import warnings
from contextlib import suppress
from typing import Any

from numba.core.caching import FunctionCache


class KernelCache(FunctionCache):
    """What cannot be read is compiled again, and what cannot be written is compiled anew in the next process.

    The files are as trustworthy as Python's own bytecode beside them: whoever can change the one can change the other.
    """

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The kernel compiled for the types `sig`; None if it is not there, or not whole."""
        try:
            return super().load_overload(sig, target_context)
        except Exception:  # a file that was cut off may raise anything
            with suppress(OSError):
                self.flush()
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a kernel, if there is room."""
        try:
            super().save_overload(sig, data)
        except Exception as error:
            _warn_once(f"{self.cache_path}: compiled kernels cannot be kept ({error})")


@functools.cache
def _warn_once(text: str) -> None:
    warnings.warn(text, stacklevel=3)  # not once for each kernel
