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
from rlrobot_grading.answers.values import one_line
from rlrobot_grading.marking.kernel import Kernel
from rlrobot_grading.marking.rooms import room_of
from rlrobot_grading.marking.serialization import change, read

UNREADABLE = Failure("error", "something that cannot be read", inside=True)


def away(
    kernel: Kernel,
    name: str,
    lesson: str,
    seconds: Callable[[], float],
    is_unfinished: bool = False,
    lent: Mapping[str, Callable[..., Any]] | None = None,
) -> Elsewhere:
    """The answer `name` of a lesson, in `kernel`; `is_unfinished`: whether there are still dots in it.

    seconds: that a call may take; lent: functions that it finds in the notebook instead of those of the same names
    """
    _travel_whole(lesson)
    more = f", {_packed(dict(lent))!r}" if lent else ""

    def ask(*arguments: Any) -> tuple[Any, Failure | None, str]:
        try:
            told = json.loads(
                kernel.ask(f"called({name!r}, {_packed(arguments)!r}{more})", seconds())
            )
            failure = _failure(told["failure"]) if told["failure"] else None
            for thing, state in zip(arguments, told["states"], strict=True):
                change(thing, read(state))
            return read(told["value"]), failure, str(told["printed"])
        except TimeoutError as error:
            return None, Failure(TooLong.__name__, str(error)), ""
        except (ValueError, TypeError, KeyError, AttributeError):
            return None, UNREADABLE, ""

    return Elsewhere(ask, is_unfinished)


def _packed(things: Any) -> str:
    return base64.b64encode(cloudpickle.dumps(things)).decode()


def _failure(told: dict[str, Any]) -> Failure:
    kind, text, line = (one_line(str(told[name])) for name in ("kind", "text", "line"))
    return Failure(
        kind, text, line, bool(told["inside"]), one_line(str(told["told"]), 400)
    )


def _travel_whole(lesson: str) -> None:
    """Have what stands in the lesson's modules travel with its code: in the kernel, these modules are not there."""
    room = f"rlrobot_course.{room_of(lesson)}."
    importlib.import_module(f"{room}exercises")
    for name in [name for name in sys.modules if name.startswith(room)]:
        cloudpickle.register_pickle_by_value(sys.modules[name])
