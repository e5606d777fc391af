"""The kernel's side of grading: a limit of memory, answers taken in and called.

All that this module tells the grader is data that the grader's own checks judge. So whoever changes it here, from a
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

from rlrobot_course.learner import my_functions
from rlrobot_grading.answers.limits import attempt
from rlrobot_grading.answers.source import COURSES_OWN, is_courses_own, is_unfinished
from rlrobot_grading.answers.values import safely
from rlrobot_grading.marking.rooms import COURSE, room_of
from rlrobot_grading.marking.serialization import state_of, written

answers: dict[
    str, Any
] = {}  # what has been handed in, by exercise; where nothing has, what defines it
handed_in: list[str] = []  # since the grader asked last
given: dict[str, Given] = {}  # what stands in for the solutions
taken: list[Any] = []  # what `take` has given: no answers
judged: list[str] = []  # exercises whose answers the grader is calling
ROOM = 16 * 2**20  # memory that a kernel must have left [bytes]


class NotGivenError(LookupError, AttributeError):
    """Something of a lesson that there is at home, and not while a notebook is graded: not the learner's fault."""


class Intake:
    """It stands where an exercise stood: what it is called with is an answer that is handed in."""

    hints: tuple[str, ...] = ()

    def __init__(self, name: str) -> None:
        self._name, self.right = name, given.get(name)

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


class Given:
    """It stands where a solution stood: the lesson's pictures call it, and get what the learner has written."""

    def __init__(self, room: str, name: str) -> None:
        self.__name__, self.__module__ = name, f"{room}.exercises"

    def __call__(self, *arguments: Any, **more: Any) -> Any:
        """What the learner's function returns. Raises NotGivenError if there is none, or if it calls the solution."""
        if self.__name__ in judged:
            raise NotGivenError(COURSES_OWN)
        answer = answers.get(self.__name__)
        if not callable(answer) or isinstance(answer, Given):
            raise NotGivenError(
                f"{self.__name__} is an exercise of this notebook; while it is graded none is given"
            )
        return answer(*arguments, **more)


def start() -> None:
    """Run a kernel for one submission; the arguments: lesson, its exercises, MiB of memory, connection file."""
    lesson, exercises, memory, connection_file = sys.argv[1:5]
    from ipykernel.kernelapp import IPKernelApp

    app = IPKernelApp.instance()
    app.initialize(["-f", connection_file])
    type(app.shell).ask_exit = staticmethod(
        sys.exit
    )  # exit() would end the kernel; so it ends a cell
    _stand_in(lesson, exercises.split(","))
    _limit_memory(int(memory))
    app.start()


def _limit_memory(mebibytes: int) -> None:
    """Have what goes beyond so much memory raise MemoryError, where the system knows such a limit; also if shared."""
    if sys.platform == "linux":
        import resource

        most, pages = (
            mebibytes << 20,
            int(Path("/proc/self/statm").read_text().split()[0]),
        )
        resource.setrlimit(resource.RLIMIT_DATA, (most, most))
        resource.setrlimit(
            resource.RLIMIT_AS, (pages * resource.getpagesize() + most,) * 2
        )
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


def _stand_in(lesson: str, exercises: Sequence[str]) -> None:
    """Have the lesson's checks take answers in, and its solutions give its pictures what the learner has written.

    No lock: whoever wants the solutions finds their file in the package.
    """
    room = f"rlrobot_course.{room_of(lesson)}"
    here = importlib.import_module(room)
    given.update({name: Given(room, name) for name in exercises})
    check = SimpleNamespace(**{name: Intake(name) for name in exercises})
    stand_in = ModuleType(f"{room}.exercises")
    vars(stand_in).update(vars(here.exercises) | given | {"check": check})
    vars(here).update(check=check, exercises=stand_in)
    sys.modules[stand_in.__name__] = stand_in
    _let_take_give(lesson, exercises)


def _let_take_give(lesson: str, exercises: Sequence[str]) -> None:
    """Let `take` hand out the learner's own functions of this lesson; of other lessons the given ones, as always."""
    take = my_functions.take
    my_functions.LESSONS = [other for other in my_functions.LESSONS if other != lesson]

    def take_own(number: str, *names: str, folder: str | Path = ".") -> Any:
        own = {
            name: answers.get(name)
            for name in names
            if lesson.startswith(number) and name in exercises
        }
        if missing := [name for name, answer in own.items() if not callable(answer)]:
            raise NotGivenError(
                f"{missing[0]} is an exercise of this notebook; while it is graded none is given"
            )
        found = [
            own[name] if name in own else take(number, name, folder=folder)
            for name in names
        ]
        taken.extend(found)
        return found if len(found) > 1 else found[0]

    my_functions.take = take_own


def taken_in(exercises: Sequence[str]) -> str:
    """What the cell that has just run answers; where nothing is handed in, what has the name of one of `exercises`.

    Returns JSON: "answers": {name: {"kind": function, value or solution, "value": as text, "checked": whether it was
    handed in}}, where the text of a function is "unfinished" if there are still dots in it; "is_full": whether the cell
    has left no memory.
    """
    from IPython import get_ipython

    here, checked = get_ipython().user_ns, list(dict.fromkeys(handed_in))
    handed_in.clear()
    defined = [
        name
        for name in exercises
        if name in here and name not in checked and _is_new(name, here[name])
    ]
    answers.update({name: here[name] for name in defined})
    told = {
        name: _described(answers[name], given[name]) | {"checked": name in checked}
        for name in checked + defined
    }
    return json.dumps({"answers": told, "is_full": is_full()})


def _is_new(name: str, thing: Any) -> bool:
    return not isinstance(thing, Intake) and not any(
        thing is known for known in [answers.get(name), *taken]
    )


def is_full() -> bool:
    """Whether there is no memory left: then whatever comes next would fail."""
    try:
        bytearray(ROOM)
    except MemoryError:
        return True
    return False


def _described(answer: Any, solution: Given | None = None) -> dict[str, Any]:
    if solution is not None and safely(False, is_courses_own, answer, solution):
        return {"kind": "solution", "value": ""}
    if callable(answer):
        return {
            "kind": "function",
            "value": "unfinished" if safely(False, is_unfinished, answer) else "",
        }
    return {"kind": "value", "value": written(answer)}


def called(name: str, arguments: str, lent: str = "") -> str:
    """Call an answer with arguments that the grader has pickled; returns JSON of what `attempt` returns, and more.

    lent: pickled, too, functions that the answer finds in the notebook instead of those of the same names
    """
    try:
        os.getcwd()
    except (
        FileNotFoundError
    ):  # a cell has deleted it, and some modules cannot be imported from nowhere
        os.chdir(COURSE)
    answer, things = answers[name], _unpacked(arguments)
    names = getattr(answer, "__globals__", None) or sys.modules["__main__"].__dict__
    with _lending(names, _unpacked(lent) if lent else {}):
        judged.append(name)
        try:
            value, failure, printed = attempt(answer, *things)
        finally:
            judged.clear()
    told = {
        "value": written(value),
        "failure": None if failure is None else vars(failure),
        "printed": printed[:200],
        "states": [written(state_of(thing)) for thing in things],
    }
    return json.dumps(told)


def _unpacked(text: str) -> Any:
    return cloudpickle.loads(base64.b64decode(text))


@contextmanager
def _lending(names: dict[str, Any], lent: dict[str, Any]) -> Iterator[None]:
    """Have other things stand under some names of the notebook for a while."""
    own = {name: names[name] for name in lent if name in names}
    names.update(lent)
    try:
        yield
    finally:
        for name in lent:
            del names[name]
        names.update(own)
