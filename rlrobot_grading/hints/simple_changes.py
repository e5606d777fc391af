"""What a learner is likely to write in one place of a right function; the tapes must tell each from it."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

from rlrobot_grading.hints.changed import Change, expression, quoted, with_parts

COMPARED = {
    ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE), ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,), ast.NotEq: (ast.Eq,), ast.In: (ast.NotIn,), ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,), ast.IsNot: (ast.Is,),
}  # fmt: skip
RECKONED = {
    ast.Add: {ast.Sub: "{right} were taken off {left}, not added"},
    ast.Sub: {ast.Add: "{right} were added to {left}, not taken off"},
    ast.Mult: {ast.Div: "{left} were divided by {right}, not multiplied",
               ast.Add: "{left} and {right} were added, not multiplied"},
    ast.Div: {ast.Mult: "{left} were multiplied by {right}, not divided",
              ast.FloorDiv: "{left} / {right} were rounded down, as by //"},
    ast.FloorDiv: {ast.Div: "{left} // {right} were not rounded down"},
    ast.Mod: {ast.FloorDiv: "// stood in place of % between {left} and {right}"},
    ast.Pow: {ast.Mult: "{left} were multiplied by {right}, not taken to its power"},
    ast.MatMult: {ast.Mult: "* stood in place of @ between {left} and {right}"},
}  # fmt: skip
CALLED = {
    "max": ("min",), "min": ("max",), "argmax": ("argmin",), "argmin": ("argmax",), "mean": ("sum", "max"),
    "sum": ("mean",), "sin": ("cos",), "cos": ("sin",), "cumsum": ("cumprod",), "any": ("all",), "all": ("any",),
    "abs": ("int",), "copy": (), "zeros": ("ones",), "ones": ("zeros",), "floor": ("ceil",), "ceil": ("floor",),
}  # fmt: skip
PARTS = {
    "[1:]": "an entry at one end of {} were left out", "[:-1]": "an entry at one end of {} were left out",
    "[0]": "{} were its first entry alone", "[-1]": "{} were its last entry alone",
}  # fmt: skip


LEFT_OUT = (
    ast.Assign,
    ast.AugAssign,
    ast.Expr,
    ast.Return,
    ast.Break,
    ast.Continue,
)


def simple_changes(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Another comparison, operator, number, argument, call; two statements in another order, or one left out.

    The tapes of the course tell each from the right function: tests/course/test_mutants.py.
    """
    if isinstance(node, ast.Compare):
        yield from _other_comparisons(node)
    elif isinstance(node, ast.BinOp):
        yield from _other_operators(node, node.left, node.right)
    elif isinstance(node, ast.AugAssign):
        yield from _other_operators(node, node.target, node.value)
    elif isinstance(node, ast.BoolOp):
        yield from _other_conditions(node)
    elif isinstance(node, ast.UnaryOp):
        word = "not" if isinstance(node.op, ast.Not) else "minus"
        said = f"the {word} before {quoted(node.operand)} were left out"
        yield said, with_parts(node, op=ast.UAdd())
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
        values = [node.value + 1, node.value - 1]
        if type(node.value) is float and node.value:
            values += [node.value * 1.04, node.value * 0.96]
        for value in values:
            yield f"{value} stood in place of {node.value}", repr(value)
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        others = [*names] if node.id in names else []
        for other in [*others, *CALLED.get(node.id, ())]:
            if other != node.id:
                yield f"“{other}” stood in place of “{node.id}”", other
    elif isinstance(node, ast.Attribute):
        for other in CALLED.get(node.attr, ()):
            said = f"“{other}” stood in place of “{node.attr}”"
            yield said, with_parts(node, attr=other)
    elif isinstance(node, ast.Call) and len(node.args) == 1:
        yield from _parts_of_its_argument(node, names)
    if isinstance(node, ast.If | ast.IfExp):
        never = with_parts(node, test=ast.Constant(False))
        yield f"{quoted(node.test)} never held", never
        always = with_parts(node, test=ast.Constant(True))
        yield f"{quoted(node.test)} always held", always
    for block in ("body", "orelse"):
        statements = getattr(node, block, None)
        if isinstance(statements, list):
            yield from _other_statements(node, block, statements)


def _other_comparisons(node: ast.Compare) -> Iterator[Change]:
    for k, operator in enumerate(node.ops):
        for other in COMPARED.get(type(operator), ()):
            ops = [*node.ops[:k], other(), *node.ops[k + 1 :]]
            new = with_parts(node, ops=ops)
            yield f"“{new}” were asked, not {quoted(node)}", new
        border = node.comparators[k]
        if not isinstance(border, ast.Constant) or type(border.value) is not int:
            continue
        for times in (1.04, 0.96) if border.value else ():
            value = border.value * times
            said = f"{value} stood in place of {border.value} in {quoted(node)}"
            comparators = [*node.comparators]
            comparators[k] = ast.Constant(value)
            yield said, with_parts(node, comparators=comparators)


def _other_operators(
    node: ast.BinOp | ast.AugAssign, left: ast.expr, right: ast.expr
) -> Iterator[Change]:
    for other, said in RECKONED.get(type(node.op), {}).items():
        words = said.format(left=quoted(left), right=quoted(right))
        yield words, with_parts(node, op=other())


def _other_conditions(node: ast.BoolOp) -> Iterator[Change]:
    word, other = ("and", ast.And())
    if isinstance(node.op, ast.And):
        word, other = ("or", ast.Or())
    said = f"“{word}” joined the parts of {quoted(node)}"
    yield said, with_parts(node, op=other)
    for k, part in enumerate(node.values):
        rest = [*node.values[:k], *node.values[k + 1 :]]
        said = f"{quoted(part)} were left out of {quoted(node)}"
        yield said, with_parts(node, values=rest)


def _parts_of_its_argument(node: ast.Call, names: Sequence[str]) -> Iterator[Change]:
    argument = node.args[0]
    if not isinstance(argument, ast.Name):
        return
    if ast.unparse(node.func) == "len":
        yield f"{quoted(node)} were one less", f"{ast.unparse(node)} - 1"
        return
    for part, said in PARTS.items() if argument.id in names else ():
        words = said.format(quoted(argument))
        entry = argument.id + part
        yield words, with_parts(node, args=[expression(entry)])
        if ":" not in part:
            yield f"{words}, and {quoted(node)}, too", entry


def _other_statements(
    node: ast.AST, block: str, statements: list[ast.stmt]
) -> Iterator[Change]:
    for k, (one, other) in enumerate(pairwise(statements)):
        if not _commute(one, other):
            order = [*statements[:k], other, one, *statements[k + 2 :]]
            said = f"{quoted(other)} came before {quoted(one)}"
            yield said, with_parts(node, **{block: order})
    for k, one in enumerate(statements):
        is_docstring = isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant)
        if isinstance(one, LEFT_OUT) and not is_docstring:
            rest = [*statements[:k], ast.Pass(), *statements[k + 1 :]]
            yield f"{quoted(one)} were missing", with_parts(node, **{block: rest})


def _commute(one: ast.stmt, other: ast.stmt) -> bool:
    """Whether two statements do the same in any order: none leaves the function, or changes what the other names."""
    for a, b in ((one, other), (other, one)):
        # what it names is looked up when it is called
        if isinstance(a, ast.FunctionDef):
            return a.name not in _names(b)
    if any(
        isinstance(node, ast.Return | ast.Break | ast.Continue)
        for s in (one, other)
        for node in ast.walk(s)
    ):
        return False
    return _writes(one).isdisjoint(_names(other)) and _writes(other).isdisjoint(
        _names(one)
    )


def _names(statement: ast.stmt) -> set[str]:
    """The names in a statement, without those that live in a comprehension alone."""
    inner = {
        name.id
        for node in ast.walk(statement)
        if isinstance(node, ast.comprehension)
        for name in _in(node.target)
    }
    return {name.id for name in _in(statement)} - inner


def _in(node: ast.AST) -> list[ast.Name]:
    return [part for part in ast.walk(node) if isinstance(part, ast.Name)]


def _writes(statement: ast.stmt) -> set[str]:
    """The names that a statement may change: what it stores, and what it hands to a call or calls a method of."""
    changed = set()
    for node in ast.walk(statement):
        if isinstance(getattr(node, "ctx", None), ast.Store):
            changed |= {name.id for target in _targets(node) for name in _in(target)}
        elif isinstance(node, ast.Call) and not _is_pure(node.func):
            changed |= {name.id for name in _in(node)}
    return changed & _names(statement)


def _targets(node: Any) -> list[ast.AST]:
    """Of e[s, a] = … it is e that changes."""
    if isinstance(node, ast.Tuple | ast.List):
        return []  # its parts come by themselves
    return [node] if isinstance(node, ast.Name) else [node.value]


def _is_pure(called: ast.expr) -> bool:
    """Whether a call changes nothing: Python's own functions, and those of math and NumPy."""
    if isinstance(called, ast.Name):
        return hasattr(builtins, called.id)
    return isinstance(called, ast.Attribute) and ast.unparse(called.value) in (
        "math",
        "np",
    )
