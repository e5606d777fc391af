"""The kernel's side of grading: a limit of memory, answers taken in and called.

All that this module sends to the grader is data that the grader's own checks judge. So whoever changes it here, from a
notebook, gains nothing: to be right, the right values must come out, and for arguments that nobody knows beforehand.
"""

from __future__ import annotations

import base64
import importlib
import json
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import cloudpickle

from rlrobot_grading.answers.limits import attempt
from rlrobot_grading.answers.source import COURSES_OWN, is_courses_own, is_unfinished
from rlrobot_grading.answers.values import safely
from rlrobot_grading.marking.course import Course
from rlrobot_grading.marking.serialization import state_of, written

answers: dict[
    str, Any
] = {}  # what has been handed in, by exercise; where nothing has, what defines it
handed_in: list[str] = []  # since the grader asked last
stand_ins: dict[str, StandIn] = {}  # for the solutions
taken: list[Any] = []  # what the course has given to the notebook: no answers
judged: list[str] = []  # exercises whose answers the grader is calling
NEEDED = 16 * 2**20  # memory that a kernel must have left [bytes]


class NotGivenError(LookupError, AttributeError):
    """Something of a lesson that there is at home, and not while a notebook is graded: not the learner's fault."""


class Intake:
    """It stands where an exercise stood: what it is called with is an answer that is handed in."""

    hints: tuple[str, ...] = ()

    def __init__(self, name: str) -> None:
        self._name = name
        self.right = stand_ins.get(name)

    def __getattr__(self, name: str) -> Any:
        raise NotGivenError(f"while a notebook is graded, its checks have no {name!r}")

    def __call__(self, answer: Any = None) -> bool:
        """Take an answer in; true, as a verdict is that calls it right."""
        answers[self._name] = answer
        handed_in.append(self._name)
        return True

    judge = __call__

    def hint(self, number: int = 1) -> None:
        """Say nothing: hints are for learning."""


class StandIn:
    """It stands where a solution stood: the lesson's pictures call it, and get what the learner has written."""

    def __init__(self, module: str, name: str) -> None:
        self.__name__ = name
        self.__module__ = module

    def __call__(self, *arguments: Any, **more: Any) -> Any:
        """What the learner's function returns. Raises NotGivenError if there is none, or if it calls the solution."""
        if self.__name__ in judged:
            raise NotGivenError(COURSES_OWN)
        answer = answers.get(self.__name__)
        if not callable(answer) or isinstance(answer, StandIn):
            raise NotGivenError(
                f"{self.__name__} is an exercise of this notebook; while it is graded none is given"
            )
        return answer(*arguments, **more)


def start() -> None:
    """Run a kernel for one submission; arguments: course, lesson, its exercises, MiB of memory, connection file."""
    course, lesson, exercises, memory, connection_file = sys.argv[1:6]
    from ipykernel.kernelapp import IPKernelApp

    app = IPKernelApp.instance()
    app.initialize(["-f", connection_file])
    # exit() would end the kernel; so it ends a cell
    type(app.shell).ask_exit = staticmethod(sys.exit)
    _replace_solutions(Course.from_json(course), lesson, exercises.split(","))
    _limit_memory(int(memory))
    app.start()


def _limit_memory(mebibytes: int) -> None:
    """Have what goes beyond so much memory raise MemoryError, where the system knows such a limit; also if shared."""
    if sys.platform == "linux":
        import resource

        most = mebibytes << 20
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        addresses = pages * resource.getpagesize() + most
        resource.setrlimit(resource.RLIMIT_DATA, (most, most))
        resource.setrlimit(resource.RLIMIT_AS, (addresses, addresses))
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


def _replace_solutions(course: Course, lesson: str, exercises: Sequence[str]) -> None:
    """Have the lesson's checks take answers in, and its solutions give its pictures what the learner has written.

    No lock: whoever wants the solutions finds their file in the package.
    """
    package = importlib.import_module(course.module_of(lesson))
    module = ModuleType(f"{package.__name__}.exercises")
    for name in exercises:
        stand_ins[name] = StandIn(module.__name__, name)
    check = SimpleNamespace(**{name: Intake(name) for name in exercises})
    vars(module).update(vars(package.exercises) | stand_ins | {"check": check})
    vars(package).update(check=check, exercises=module)
    sys.modules[module.__name__] = module
    if course.kernel_setup:
        setup_module, _, function = course.kernel_setup.partition(":")
        set_up = getattr(importlib.import_module(setup_module), function)
        set_up(lesson, exercises, answers, taken)


def taken_in(exercises: Sequence[str]) -> str:
    """What the cell that has just run answers; where nothing is handed in, what has the name of one of `exercises`.

    Returns JSON: "answers": {name: {"kind": function, value or solution, "value": as text, "checked": whether it was
    handed in}}, where the text of a function is "unfinished" if there are still dots in it; "is_full": whether the cell
    has left no memory.
    """
    from IPython import get_ipython

    here = get_ipython().user_ns
    checked = list(dict.fromkeys(handed_in))
    handed_in.clear()
    defined = []
    for name in exercises:
        if name in here and name not in checked and _is_new(name, here[name]):
            defined.append(name)
            answers[name] = here[name]
    described = {}
    for name in checked + defined:
        described[name] = _described(answers[name], stand_ins[name])
        described[name]["checked"] = name in checked
    return json.dumps({"answers": described, "is_full": is_full()})


def _is_new(name: str, thing: Any) -> bool:
    known = [answers.get(name), *taken]
    return not isinstance(thing, Intake) and not any(thing is one for one in known)


def is_full() -> bool:
    """Whether there is no memory left: then whatever comes next would fail."""
    try:
        bytearray(NEEDED)
    except MemoryError:
        return True
    return False


def _described(answer: Any, solution: StandIn | None = None) -> dict[str, Any]:
    if solution is not None and safely(False, is_courses_own, answer, solution):
        return {"kind": "solution", "value": ""}
    if callable(answer):
        is_blank = safely(False, is_unfinished, answer)
        return {"kind": "function", "value": "unfinished" if is_blank else ""}
    return {"kind": "value", "value": written(answer)}


def call(name: str, arguments: str, substitutes: str) -> str:
    """Call an answer with arguments that the grader has pickled; returns JSON of what `attempt` returns, and more.

    substitutes: pickled, too, functions that the answer finds in the notebook instead of those of the same names
    """
    try:
        os.getcwd()
    except FileNotFoundError:
        # a cell has deleted it, and some modules cannot be imported from nowhere
        os.chdir(Path(__file__).parent)
    answer = answers[name]
    things = _unpacked(arguments)
    names = getattr(answer, "__globals__", None) or sys.modules["__main__"].__dict__
    with _substituting(names, _unpacked(substitutes)):
        judged.append(name)
        try:
            value, failure, printed = attempt(answer, *things)
        finally:
            judged.clear()
    result = {
        "value": written(value),
        "failure": None if failure is None else vars(failure),
        "printed": printed[:200],
        "states": [written(state_of(thing)) for thing in things],
    }
    return json.dumps(result)


def _unpacked(text: str) -> Any:
    return cloudpickle.loads(base64.b64decode(text))


@contextmanager
def _substituting(names: dict[str, Any], substitutes: dict[str, Any]) -> Iterator[None]:
    """Have other things stand under some names of the notebook for a while."""
    before = {name: names[name] for name in substitutes if name in names}
    names.update(substitutes)
    try:
        yield
    finally:
        for name in substitutes:
            del names[name]
        names.update(before)
