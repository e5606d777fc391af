"""The text of a function, as a tree: only if that text is proved to be what runs."""

import ast
import linecache
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from types import CodeType, FunctionType

Definition = ast.FunctionDef | ast.Lambda


class NotPlainError(ValueError):
    """A function is not plain: one sentence with file, line, what is not plain and, where it is short, what to do."""


def place(function: FunctionType, node: ast.AST | None = None) -> str:
    """The file and the line of a function, or of one of its nodes, for a message."""
    code = function.__code__
    line = getattr(node, "lineno", code.co_firstlineno)
    return f"{Path(code.co_filename).name}:{line}"


def definition_of(function: FunctionType) -> Definition:
    """The tree of a function's definition; its lines are numbered as in the file.

    The whole file is compiled, and one of the pieces has to be equal to the code that the function runs.

    Raises
    ------
    NotPlainError
        If the file is not there, has changed since, or has two functions like this on one line.
    """
    found = _definitions(function.__code__)
    if not found:
        raise NotPlainError(
            f"{place(function)}: {function.__name__} is not plain: its text is not there, or has changed"
        )
    if len(found) > 1:
        raise NotPlainError(
            f"{place(function)}: two functions on one line are not plain; write them on two lines"
        )
    return found[0]


def _definitions(code: CodeType) -> list[Definition]:
    """The definitions, in the file of this code, that it may come from; none if the file is another one now."""
    linecache.checkcache(code.co_filename)
    return _definitions_in("".join(linecache.getlines(code.co_filename)), code)


@lru_cache(maxsize=256)
def _definitions_in(text: str, code: CodeType) -> list[Definition]:
    try:
        tree = ast.parse(text)
        # dont_inherit: with the file's own `from __future__` only
        whole = compile(text, code.co_filename, "exec", dont_inherit=True)
    except (SyntaxError, ValueError):
        return []
    if code not in _pieces(whole):
        return []
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, Definition) and _begins_as(node, code)
    ]


def _pieces(code: CodeType) -> Iterator[CodeType]:
    """A code object and all that are inside it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _pieces(constant)


def _begins_as(node: Definition, code: CodeType) -> bool:
    """Whether a definition has the name and the first line of this code."""
    if isinstance(node, ast.Lambda):
        return code.co_name == "<lambda>" and node.lineno == code.co_firstlineno
    decorators = [decorator.lineno for decorator in node.decorator_list]
    first = min([node.lineno, *decorators])
    return node.name == code.co_name and first == code.co_firstlineno
