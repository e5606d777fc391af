"""The kernel's side of grading: limits, no solutions in reach, answers taken in and called.

All that this module tells the grader is data that the grader's own checks judge. So whoever changes it here, from a
notebook, gains nothing: to be right, the right values must come out, and for arguments that nobody knows beforehand.
"""

from __future__ import annotations

import base64
import json
import os
import re
import sys
from collections.abc import Callable, Sequence
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

SHELL_EVENTS = ("subprocess.Popen", "os.system", "os.exec", "os.posix_spawn", "os.link", "os.symlink", "os.rename")
HOLDS_ANSWERS = ("solutions", "check", "mistakes", "questions")  # in the names of a lesson's files

HOLD_SOLUTION = ("right", "library", "mistakes", "wrong_functions")  # parts of an exercise

answers: dict[str, Any] = {}  # what has been handed in, by exercise
handed_in: list[str] = []  # since the grader asked last
notes: list[str] = []  # what the instructor should hear


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

    def __getattr__(self, name: str) -> Any:
        if name in HOLD_SOLUTION:
            notes.append(f"it looks into the check of {self._name} (at {name}), which holds the solution")
        raise AttributeError(f"the check of {self._name} shows nothing while a notebook is graded")


def start() -> None:
    """Run a kernel for one submission; the arguments: lesson, its exercises, MiB of memory, connection file."""
    lesson, exercises, memory, connection_file = sys.argv[1:5]
    from ipykernel.kernelapp import IPKernelApp

    app = IPKernelApp.instance()
    app.initialize(["-f", connection_file])
    app.shell.ask_exit = sys.exit  # exit() would end the kernel; so it ends a cell
    _stand_in(lesson, exercises.split(","))
    _limit_memory(int(memory))
    sys.addaudithook(_guard(COURSE / room_of(lesson)))
    app.start()


def _limit_memory(mebibytes: int) -> None:
    """Have what goes beyond so much memory raise MemoryError, where the system knows such a limit."""
    if sys.platform == "linux":
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (mebibytes << 20, mebibytes << 20))


def _stand_in(lesson: str, exercises: Sequence[str]) -> None:
    """Put modules that hold no answers in the places of the lesson's checks and solutions."""
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
        if name.startswith("__"):
            raise AttributeError(name)
        if not str(sys._getframe(1).f_globals.get("__name__", "")).startswith("rlrobot_edu."):
            notes.append(f"it takes {name} from the lesson's solutions")
            raise AttributeError("the solutions are not to be had while a notebook is graded")
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


def _guard(room: Path) -> Callable[[str, tuple[Any, ...]], None]:
    """An audit hook that keeps the files which hold the answers of a lesson shut, and notes who tries."""
    folder, shut = os.path.realpath(room), HOLDS_ANSWERS
    names_room = re.compile(rf"{room.name}(?![a-z])").search
    realpath, note = os.path.realpath, notes.append  # these, whatever becomes of their names

    def look(event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open" and isinstance(arguments[0], str | bytes):
            try:
                path = realpath(os.fsdecode(arguments[0]))
            except OSError:  # the working directory is gone, so nothing in it can be opened
                return
            if path.startswith(folder + os.sep) and any(word in path.rpartition(os.sep)[2] for word in shut):
                note(f"it opens {path.rpartition(os.sep)[2]}, which holds the solution")
                raise PermissionError("the solutions are not to be had while a notebook is graded")
        elif event in SHELL_EVENTS and names_room(told := str(arguments)) and "solutions" in told:
            note("it looks for the solutions by way of another program or another name")
            raise PermissionError("the solutions are not to be had while a notebook is graded")

    return look


def taken_in(exercises: Sequence[str]) -> str:
    """What the cell that has just run answers; names of `exercises` that it binds count where nothing is handed in.

    Returns JSON: {"answers": {name: {"kind": function or value, "value": as text}}, "notes": sentences}; the text of a
    function is "unfinished" if there are still dots in it.
    """
    from IPython import get_ipython

    here = get_ipython().user_ns
    for name in exercises:
        if name not in handed_in and name in here:
            answers[name] = here[name]
            handed_in.append(name)
    told = {name: _described(answers[name]) for name in handed_in}
    handed_in.clear()
    return _with_notes({"answers": told})


def _described(answer: Any) -> dict[str, str]:
    if callable(answer):
        return {"kind": "function", "value": "unfinished" if safely(False, is_unfinished, answer) else ""}
    return {"kind": "value", "value": written(answer)}


def called(name: str, arguments: str) -> str:
    """Call an answer with arguments that the grader has pickled; returns JSON of what `attempt` returns, and more."""
    try:
        os.getcwd()
    except FileNotFoundError:  # a cell has deleted it, and some modules cannot be imported from nowhere
        os.chdir(COURSE)
    given = cloudpickle.loads(base64.b64decode(arguments))
    value, failure, printed = attempt(answers[name], *given)
    told = {
        "value": written(value),
        "failure": None if failure is None else vars(failure),
        "printed": printed[:200],
        "states": [written(state_of(thing)) for thing in given],
    }
    return _with_notes(told)


def _with_notes(told: dict[str, Any]) -> str:
    told["notes"] = notes[:20]
    notes.clear()
    return json.dumps(told)
