"""Answers as source: a mistake is an edit of the right function, and a function may still be unfinished."""

from __future__ import annotations

import ast
import dis
import inspect
import linecache
import re
import textwrap
import zlib
from collections.abc import Mapping
from functools import cache
from types import ModuleType
from typing import Any

from rlrobot_grading.answers.limits import Elsewhere
from rlrobot_grading.answers.values import Function

COURSES_OWN = "This is the course's own solution, or a function that calls it. Write your own: only that counts."
CHANCE = {
    "random",
    "rng",
    "choice",
    "choices",
    "integers",
    "randint",
    "shuffle",
    "default_rng",
}


def edited(function: Function, changes: Mapping[str, str]) -> Function:
    """`function` with other text in its body: a new function that sees the same names.

    changes: what is written differently, {text in the body: text instead}; each is replaced wherever it occurs, all at
        once, so that two lines can change places
    Raises ValueError if a text does not occur.
    """
    head, body = head_and_body(function)[0], edited_body(function, changes)
    made: dict[str, Any] = {}
    file = f"<{function.__name__} {zlib.crc32((head + body).encode()):x}>"
    # to edit it again
    linecache.cache[file] = (
        len(head + body),
        None,
        (head + body).splitlines(keepends=True),
        file,
    )
    # in `made`: calls of the same name inside it reach the right one
    exec(compile(head + body, file, "exec"), function.__globals__, made)
    return made[function.__name__]  # type: ignore[no-any-return]


def edited_body(function: Function, changes: Mapping[str, str]) -> str:
    """The text of that new function's body. Raises ValueError as `edited` does."""
    body = head_and_body(function)[1]
    for text in changes:
        if text not in body:
            raise ValueError(
                f"{text!r} does not occur in the body of {function.__name__}."
            )
    return re.sub(
        "|".join(map(re.escape, changes)), lambda match: changes[match[0]], body
    )


@cache
def head_and_body(function: Function) -> tuple[str, str]:
    """The source of a function: its first lines, up to the colon, and the rest."""
    source = textwrap.dedent(inspect.getsource(function))
    definition = ast.parse(source).body[0]
    assert isinstance(definition, ast.FunctionDef)
    lines = source.splitlines(keepends=True)
    first = definition.body[0].lineno - 1
    return "".join(lines[:first]), "".join(lines[first:])


def tree_of(function: Function) -> ast.Module:
    """The source of a function, read by Python."""
    return ast.parse(textwrap.dedent(inspect.getsource(function)))


def parameters(function: Function) -> tuple[str, ...]:
    """Names of the arguments that must be given, in their order."""
    known = inspect.signature(function).parameters.values()
    return tuple(
        parameter.name for parameter in known if parameter.default is parameter.empty
    )


def is_unfinished(answer: Function) -> bool:
    """Whether a function still has the dots that an exercise begins with, or nothing at all in it."""
    if isinstance(answer, Elsewhere):
        return answer.is_unfinished
    code = getattr(answer, "__code__", None)
    if code is None:
        return False
    steps = {instruction.opname for instruction in dis.get_instructions(code)}
    does_nothing = steps <= {"RESUME", "LOAD_CONST", "RETURN_VALUE", "RETURN_CONST"}
    return _has_dots(answer) or (
        does_nothing and set(code.co_consts) <= {None, answer.__doc__}
    )


def is_written_alike(one: Function, other: Function) -> bool:
    """Whether two functions are the same but for comments, blanks and their names."""
    mine, others = one.__code__, other.__code__
    parts = ("co_code", "co_consts", "co_names", "co_varnames")
    return all(getattr(mine, part) == getattr(others, part) for part in parts)


def _has_dots(answer: Function) -> bool:
    """Whether three dots stand for something that is yet to be written; in an index, as q[..., a], they are NumPy's."""
    if ... not in answer.__code__.co_consts:
        return False
    try:
        tree = ast.parse(textwrap.dedent(inspect.getsource(answer)))
    except (OSError, SyntaxError, ValueError):
        return True
    nodes = list(ast.walk(tree))
    in_index = {
        id(part)
        for node in nodes
        if isinstance(node, ast.Subscript)
        for part in ast.walk(node.slice)
    }
    return any(
        isinstance(node, ast.Constant)
        and node.value is ...
        and id(node) not in in_index
        for node in nodes
    )


def is_courses_own(answer: Function, right: Function) -> bool:
    """Whether an answer is the course's own function, or calls it, as far as can be read off."""
    names, called = (
        getattr(answer, "__globals__", {}),
        getattr(getattr(answer, "__code__", None), "co_names", ()),
    )
    things = [answer, *(names.get(name) for name in called)]
    things += [
        getattr(thing, right.__name__, None)
        for thing in things
        if isinstance(thing, ModuleType)
    ]
    imports = right.__name__ in called and right.__module__ in called
    told = right.__module__, right.__name__
    return imports or any(
        (getattr(t, "__module__", ""), getattr(t, "__name__", "")) == told
        for t in things
    )


def names_of(answer: Function) -> tuple[str, ...]:
    """Names of the arguments and variables of a function."""
    code = getattr(answer, "__code__", None)
    return () if code is None else code.co_varnames


def unused_arguments(answer: Function, right: Function) -> list[str]:
    """The arguments that `answer` never reads although `right` reads the ones in their places; by its own names."""
    mine, theirs = (_arguments_read(function) for function in (answer, right))
    return [
        name
        for (name, read), (_, wanted) in zip(mine, theirs, strict=False)
        if wanted and not read
    ]


def names_from_outside(answer: Function, right: Function) -> list[str]:
    """The arguments of `right` that `answer` takes from the notebook, where it should take what it is given."""
    code = getattr(answer, "__code__", None)
    if code is None:
        return []
    loaded = {
        i.argval
        for i in dis.get_instructions(code)
        if i.opname in ("LOAD_GLOBAL", "LOAD_NAME")
    }
    return [
        name
        for name in parameters(right)
        if name in loaded and not callable(answer.__globals__.get(name))
    ]


def arguments_read(function: Function) -> set[int]:
    """The places of the arguments that a function reads anywhere."""
    return {i for i, (_, read) in enumerate(_arguments_read(function)) if read}


def read_as_given(function: Function) -> set[int]:
    """The places of those that it reads and gives no other value."""
    stored = set()
    for step in dis.get_instructions(function.__code__):
        if step.opname == "STORE_FAST_LOAD_FAST":
            stored.add(step.argval[0])
        elif "STORE" in step.opname:
            stored |= set(_parts(step.argval))
    return {
        i
        for i, (name, read) in enumerate(_arguments_read(function))
        if read and name not in stored
    }


def uses_chance(answer: Function) -> bool:
    """Whether a function names something that draws random numbers, and that it is not given as an argument."""
    code = getattr(answer, "__code__", None)
    if code is None:
        return False
    owner: Any = None
    for step in dis.get_instructions(code):
        is_given = owner in code.co_varnames[: code.co_argcount]
        is_name = "LOAD" in step.opname or "IMPORT" in step.opname
        if "FAST" in step.opname:
            owner = _parts(step.argval)[-1]
            continue
        if is_name and not is_given and step.argval in CHANCE:
            return True
        owner = None
    return False


def _arguments_read(function: Function) -> list[tuple[str, bool]]:
    code = getattr(function, "__code__", None)
    if code is None:
        return []
    read = {
        part
        for i in dis.get_instructions(code)
        if "LOAD" in i.opname
        for part in _parts(i.argval)
    }
    names = code.co_varnames[: code.co_argcount]
    return [(name, name in read or name in code.co_cellvars) for name in names]


def _parts(argval: Any) -> tuple[Any, ...]:
    # Python 3.13 loads two names at once
    return argval if isinstance(argval, tuple) else (argval,)
