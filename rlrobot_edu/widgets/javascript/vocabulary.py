"""Python's names, operators and values in JavaScript."""

import ast
import json
import math

import numpy as np

# the arrays of two dimensions, by the names that kernels give them
TABLES = {"q", "e", "visits"}
# the methods of an array that are functions of the prelude in JavaScript
OF_AN_ARRAY = {"max", "min", "argmax"}
# all else that only arrays have; a record has fields of other names
NOT_TRANSLATED = set(dir(np.ndarray)) - OF_AN_ARRAY - {"shape"}
OPERATORS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.Pow: "**",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "===",
    ast.NotEq: "!==",
    ast.Is: "===",
    ast.IsNot: "!==",
    ast.And: "&&",
    ast.Or: "||",
    ast.Not: "!",
    ast.USub: "-",
}
WORDS = {
    "int": "Math.trunc",
    "abs": "Math.abs",
    "max": "Math.max",
    "min": "Math.min",
    "float": "Number",
}
SAME_NAMES = ("ceil", "cos", "exp", "floor", "log", "sin", "sqrt")
OF_MATH = {name: f"Math.{name}" for name in SAME_NAMES}
OF_MATH |= {"inf": "Infinity", "pi": "Math.PI"}


def literal(value: bool | float | str | None) -> str:
    """A number, a text, True, False or None in JavaScript."""
    if isinstance(value, float) and math.isinf(value):
        return "Infinity" if value > 0 else "(-Infinity)"
    if isinstance(value, int | float) and not isinstance(value, bool):
        return repr(value)
    return json.dumps(value)
