"""Records of numbers that kernels read and write by name, as in ``m.now.temperature``, compiled or not."""

from typing import Any

import numpy as np

from rlrobot_edu.learning.jit import IS_PLAIN


class PlainRecord:
    """A record for kernels that run as plain Python.

    numpy's own record searches for a name anew each time, in Python: three quarters of a step of Q-learning.

    array: array () of a structured dtype, which keeps the numbers
    """

    def __init__(self, array: np.ndarray) -> None:
        vars(self).update(_array=array, _fields={name: array[name] for name in array.dtype.names or ()})

    def __getitem__(self, name: str) -> Any:
        return self._fields[name][()]

    def __setitem__(self, name: str, number: Any) -> None:
        self._fields[name][()] = number

    def __getattr__(self, name: str) -> Any:
        try:
            return vars(self)["_fields"][name][()]
        except KeyError:
            raise AttributeError(f"a record of {', '.join(vars(self).get('_fields', ()))} has no {name}") from None

    __setattr__ = __setitem__

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self._array, dtype, copy=copy)

    def __reduce__(self) -> tuple[Any, ...]:  # a copy's fields must be parts of the copy's array
        return PlainRecord, (self._array.copy(),)


def new_record(dtype: np.dtype) -> Any:
    """A record of these fields, all zero."""
    return PlainRecord(np.zeros((), dtype)) if IS_PLAIN else np.zeros(1, dtype).view(np.recarray)[0]
