"""More that may be different in one place: a part dropped, something put around it, two things in each other's place.

Of these some make no difference in a right function, so no tape need tell them from it.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

from rlrobot_grading.hints.one_change import Change, become, quoted

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
FIXED = (
    0,
    1,
    0.1,
    0.9,
    0.2,
    0.5,
    0.95,
    0.99,
)  # what a learner may have put in an argument's place
REDUCED = ("max", "min", "mean", "sum", "argmax")


def further_changes(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """What can be done to a node, beyond `simple_changes`."""
    if isinstance(node, ast.BinOp):
        for part, rest in (("left", "right"), ("right", "left")):
            yield (
                _left_out(getattr(node, part), node),
                lambda n, r=rest: become(n, ast.unparse(getattr(n, r))),
            )
        if isinstance(node.op, ast.Sub | ast.Div | ast.Pow | ast.MatMult):
            yield f"the two sides of {quoted(node)} had changed places", _change_sides
        yield from _brackets(node)
        for name in names if isinstance(node.op, ast.Mult) else ():
            said = f"{quoted(node)} were multiplied by “{name}”, too"
            yield said, lambda n, name=name: become(n, f"({ast.unparse(n)}) * {name}")
    elif isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Slice):
        yield (
            f"{quoted(node)} were the whole of {quoted(node.value)}",
            lambda n: become(n, ast.unparse(n.value)),
        )
    elif isinstance(node, ast.Subscript):
        yield from _other_entries(node)
    elif isinstance(node, ast.Call):
        for k, word in enumerate(node.keywords):
            yield _left_out(word, node), lambda n, k=k: n.keywords.pop(k)
        if (
            len(node.args) <= 1 + (ast.unparse(node.func) in ("max", "min"))
            and not node.keywords
        ):
            for k, part in enumerate(node.args):
                yield (
                    f"{quoted(node)} were {quoted(part)}",
                    lambda n, k=k: become(n, ast.unparse(n.args[k])),
                )
        for k, m in combinations(range(len(node.args)), 2):
            said = f"{quoted(node.args[k])} and {quoted(node.args[m])} had changed places in {quoted(node)}"
            yield said, lambda n, k=k, m=m: _exchange(n.args, k, m)
        if isinstance(node.func, ast.Attribute):
            for other in () if node.args else REDUCED:
                yield (
                    f"“{other}” stood in place of “{node.func.attr}”",
                    lambda n, o=other: setattr(n.func, "attr", o),
                )
        if ast.unparse(node.func) in ("max", "min", "np.max") and len(node.args) == 1:
            for other in ("np.mean", "sum", "np.argmax"):
                said = f"“{other.removeprefix('np.')}” stood in place of {quoted(node.func)}"
                yield (
                    said,
                    lambda n, o=other: become(n, f"{o}({ast.unparse(n.args[0])})"),
                )
            for other, said in (("[0]", "first"), ("[-1]", "last")):
                said = f"{quoted(node)} were the {said} entry of {quoted(node.args[0])}"
                yield said, lambda n, o=other: become(n, ast.unparse(n.args[0]) + o)
        if ast.unparse(node.func) == "range":
            yield (
                f"the loop over {quoted(node)} had one turn more",
                lambda n: _longer(n, 1),
            )
            yield (
                f"the loop over {quoted(node)} left its last turn out",
                lambda n: _longer(n, -1),
            )
    elif isinstance(node, ast.If | ast.IfExp):
        said = f"{quoted(node.test)} were the other way round"
        yield said, lambda n: setattr(n, "test", ast.UnaryOp(ast.Not(), n.test))
    elif isinstance(node, ast.AugAssign):
        said = (
            f"{quoted(node.target)} were set to {quoted(node.value)}, not changed by it"
        )
        yield (
            said,
            lambda n: become(n, f"{ast.unparse(n.target)} = {ast.unparse(n.value)}"),
        )
    elif isinstance(node, ast.Assign) and isinstance(node.value, ast.Call):
        yield (
            f"the result of {quoted(node.value)} were not kept",
            lambda n: become(n, ast.unparse(n.value)),
        )
    elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        yield (
            f"{quoted(node)} were done twice",
            lambda n: become(n, f"{ast.unparse(n)}, {ast.unparse(n)}"),
        )
    elif isinstance(node, ast.For):
        yield (
            "the loop ended after its first turn",
            lambda n: n.body.append(ast.Break()),
        )


def put_around(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Something around a number: its sign lost, its square, its half; the last to be thought of."""
    if isinstance(
        node, ast.BinOp | ast.Call | ast.Subscript | ast.IfExp
    ) and not _is_written(node):
        for form, said in PUT_AROUND.items():
            yield (
                said.format(quoted(node)),
                lambda n, f=form: become(n, f.format(ast.unparse(n))),
            )
    elif isinstance(node, ast.Name) and node.id in names and not _is_written(node):
        for form, said in PUT_AROUND_NAMES.items():
            yield (
                said.format(*2 * [quoted(node)]),
                lambda n, f=form: become(n, f.format(n.id)),
            )


def handed_over(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Another variable of the function that a call is given in place of one."""
    for k, argument in enumerate(node.args if isinstance(node, ast.Call) else ()):
        if isinstance(argument, ast.Name):
            for other in (name for name in names if name != argument.id):
                said = (
                    f"{quoted(node)} were given “{other}” in place of “{argument.id}”"
                )
                yield said, lambda n, k=k, o=other: become(n.args[k], o)


def changes_everywhere(tree: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Two arguments that have changed places in the whole, or a number in place of one."""
    if not isinstance(tree, ast.Module):
        return
    for name in names:
        for value in FIXED:
            yield (
                f"“{name}” were always {value}",
                lambda t, n=name, v=value: _rename(t, {n: repr(v)}),
            )
    for one, other in combinations(names, 2):
        said = f"“{one}” and “{other}” had changed places"
        yield said, lambda t, a=one, b=other: _rename(t, {a: b, b: a})


def _left_out(part: ast.AST, whole: ast.AST) -> str:
    return f"{quoted(part)} were left out of {quoted(whole)}"


def _is_written(node: ast.AST) -> bool:
    return not isinstance(getattr(node, "ctx", ast.Load()), ast.Load)


def _change_sides(node: Any) -> None:
    node.left, node.right = node.right, node.left


def _exchange(items: list[Any], k: int, m: int) -> None:
    items[k], items[m] = items[m], items[k]


def _brackets(node: ast.BinOp) -> Iterator[Change]:
    """Brackets that stand elsewhere: of a * (b + c) it makes a * b + c."""
    for side in ("left", "right"):
        inner = getattr(node, side)
        if isinstance(inner, ast.BinOp) and isinstance(
            node.op, ast.Mult | ast.Div | ast.Pow
        ):
            yield (
                f"the brackets around {quoted(inner)} were missing",
                lambda n: become(n, _without_brackets(n)),
            )
        if isinstance(inner, ast.BinOp) and isinstance(inner.op, ast.Mult | ast.Div):
            yield (
                f"brackets joined more than {quoted(inner)}",
                lambda n, s=side: _regroup(n, s),
            )
            said = f"{quoted(inner.left)} multiplied the whole of {quoted(node)}"
            yield said, lambda n, s=side: _regroup(n, s, is_commuted=True)


def _without_brackets(node: ast.BinOp) -> str:
    signs = {ast.Mult: "*", ast.Div: "/", ast.Pow: "**"}
    return f"{ast.unparse(node.left)} {signs[type(node.op)]} {ast.unparse(node.right)}"


def _regroup(node: Any, side: str, is_commuted: bool = False) -> None:
    """Of a * b + c it makes a * (b + c), of a + b * c it makes (a + b) * c, commuted: (a + c) * b."""
    inner = getattr(node, side)
    if is_commuted and isinstance(inner.op, ast.Mult):
        inner.left, inner.right = inner.right, inner.left
    if side == "left":
        joined = ast.BinOp(inner.right, node.op, node.right)
        node.left, node.op, node.right = inner.left, inner.op, joined
    else:
        joined = ast.BinOp(node.left, node.op, inner.left)
        node.left, node.op, node.right = joined, inner.op, inner.right


def _other_entries(node: ast.Subscript) -> Iterator[Change]:
    """Other entries of a table: the whole, a row, a column, with the indices in each other's place."""
    whole = ast.unparse(node.value)
    parts = (
        [ast.unparse(part) for part in node.slice.elts]
        if isinstance(node.slice, ast.Tuple)
        else []
    )
    others = [f"{whole}[:]" if _is_written(node) else whole]
    if len(parts) == 2:
        others = [
            f"{whole}[{parts[0]}]",
            f"{whole}[:, {parts[1]}]",
            f"{whole}[{parts[1]}, {parts[0]}]",
            *others,
        ]
    elif not parts:
        others.append(f"{whole}[:, {ast.unparse(node.slice)}]")
    for other in others:
        yield (
            f"“{other}” stood in place of {quoted(node)}",
            lambda n, o=other: become(n, o),
        )


def _longer(node: Any, n: int) -> None:
    last = min(len(node.args) - 1, 1)
    node.args[last] = ast.parse(
        f"{ast.unparse(node.args[last])} + {n}", mode="eval"
    ).body


def _rename(tree: ast.AST, others: dict[str, str]) -> None:
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and node.id in others and not _is_written(node):
            become(node, others[node.id])
