"""Right answers are kept in the learner's own file, and later lessons take them from there.

The file, `my_functions.py`, lies beside the notebooks. It is a plain Python module, one function after another, each
under a line that says of which lesson it is.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import math
import re
import sys
import textwrap
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from rlrobot_edu.course.grading.values import one_line, safely
from rlrobot_edu.files import write_whole

FILE = "my_functions.py"
HEAD = '''"""My functions. The check of its lesson has found each of them right."""

import math

import numpy as np
'''
LESSON = re.compile(r"^# lesson (\w+): (\w+)$", re.MULTILINE)
LESSONS = sorted(
    path.parent.name.removeprefix("lesson_") for path in Path(__file__).parent.glob("lesson_*/solutions.py")
)

NOT_KEPT = "# not kept: "  # the reason follows
ONLY_DEF = "only what is written with def can be kept"

Judge = Callable[[Any], Any]


def keep(answer: Callable[..., Any], lesson: str, name: str, judge: Judge, folder: str | Path = ".") -> str:
    """Write a right answer to the learner's file, if it also works on its own; returns a sentence that says so.

    lesson: its number; name: of the function; judge: the check, true for a right answer
    """
    path = Path(folder, FILE)
    known = _kept(path)
    surroundings = _surroundings(lesson, known)
    source = safely("", _source_of, answer, name)
    source = source and safely("", _helpers, answer, {*surroundings, answer.__name__}) + source
    again = safely(None, _made, source, name, surroundings)
    is_kept = again is not None and bool(judge(again))
    why = f"on its own, {name} does not work: put all that it needs, imports too, inside it" if source else ONLY_DEF
    if is_kept:
        known[lesson, name] = source
    else:  # an older right version stays
        known.setdefault((lesson, name), f"{NOT_KEPT}{why}\n")
    parts = [f"# lesson {number}: {title}\n{text}" for (number, title), text in sorted(known.items())]
    write_whole(path, "\n\n".join([HEAD, *parts]))
    return f"Kept in {FILE}, for the lessons to come." if is_kept else f"(Not kept for later lessons: {why}.)"


def take(lesson: str, *names: str, folder: str | Path = ".") -> Any:
    """The learner's functions of a lesson; where there is none, or where it is not right, the given version.

    lesson: its number, "02", which stands for its appendix 02a, too; names: of one or more functions
    Returns one function or a list of them, and says whose they are.
    """
    path = Path(folder, FILE)
    known = _kept(path)
    functions, yours, given, rooms = [], [], [], []
    for name in names:
        rooms_of_it = [room for room in LESSONS if room.startswith(lesson) and hasattr(_room(room, "solutions"), name)]
        if not rooms_of_it:
            raise ValueError(f"lesson {lesson} has no function {name!r:.200} that could be taken from there")
        room = rooms_of_it[0]
        mine = _right(known, room, name)
        is_right = mine is not None
        (yours if is_right else given).append(name)
        rooms += [room] * (not is_right and room not in rooms)
        functions.append(mine if is_right else getattr(_room(room, "solutions"), name))
        kept = known.get((room, name), "")
        if not is_right and kept.startswith(NOT_KEPT):
            print(f"{name} is green, but it is not kept: {kept.removeprefix(NOT_KEPT).strip()}.")
    if given and (mistake := _syntax_error(path)):
        print(mistake)
    told = [f"yours: {', '.join(yours)}"] * bool(yours)
    where = f"(yours comes here when its check in lesson {' or '.join(rooms)} is green)"
    told += [f"given: {', '.join(given)} {where}"] * bool(given)
    print("; ".join(told))
    return functions if len(functions) > 1 else functions[0]


def is_right(lesson: str, name: str, folder: str | Path = ".") -> bool:
    """Whether the learner's file has this function of a lesson, and its check finds it right."""
    known = _kept(Path(folder, FILE))
    was_right = known.get((lesson, name), "").startswith(NOT_KEPT)  # its check was green, though it is not kept
    return was_right or _right(known, lesson, name) is not None


def whose(*functions: Callable[..., Any]) -> str:
    """The owner of the functions that `take` returned, for a legend: "your", "the given", or "partly your" for both."""
    yours = [function.__code__.co_filename.startswith(f"<{FILE}: ") for function in functions]
    return "your" if all(yours) else "partly your" if any(yours) else "the given"


def is_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, where there is a learner."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    return getattr(shell, "kernel", None) is not None


@cache
def _room(lesson: str, name: str) -> ModuleType:
    return importlib.import_module(f"rlrobot_edu.course.lesson_{lesson}.{name}")


def _source_of(answer: Callable[..., Any], name: str) -> str:
    """The source of a function made with def, under the name `name`."""
    source = textwrap.dedent(inspect.getsource(answer)).rstrip() + "\n"
    definition = ast.parse(source).body[0]
    if not isinstance(definition, ast.FunctionDef) or definition.decorator_list:
        return ""
    return source if definition.name == name else f"{source}\n\n{name} = {definition.name}\n"


def _helpers(answer: Callable[..., Any], known: set[str]) -> str:
    """The source of what a function calls or reads by name beside the names `known`: functions, modules, numbers."""
    source, codes = "", [answer.__code__]
    while codes:
        code = codes.pop()
        codes += [constant for constant in code.co_consts if isinstance(constant, CodeType)]
        for name in code.co_names:
            if name in known or name not in answer.__globals__:
                continue
            thing = answer.__globals__[name]
            known.add(name)
            if isinstance(thing, ModuleType):
                source += f"import {thing.__name__} as {name}\n"
            elif isinstance(thing, FunctionType | BuiltinFunctionType) and thing.__module__ != answer.__module__:
                source += f"from {thing.__module__} import {thing.__name__} as {name}\n"
            elif isinstance(thing, FunctionType):
                source += f"{_helpers(thing, known)}{_source_of(thing, name)}\n\n"
            elif isinstance(thing, int | float | str):
                source += f"{name} = {thing!r}\n"
    return source


def _syntax_error(path: Path) -> str:
    """Says in a sentence where the learner's file is not valid Python; empty if it is valid, or missing."""
    try:
        ast.parse(path.read_text("utf-8"))
    except (SyntaxError, ValueError) as error:
        where = f", line {error.lineno}" if isinstance(error, SyntaxError) else ""
        return f"{path.name}{where}: Python cannot read this ({error.args[0]}); mend it, or run the check again."
    except OSError:
        return ""
    return ""


def _kept(path: Path) -> dict[tuple[str, str], str]:
    """The functions in the learner's file, {(lesson, name): source}; functions that cannot be read are left out."""
    text = safely("", path.read_text, "utf-8")
    parts = LESSON.split(text)[1:]
    return {(parts[i], parts[i + 1]): parts[i + 2].strip("\n") + "\n" for i in range(0, len(parts), 3)}


def _surroundings(lesson: str, known: dict[tuple[str, str], str]) -> dict[str, Any]:
    """The names that a function of `lesson` may use: numpy, math, and the functions of the lessons up to it."""
    names: dict[str, Any] = {"np": np, "numpy": np, "math": math}
    for number in (n for n in LESSONS if n <= lesson):
        names |= {name: thing for name, thing in vars(_room(number, "solutions")).items() if callable(thing)}
        for (owner, name), source in known.items():
            if owner == number and (mine := safely(None, _made, source, name, names)) is not None:
                names[name] = mine
    return names


def _right(known: dict[tuple[str, str], str], lesson: str, name: str) -> Callable[..., Any] | None:
    """The learner's function, if its check finds it right; else None."""
    mine = safely(None, _made, known.get((lesson, name), ""), name, _surroundings(lesson, known))
    return mine if mine is not None and getattr(_room(lesson, "check"), name).judge(mine) else None


def _made(source: str, name: str, surroundings: dict[str, Any]) -> Callable[..., Any] | None:
    """The function of this name that the source defines; None if it is not in the file."""
    if source.startswith(NOT_KEPT):
        return None
    made = dict(surroundings)
    exec(compile(source, one_line(f"<{FILE}: {name}>"), "exec"), made)
    function = made[name]
    return function if callable(function) and source else None
