"""Which names of a kernel are variables, arrays and records, and which expressions are whole arrays, by its text."""

import ast
from collections.abc import Iterable

from rlrobot_edu.widgets.javascript.vocabulary import OF_AN_ARRAY, TABLES


def is_row(node: ast.Subscript) -> bool:
    """Whether an entry of a table has a single index, and so is a row."""
    array = node.value
    is_table = getattr(array, "attr", getattr(array, "id", "")) in TABLES
    return is_table and not isinstance(node.slice, ast.Tuple)


def names_stored(nodes: Iterable[ast.AST]) -> set[str]:
    """The names to which something is assigned."""
    found = set()
    for node in nodes:
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
    return found


def names_of_records(nodes: Iterable[ast.AST]) -> set[str]:
    """The names that stand for records: what has fields of which no array has one."""
    found = set()
    for node in nodes:
        match node:
            case ast.Attribute(ast.Name(name), field):
                if field not in {"shape", *OF_AN_ARRAY}:
                    found.add(name)
    return found


def names_of_arrays(nodes: Iterable[ast.AST]) -> set[str]:
    """The texts that stand for arrays: what has entries, a shape or a largest entry, and names given to rows."""
    found = set()
    for node in nodes:
        match node:
            case ast.Subscript(array):
                found.add(ast.unparse(array))
            case ast.Attribute(array, field) if field in {"shape", *OF_AN_ARRAY}:
                found.add(ast.unparse(array))
            case ast.Assign([ast.Name(name)], ast.Subscript() as value):
                if is_row(value):
                    found.add(name)
    return found


def is_array(node: ast.expr, names: set[str]) -> bool:
    """Whether an expression is a whole array. names: see `names_of_arrays`."""
    if isinstance(node, ast.Subscript):
        return is_row(node)
    return ast.unparse(node) in names


def is_negative(index: ast.expr) -> bool:
    """Whether an index counts from the end, which JavaScript cannot do."""
    return isinstance(index, ast.UnaryOp) and isinstance(index.op, ast.USub)
