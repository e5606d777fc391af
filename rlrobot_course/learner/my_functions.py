"""Right answers are kept in the learner's own file, and later lessons take them from there.

The file, `my_functions.py`, lies beside the notebooks. It is a plain Python module, one function after another, each
in a section that says of which lesson it is. It belongs to the learner: a check changes its own section there and
leaves all else as it is.
"""

import ast
import importlib
import inspect
import math
import textwrap
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import (
    BuiltinFunctionType,
    CodeType,
    FunctionType,
    ModuleType,
    SimpleNamespace,
)
from typing import Any

import numpy as np

from rlrobot_course.learner.learners_files import (
    alone_with,
    beside_the_lessons,
    put_aside,
)
from rlrobot_course.learner.sections import NOT_KEPT, Key, sources, with_source
from rlrobot_edu.checks import did_you_mean
from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.progress import watched
from rlrobot_grading.answers.values import Function, one_line, safely

FILE = "my_functions.py"
LESSONS = sorted(
    path.parent.name.removeprefix("lesson_")
    for path in Path(__file__).parents[1].glob("lesson_*/exercises.py")
)

ONLY_DEF = "only what is written with def, and without a decorator, can be kept"

Judge = Callable[[Any], Any]


def keep(
    answer: Function,
    lesson: str,
    name: str,
    judge: Judge,
    folder: str | Path = ".",
) -> str:
    """Write a right answer to the learner's file, if it also works on its own; returns a sentence that says so.

    lesson: its number; name: of the function; judge: the check, true for a right answer
    """
    path, key = beside_the_lessons(Path(folder, FILE)), (lesson, name)
    surroundings = _surroundings(lesson, _kept(path))
    source = safely("", _source_of, answer, name)
    source = (
        source
        and safely("", _helpers, answer, {*surroundings, answer.__name__}) + source
    )

    def works(text: str) -> bool:
        again = safely(None, _made, text, name, surroundings)
        return again is not None and bool(judge(again))

    is_kept = works(source)
    why = (
        f"on its own, {name} does not work: put all that it needs, imports too, inside it"
        if source
        else ONLY_DEF
    )
    try:
        with alone_with(path):
            told = _written(path, key, source if is_kept else f"{NOT_KEPT}{why}\n")
    except (OSError, ValueError) as error:
        return f"(Not kept for later lessons: {FILE} stays as it was: {error}.)"
    return (
        f"Kept in {FILE}, for the lessons to come.{told}"
        if is_kept
        else f"(Not kept for later lessons: {why}.{told})"
    )


def take(lesson: str, *names: str, folder: str | Path = ".") -> Any:
    """The learner's functions of a lesson; where there is none, or where it is not right, the given version.

    lesson: its number, "02"; names: of one or more functions
    Returns one function or a list of them, and says whose they are.
    """
    path = beside_the_lessons(Path(folder, FILE))
    known = _kept(path)
    functions, yours, given, lessons = [], [], [], []
    for name in names:
        number = _lesson_with(lesson, name)
        mine = _right(known, number, name)
        if mine is not None:
            yours.append(name)
            functions.append(mine)
            continue
        given.append(name)
        functions.append(vars(check_of(number))[name].right)
        if number not in lessons:
            lessons.append(number)
        kept = known.get((number, name), "")
        if kept.startswith(NOT_KEPT):
            reason = kept.removeprefix(NOT_KEPT).strip()
            print(f"{name} is green, but it is not kept: {reason}.")
    mistake = syntax_error(path)
    if given and mistake:
        print(mistake)
    owners = []
    if yours:
        owners.append(f"yours: {', '.join(yours)}")
    if given and (yours or watched()):
        where = f"when its check in lesson {' or '.join(lessons)} is green"
        owners.append(f"given: {', '.join(given)} (yours comes here {where})")
    if owners:
        print("; ".join(owners))
    return functions if len(functions) > 1 else functions[0]


def _lesson_with(lesson: str, name: str) -> str:
    """The lesson, or the part of it, that has an exercise of this name. Raises ValueError if none has."""
    there: list[str] = []
    for number in LESSONS:
        if number.startswith(lesson):
            if name in vars(check_of(number)):
                return number
            there += vars(check_of(number))
    raise ValueError(
        f"lesson {lesson} has no function {name!r:.200} to take from there{did_you_mean(name, there)}"
    )


def is_right(lesson: str, name: str, folder: str | Path = ".") -> bool:
    """Whether the learner's file has this function of a lesson, and its check finds it right."""
    known = _kept(beside_the_lessons(Path(folder, FILE)))
    was_right = known.get((lesson, name), "").startswith(
        NOT_KEPT
    )  # its check was green, though it is not kept
    return was_right or _right(known, lesson, name) is not None


def written(lesson: str, folder: str | Path = ".") -> set[str]:
    """The names of a lesson's functions that the learner's file has, or of which it says why they are not kept."""
    known = _kept(beside_the_lessons(Path(folder, FILE)))
    return {name for owner, name in known if owner == lesson}


def owner_of(*functions: Function) -> str:
    """The owner of the functions that `take` returned, for a legend: "your", "the given", or "partly your" for both."""
    yours = [
        function.__code__.co_filename.startswith(f"<{FILE}: ") for function in functions
    ]
    if all(yours):
        return "your"
    if any(yours):
        return "partly your"
    return "the given"


@cache
def check_of(lesson: str) -> SimpleNamespace:
    """The exercises of a lesson."""
    return importlib.import_module(f"rlrobot_course.lesson_{lesson}.exercises").check  # type: ignore[no-any-return]


def _source_of(answer: Function, name: str) -> str:
    """The source of a function made with def, under the name `name`."""
    source = textwrap.dedent(inspect.getsource(answer)).rstrip() + "\n"
    definition = ast.parse(source).body[0]
    if not isinstance(definition, ast.FunctionDef) or definition.decorator_list:
        return ""
    return (
        source
        if definition.name == name
        else f"{source}\n\n{name} = {definition.name}\n"
    )


def _helpers(answer: Function, known: set[str]) -> str:
    """The source of what a function calls or reads by name beside the names `known`: functions, modules, numbers."""
    source, codes = "", [answer.__code__]
    while codes:
        code = codes.pop()
        codes += [
            constant for constant in code.co_consts if isinstance(constant, CodeType)
        ]
        for name in code.co_names:
            if name in known or name not in answer.__globals__:
                continue
            thing = answer.__globals__[name]
            known.add(name)
            if isinstance(thing, ModuleType):
                source += f"import {thing.__name__} as {name}\n"
            elif (
                isinstance(thing, FunctionType | BuiltinFunctionType)
                and thing.__module__ != answer.__module__
            ):
                source += f"from {thing.__module__} import {thing.__name__} as {name}\n"
            elif isinstance(thing, FunctionType):
                source += f"{_helpers(thing, known)}{_source_of(thing, name)}\n\n"
            elif isinstance(thing, int | float | str):
                source += f"{name} = {thing!r}\n"
    return source


def _written(path: Path, key: Key, source: str) -> str:
    """Write the source of a function, or why it is not kept, to the learner's file; returns what else is to be said.

    An older right version stays where the new one is not kept.
    """
    text = _text(path.read_bytes() if path.exists() else b"")
    if key in sources(text or "") and source.startswith(NOT_KEPT):
        return ""
    new = with_source(text or "", key, source)
    told = put_aside(path) if text is None else ""
    if new != text:
        write_whole(path, new)
    return f" {told}" if told else ""


def _text(data: bytes) -> str | None:
    """The text of the learner's file; None where it is none in UTF-8."""
    text = safely(None, data.decode, "utf-8-sig")
    return None if text is None or "\0" in text else text.replace("\r\n", "\n")


def syntax_error(path: Path) -> str:
    """Says in a sentence where the learner's file is not valid Python; empty if it is valid, or missing."""
    text = _text(safely(b"", path.read_bytes))
    if text is None:
        return f"{path.name}: this is no text that can be read; save it as UTF-8, or run the check again."
    try:
        ast.parse(text)
    except (SyntaxError, ValueError) as error:
        where = f", line {error.lineno}" if isinstance(error, SyntaxError) else ""
        return f"{path.name}{where}: Python cannot read this ({error.args[0]}); mend it, or run the check again."
    return ""


def _kept(path: Path) -> dict[Key, str]:
    """The functions in the learner's file, {(lesson, name): source}; functions that cannot be read are left out."""
    return sources(_text(safely(b"", path.read_bytes)) or "")


def _surroundings(lesson: str, known: dict[tuple[str, str], str]) -> dict[str, Any]:
    """The names that a function of `lesson` may use: numpy, math, and the functions of the lessons up to it."""
    names: dict[str, Any] = {"np": np, "numpy": np, "math": math}
    for number in (n for n in LESSONS if n <= lesson):
        names |= {
            name: one.right
            for name, one in vars(check_of(number)).items()
            if callable(one.right)
        }
        for (owner, name), source in known.items():
            if owner != number:
                continue
            mine = safely(None, _made, source, name, names)
            if mine is not None:
                names[name] = mine
    return names


def _right(
    known: dict[tuple[str, str], str], lesson: str, name: str
) -> Function | None:
    """The learner's function, if its check finds it right; else None."""
    mine = safely(
        None, _made, known.get((lesson, name), ""), name, _surroundings(lesson, known)
    )
    return (
        mine if mine is not None and vars(check_of(lesson))[name].judge(mine) else None
    )


def _made(source: str, name: str, surroundings: dict[str, Any]) -> Function | None:
    """The function of this name that the source defines; None if it is not in the file."""
    if source.startswith(NOT_KEPT):
        return None
    made = dict(surroundings)
    exec(compile(source, one_line(f"<{FILE}: {name}>"), "exec"), made)
    function = made[name]
    return function if callable(function) and source else None
