"""A learner's function that runs in the kernel: a check takes it like any other."""

from __future__ import annotations

import base64
import importlib
import json
import sys
from collections.abc import Callable, Mapping
from typing import Any

import cloudpickle

from rlrobot_grading.answers.limits import Elsewhere, Failure, TooLong
from rlrobot_grading.answers.values import Function, one_line
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.kernel import Kernel
from rlrobot_grading.marking.serialization import change, read

UNREADABLE = Failure("error", "something that cannot be read", inside=True)


def remote_function(
    course: Course,
    kernel: Kernel,
    lesson: str,
    name: str,
    seconds: Callable[[], float],
    is_unfinished: bool = False,
    substitutes: Mapping[str, Function] | None = None,
) -> Elsewhere:
    """Return the answer `name` of a lesson, in `kernel`; `is_unfinished`: whether there are still dots in it.

    seconds: that a call may take
    substitutes: functions that it finds in the notebook instead of those of the same names
    """
    _pickle_by_value(course.module_of(lesson))
    packed_substitutes = _packed(dict(substitutes or {}))

    def ask(*arguments: Any) -> tuple[Any, Failure | None, str]:
        call = f"call({name!r}, {_packed(arguments)!r}, {packed_substitutes!r})"
        try:
            result = json.loads(kernel.ask(call, seconds()))
            failure = _failure(result["failure"]) if result["failure"] else None
            for thing, state in zip(arguments, result["states"], strict=True):
                change(thing, read(state))
            return read(result["value"]), failure, str(result["printed"])
        except TimeoutError as error:
            return None, Failure(TooLong.__name__, str(error)), ""
        except (ValueError, TypeError, KeyError, AttributeError):
            return None, UNREADABLE, ""

    return Elsewhere(ask, is_unfinished)


def _packed(things: Any) -> str:
    return base64.b64encode(cloudpickle.dumps(things)).decode()


def _failure(fields: dict[str, Any]) -> Failure:
    kind, text, line = (
        one_line(str(fields[name])) for name in ("kind", "text", "line")
    )
    told = one_line(str(fields["told"]), 400)
    return Failure(kind, text, line, bool(fields["inside"]), told)


def _pickle_by_value(module: str) -> None:
    """Have what stands in a lesson's modules travel with its code: in the kernel, these modules are not there."""
    importlib.import_module(f"{module}.exercises")
    for name in list(sys.modules):
        if name.startswith(f"{module}."):
            cloudpickle.register_pickle_by_value(sys.modules[name])
