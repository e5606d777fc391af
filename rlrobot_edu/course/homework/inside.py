"""The kernel's side of grading: a limit of memory, answers taken in and called.

All that this module tells the grader is data that the grader's own checks judge. So whoever changes it here, from a
notebook, gains nothing: to be right, the right values must come out, and for arguments that nobody knows beforehand.
"""

from __future__ import annotations

import base64
import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

import cloudpickle

from rlrobot_edu.course import my_functions
from rlrobot_edu.course.grading.limits import attempt
from rlrobot_edu.course.grading.source import is_unfinished
from rlrobot_edu.course.grading.values import safely
from rlrobot_edu.course.homework.rooms import COURSE, room_of
from rlrobot_edu.course.homework.wire import state_of, written

answers: dict[str, Any] = {}  # what has been handed in, by exercise
handed_in: list[str] = []  # since the grader asked last


class HandedIn:
    """What a check says while a notebook is graded."""

    def __init__(self, text: str) -> None:
        self._text = text

    def __repr__(self) -> str:
        return self._text


class Intake:
    """It stands where an exercise stood: what it is called with is an answer that is handed in."""

    hints: tuple[str, ...] = ()

    def __init__(self, name: str) -> None:
        self._name = name

    def __call__(self, answer: Any = None) -> HandedIn:
        """Take an answer in."""
        answers[self._name] = answer
        handed_in.append(self._name)
        return HandedIn(f"{self._name} is handed in.")

    judge = __call__

    def hint(self, number: int = 1) -> HandedIn:
        """A hint, which there is only while learning."""
        return HandedIn("Hints are told while you learn, not while a notebook is graded.")


def start() -> None:
    """Run a kernel for one submission; the arguments: lesson, its exercises, MiB of memory, connection file."""
    lesson, exercises, memory, connection_file = sys.argv[1:5]
    from ipykernel.kernelapp import IPKernelApp

    app = IPKernelApp.instance()
    app.initialize(["-f", connection_file])
    app.shell.ask_exit = sys.exit  # exit() would end the kernel; so it ends a cell
    _stand_in(lesson, exercises.split(","))
    _limit_memory(int(memory))
    app.start()


def _limit_memory(mebibytes: int) -> None:
    """Have what goes beyond so much memory raise MemoryError, where the system knows such a limit; also if shared."""
    if sys.platform == "linux":
        import resource

        most, pages = mebibytes << 20, int(Path("/proc/self/statm").read_text().split()[0])
        resource.setrlimit(resource.RLIMIT_DATA, (most, most))
        resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + most,) * 2)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))


def _stand_in(lesson: str, exercises: Sequence[str]) -> None:
    """Have the lesson's checks take answers in, and its solutions give its pictures what the learner has written.

    No lock: whoever wants the solutions finds their file in the package.
    """
    room = f"rlrobot_edu.course.{room_of(lesson)}"
    check, solutions = ModuleType(f"{room}.check"), ModuleType(f"{room}.solutions")
    vars(check).update({name: Intake(name) for name in exercises})
    vars(solutions)["__getattr__"] = _learners_own(exercises)
    for module in (check, solutions):
        sys.modules[module.__name__] = module
        setattr(__import__(room, fromlist=["x"]), module.__name__.rpartition(".")[2], module)
    _let_take_give(lesson, exercises)


def _learners_own(exercises: Sequence[str]) -> Callable[[str], Any]:
    """How the stand-in of the solutions gives an attribute: to the lesson's pictures what the learner has written."""

    def give(name: str) -> Any:
        if name not in exercises:
            raise AttributeError(name)
        return lambda *arguments, **more: answers[name](*arguments, **more)

    return give


def _let_take_give(lesson: str, exercises: Sequence[str]) -> None:
    """Let `take` hand out the learner's own functions of this lesson; of other lessons the given ones, as always."""
    take = my_functions.take
    my_functions.LESSONS = [other for other in my_functions.LESSONS if other != lesson]

    def take_own(number: str, *names: str, folder: str | Path = ".") -> Any:
        own = {name: answers.get(name) for name in names if lesson.startswith(number) and name in exercises}
        if missing := [name for name, answer in own.items() if not callable(answer)]:
            raise LookupError(f"{missing[0]} is an exercise of this notebook, and while it is graded none is given")
        found = [own[name] if name in own else take(number, name, folder=folder) for name in names]
        return found if len(found) > 1 else found[0]

    my_functions.take = take_own


def taken_in(exercises: Sequence[str]) -> str:
    """What the cell that has just run answers; names of `exercises` that it binds count where nothing is handed in.

    Returns JSON: {name: {"kind": function or value, "value": as text}}; the text of a function is "unfinished" if there
    are still dots in it.
    """
    from IPython import get_ipython

    here = get_ipython().user_ns
    for name in exercises:
        if name not in handed_in and name in here:
            answers[name] = here[name]
            handed_in.append(name)
    told = {name: _described(answers[name]) for name in handed_in}
    handed_in.clear()
    return json.dumps(told)


def _described(answer: Any) -> dict[str, str]:
    if callable(answer):
        return {"kind": "function", "value": "unfinished" if safely(False, is_unfinished, answer) else ""}
    return {"kind": "value", "value": written(answer)}


def called(name: str, arguments: str, lent: str = "") -> str:
    """Call an answer with arguments that the grader has pickled; returns JSON of what `attempt` returns, and more.

    lent: pickled, too, functions that the answer finds in the notebook instead of those of the same names
    """
    try:
        os.getcwd()
    except FileNotFoundError:  # a cell has deleted it, and some modules cannot be imported from nowhere
        os.chdir(COURSE)
    answer, given = answers[name], _unpacked(arguments)
    with _lending(getattr(answer, "__globals__", {}), _unpacked(lent) if lent else {}):
        value, failure, printed = attempt(answer, *given)
    told = {
        "value": written(value),
        "failure": None if failure is None else vars(failure),
        "printed": printed[:200],
        "states": [written(state_of(thing)) for thing in given],
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
