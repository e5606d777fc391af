"""The library's code as a lesson prints it."""

import ast
import inspect
import textwrap
from collections.abc import Callable
from typing import Any


def library_code(function: Callable[..., Any]) -> str:
    """The source of a function without its docstring, as it was written, before it was compiled."""
    source = textwrap.dedent(inspect.getsource(getattr(function, "py_func", function)))
    (definition,), lines = ast.parse(source).body, source.splitlines()
    if isinstance(definition, ast.FunctionDef) and ast.get_docstring(definition) is not None:
        docstring = definition.body[0]
        del lines[docstring.lineno - 1 : docstring.end_lineno]
    return "\n".join(lines)
