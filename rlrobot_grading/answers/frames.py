"""What the frames of an exception tell: the call that went wrong, or the index of which list.

A learner knows the lines of the own function only. Where an error comes up further down, in a function that such a line
calls, its text speaks of things that are not there; what the call was given says more.
"""

from __future__ import annotations

import ast
import builtins
import inspect
import re
import sys
from collections.abc import Mapping
from types import BuiltinMethodType, CodeType, FrameType, FunctionType, MethodType
from typing import Any

import numpy as np

from rlrobot_grading.answers.values import one_line, show

FUNCTIONS = (FunctionType, MethodType, BuiltinMethodType)
# their errors speak of what they were given
LIBRARIES = sys.stdlib_module_names | {"numpy", "scipy"}
HIDDEN = (
    "inside your function, {0} is the name of a value, because it is given one there. So the function {0} is out of "
    "reach. Give the value another name."
)
HARMLESS = (ast.Expression, ast.Name, ast.Constant, ast.BinOp, ast.UnaryOp, ast.Add, ast.Sub, ast.USub, ast.Call,
            ast.Load)  # fmt: skip


def told_by(error: BaseException, frames: list[FrameType], line: str) -> str:
    """What is behind `error`, in words for the learner; empty where the frames do not tell.

    frames: the last one of the learner's function, and those that it called; line: the learner's, in which it happened
    """
    text = str(error)[:1000]  # a search in a text of megabytes would take for ever
    if (
        not isinstance(error, Exception)
        or isinstance(error, RecursionError)
        or "in this order" in text
    ):
        return ""
    if (
        len(frames) > 1
        and str(frames[1].f_globals.get("__name__", "")).partition(".")[0]
        not in LIBRARIES
    ):
        return _about_a_call(frames, text)
    if "object is not callable" in text:
        return _about_a_hidden_function(frames[0], line)
    known = {**vars(builtins), **frames[0].f_globals, **frames[0].f_locals}
    if type(error) is NameError:
        return _about_a_name(frames[0].f_locals, error.name, line)
    found = re.search(r"(\w+)\(\) (missing|takes|got)", text)
    if found:
        name = found[1]
        owner = re.search(rf"(\w+)\.{name}\(", line)
        called = getattr(known[owner[1]], name) if owner else known.get(name)
        return _about_its_arguments(called, name)
    is_index = isinstance(error, IndexError) or "indices must be" in text
    return _about_an_index(known, line) if is_index else ""


def _about_a_call(frames: list[FrameType], text: str) -> str:
    """What the function was given that the learner's line calls."""
    name = _known_as(frames[0], frames[1].f_code)
    # it may only hand over its *arguments
    given = next((given for given in map(_arguments, frames[1:]) if given), {})
    for one, value in given.items():
        if isinstance(value, MethodType | BuiltinMethodType) or (
            type(value) is FunctionType and "function" in text
        ):
            return f"{name} is given a function as its {one}: the round brackets that call it are missing."
        if value is None and "None" in text:
            return f"{name} is given None as its {one}. Did a function that you call return nothing?"
    if not given:
        return f"the error came up inside {name}, which this line calls. Are its arguments in order?"
    told = one_line(", ".join(f"{one} = {show(value)}" for one, value in given.items()))
    return f"the error came up inside {name}, which got {told}. Is each what it should be, and are they in order?"


def _arguments(frame: FrameType) -> dict[str, Any]:
    names = frame.f_code.co_varnames[: frame.f_code.co_argcount]
    return {
        name: frame.f_locals[name]
        for name in names
        if name != "self" and name in frame.f_locals
    }


def _known_as(frame: FrameType, code: CodeType) -> str:
    """The name by which a learner's line knows the function of this code, which may have another one at its home."""
    for name, thing in {**frame.f_globals, **frame.f_locals}.items():
        call = None
        if type(thing) is FunctionType:
            call = thing
        elif callable(thing):
            call = type(thing).__call__
        if getattr(call, "__code__", None) is code:
            return name
    return code.co_name


def _about_a_hidden_function(frame: FrameType, line: str) -> str:
    """Which function cannot be called in `line`, since a local value has its name."""
    for name in re.findall(r"(?<!\.)\b(\w+)\(", line):
        is_value = not callable(frame.f_locals.get(name, callable))
        if is_value and is_function(name, frame.f_globals):
            return HIDDEN.format(name)
    return ""


def is_function(name: str, names: Mapping[str, Any]) -> bool:
    """Whether a name is that of a function, where these names are known."""
    return callable(names.get(name, getattr(builtins, name, None)))


def _about_a_name(known: Mapping[str, Any], name: str, line: str) -> str:
    """Whose a name is that is not known on its own: an entry of a dictionary, or a method of a world."""
    for owner, thing in known.items():
        if isinstance(thing, dict) and f"{owner}[{name}]" in line:
            return (
                f'a key of a dictionary stands in quotation marks: {owner}["{name}"].'
            )
        if type(thing).__module__ not in ("builtins", "numpy") and callable(
            getattr(type(thing), name, None)
        ):
            return f"{name} belongs to {owner}: write {owner}.{name}(…)."
    return ""


def _about_its_arguments(function: Any, name: str) -> str:
    if not isinstance(function, FunctionType | MethodType):
        return ""
    return f"{name} takes ({', '.join(inspect.signature(function).parameters)}): hand over just these, in this order."


def _about_an_index(known: Mapping[str, Any], line: str) -> str:
    """Which index in `line` is beyond the end of its list, or no whole number."""
    for name, inside in re.findall(r"(\w+)\[([^\[\]:]+)\]", line):
        things = known.get(name)
        if type(things) not in (list, tuple, np.ndarray):
            continue
        for part in inside.split(","):
            index = _value(part.strip(), known)
            told = _about_a_number(name, things, part.strip(), index, "," in inside)
            if told:
                return told
    return ""


def _about_a_number(
    name: str, things: Any, part: str, index: Any, has_more: bool
) -> str:
    if type(index) in FUNCTIONS:
        return f"{part} is a function, and an index is a number: the round brackets that call it are missing."
    if isinstance(index, float):
        told = f"{part} is {round(float(index), 6)}, and an index is a whole number."
        if not has_more and np.ndim(things) == 1 and index in things:
            told += f" for {part} in {name} runs over the entries; their numbers are in range(len({name}))."
        return told
    n = len(things)
    is_number = isinstance(index, int | np.integer) and not isinstance(index, bool)
    if not is_number or has_more or np.ndim(things) > 1 or -n <= index < n:
        return ""
    what = (
        f"{part} is {index}" if part != str(index) else f"number {part} was asked for"
    )
    if n == 0:
        return f"{name} is empty here: it has no entry {index}."
    entries = f"{n} entries, numbered 0 to {n - 1}" if n > 1 else "one entry, number 0"
    return f"{name} has {entries}, and {what}."


def _value(expression: str, known: Mapping[str, Any]) -> Any:
    """The value of an index that is made of names, whole numbers, + and − alone: whatever else could do something."""
    if expression in known:
        return known[expression]
    tree = ast.parse(expression, mode="eval")
    if not all(isinstance(node, HARMLESS) for node in ast.walk(tree)):
        return None
    plain = {
        name: thing
        for name, thing in known.items()
        if isinstance(thing, int | np.integer | list | tuple)
    }
    return eval(
        compile(tree, "<index>", "eval"), {**plain, "__builtins__": {}, "len": len}
    )
