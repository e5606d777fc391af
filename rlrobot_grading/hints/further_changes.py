"""More that may be different in one place: a part dropped, something put around it, two things in each other's place.

Of these some make no difference in a right function, so no tape need tell them from it.
"""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from rlrobot_grading.hints.changed import (
    Change,
    become,
    expression,
    quoted,
    with_parts,
)

PUT_AROUND = {
    "0 * ({})": "{} were 0",
    "abs({})": "{} had lost its sign",
    "-({})": "{} had the other sign",
    "({}) ** 2": "{} were squared",
    "max(0, {})": "{} could not fall below 0",
    "2 * ({})": "{} were counted twice",
    "({}) / 2": "{} were halved",
    "int({})": "{} were cut to a whole number",
    "round({})": "{} were rounded to a whole number",
    "round({}, 2)": "{} were rounded to two digits",
    "({}) ** 0.5": "the root of {} were taken",
}
PUT_AROUND_NAMES = {
    "1 - ({})": "1 − {} stood in place of {}",
    "1 / ({})": "1 / {} stood in place of {}",
    "({}) ** 2": "{} were squared",
}
# what a learner may have put in an argument's place
FIXED = (0, 1, 0.1, 0.9, 0.2, 0.5, 0.95, 0.99)
REDUCED = ("max", "min", "mean", "sum", "argmax")


def further_changes(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """What can be done to a node, beyond `simple_changes`."""
    if isinstance(node, ast.BinOp):
        yield from _other_sides(node)
        yield from _brackets(node)
        for name in names if isinstance(node.op, ast.Mult) else ():
            said = f"{quoted(node)} were multiplied by “{name}”, too"
            yield said, f"({ast.unparse(node)}) * {name}"
    elif isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Slice):
        whole = ast.unparse(node.value)
        yield f"{quoted(node)} were the whole of “{whole}”", whole
    elif isinstance(node, ast.Subscript):
        yield from _other_entries(node)
    elif isinstance(node, ast.Call):
        yield from _other_calls(node)
    elif isinstance(node, ast.If | ast.IfExp):
        said = f"{quoted(node.test)} were the other way round"
        yield said, with_parts(node, test=ast.UnaryOp(ast.Not(), node.test))
    elif isinstance(node, ast.AugAssign):
        target, value = ast.unparse(node.target), ast.unparse(node.value)
        said = f"“{target}” were set to “{value}”, not changed by it"
        yield said, f"{target} = {value}"
    elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Call):
        call = ast.unparse(node.value)
        yield f"the result of “{call}” were not kept", call
    elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        call = ast.unparse(node)
        yield f"“{call}” were done twice", f"{call}, {call}"
    elif isinstance(node, ast.For):
        once = with_parts(node, body=[*node.body, ast.Break()])
        yield "the loop ended after its first turn", once


def put_around(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Something around a number: its sign lost, its square, its half; the last to be thought of."""
    if _is_written(node):
        return
    forms = {}
    if isinstance(node, ast.BinOp | ast.Call | ast.Subscript | ast.IfExp):
        forms = PUT_AROUND
    elif isinstance(node, ast.Name) and node.id in names:
        forms = PUT_AROUND_NAMES
    for form, said in forms.items():
        code = ast.unparse(node)
        yield said.replace("{}", f"“{code}”"), form.format(code)


def handed_over(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Another variable of the function that a call is given in place of one."""
    if not isinstance(node, ast.Call):
        return
    for k, argument in enumerate(node.args):
        if not isinstance(argument, ast.Name):
            continue
        for other in names:
            if other != argument.id:
                said = (
                    f"{quoted(node)} were given “{other}” in place of “{argument.id}”"
                )
                yield said, _with_argument(node, k, other)


def changes_everywhere(tree: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Two arguments that have changed places in the whole, or a number in place of one."""
    if not isinstance(tree, ast.Module):
        return
    for name in names:
        for value in FIXED:
            yield f"“{name}” were always {value}", renamed(tree, {name: repr(value)})
    for one, other in combinations(names, 2):
        said = f"“{one}” and “{other}” had changed places"
        yield said, renamed(tree, {one: other, other: one})


def _is_written(node: ast.AST) -> bool:
    return not isinstance(getattr(node, "ctx", ast.Load()), ast.Load)


def _other_sides(node: ast.BinOp) -> Iterator[Change]:
    left, right = quoted(node.left), quoted(node.right)
    yield f"{left} were left out of {quoted(node)}", ast.unparse(node.right)
    yield f"{right} were left out of {quoted(node)}", ast.unparse(node.left)
    if isinstance(node.op, ast.Sub | ast.Div | ast.Pow | ast.MatMult):
        said = f"the two sides of {quoted(node)} had changed places"
        yield said, with_parts(node, left=node.right, right=node.left)


def _brackets(node: ast.BinOp) -> Iterator[Change]:
    """Brackets that stand elsewhere: of a * (b + c) it makes a * b + c."""
    signs = {ast.Mult: "*", ast.Div: "/", ast.Pow: "**"}
    sign = signs.get(type(node.op), "")
    for side, inner in (("left", node.left), ("right", node.right)):
        if not isinstance(inner, ast.BinOp):
            continue
        if sign:
            said = f"the brackets around {quoted(inner)} were missing"
            yield said, f"{ast.unparse(node.left)} {sign} {ast.unparse(node.right)}"
        if isinstance(inner.op, ast.Mult | ast.Div):
            said = f"brackets joined more than {quoted(inner)}"
            yield said, _regrouped(node, side, inner.left, inner.op, inner.right)
            first, second = inner.left, inner.right
            if isinstance(inner.op, ast.Mult):
                first, second = second, first
            said = f"{quoted(inner.left)} multiplied the whole of {quoted(node)}"
            yield said, _regrouped(node, side, first, inner.op, second)


def _regrouped(
    node: ast.BinOp, side: str, first: ast.expr, op: ast.operator, second: ast.expr
) -> str:
    """Of a * b + c, a product on the left side, it makes a * (b + c); of a + b * c it makes (a + b) * c."""
    if side == "left":
        joined = ast.BinOp(second, node.op, node.right)
        return ast.unparse(ast.BinOp(first, op, joined))
    joined = ast.BinOp(node.left, node.op, first)
    return ast.unparse(ast.BinOp(joined, op, second))


def _other_entries(node: ast.Subscript) -> Iterator[Change]:
    """Other entries of a table: the whole, a row, a column, with the indices in each other's place."""
    whole = ast.unparse(node.value)
    others = [f"{whole}[:]" if _is_written(node) else whole]
    if not isinstance(node.slice, ast.Tuple):
        others.append(f"{whole}[:, {ast.unparse(node.slice)}]")
    elif len(node.slice.elts) == 2:
        row, column = map(ast.unparse, node.slice.elts)
        entries = f"[{row}]", f"[:, {column}]", f"[{column}, {row}]"
        others = [*(whole + entry for entry in entries), *others]
    for other in others:
        yield f"“{other}” stood in place of {quoted(node)}", other


def _other_calls(node: ast.Call) -> Iterator[Change]:
    """A call without one of its arguments, with two that have changed places, or of another function."""
    called, args = ast.unparse(node.func), [ast.unparse(part) for part in node.args]
    for k, word in enumerate(node.keywords):
        rest = [*node.keywords[:k], *node.keywords[k + 1 :]]
        said = f"{quoted(word)} were left out of {quoted(node)}"
        yield said, with_parts(node, keywords=rest)
    most = 2 if called in ("max", "min") else 1
    for part in args if len(args) <= most and not node.keywords else ():
        yield f"{quoted(node)} were “{part}”", part
    for k, m in combinations(range(len(args)), 2):
        order = [*node.args]
        order[k], order[m] = node.args[m], node.args[k]
        said = f"“{args[k]}” and “{args[m]}” had changed places in {quoted(node)}"
        yield said, with_parts(node, args=order)
    if isinstance(node.func, ast.Attribute) and not args:
        for other in REDUCED:
            said = f"“{other}” stood in place of “{node.func.attr}”"
            method = f"{ast.unparse(node.func.value)}.{other}"
            yield said, with_parts(node, func=expression(method))
    if called in ("max", "min", "np.max") and len(args) == 1:
        for other in ("np.mean", "sum", "np.argmax"):
            said = f"“{other.removeprefix('np.')}” stood in place of “{called}”"
            yield said, f"{other}({args[0]})"
        for entry, which in (("[0]", "first"), ("[-1]", "last")):
            said = f"{quoted(node)} were the {which} entry of “{args[0]}”"
            yield said, args[0] + entry
    if called == "range":
        end = min(len(args) - 1, 1)
        longer = _with_argument(node, end, f"{args[end]} + 1")
        yield f"the loop over {quoted(node)} had one turn more", longer
        shorter = _with_argument(node, end, f"{args[end]} + -1")
        yield f"the loop over {quoted(node)} left its last turn out", shorter


def _with_argument(node: ast.Call, k: int, code: str) -> str:
    """A call with another argument in one place."""
    args = [*node.args]
    args[k] = expression(code)
    return with_parts(node, args=args)


def renamed(tree: ast.AST, others: Mapping[str, str]) -> str:
    """The code of a tree with something else in place of some names, wherever they are read."""
    other = copy.deepcopy(tree)
    for node in ast.walk(other):
        if isinstance(node, ast.Name) and node.id in others and not _is_written(node):
            become(node, others[node.id])
    return ast.unparse(other)
