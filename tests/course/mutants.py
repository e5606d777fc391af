"""Wrong answers by machine: a right function with one thing in it that is different."""

from __future__ import annotations

import ast
import builtins
import copy
import inspect
import linecache
import textwrap
from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

COMPARED = {
    ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE), ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,), ast.NotEq: (ast.Eq,), ast.In: (ast.NotIn,), ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,), ast.IsNot: (ast.Is,),
}  # fmt: skip
RECKONED = {
    ast.Add: (ast.Sub,), ast.Sub: (ast.Add,), ast.Mult: (ast.Div, ast.Add), ast.Div: (ast.Mult, ast.FloorDiv),
    ast.FloorDiv: (ast.Div,), ast.Mod: (ast.FloorDiv,), ast.Pow: (ast.Mult,), ast.MatMult: (ast.Mult,),
}  # fmt: skip
CALLED = {
    "max": ("min",), "min": ("max",), "argmax": ("argmin",), "argmin": ("argmax",), "mean": ("sum", "max"),
    "sum": ("mean",), "sin": ("cos",), "cos": ("sin",), "cumsum": ("cumprod",), "any": ("all",), "all": ("any",),
    "abs": ("int",), "copy": (), "zeros": ("ones",), "ones": ("zeros",), "floor": ("ceil",), "ceil": ("floor",),
}  # fmt: skip


def mutants(right: Callable[..., Any]) -> Iterator[tuple[str, Callable[..., Any]]]:
    """Each function that differs from `right` in one place, and in words what is different.

    A comparison, an operator, a number, an argument, a function that is called, two statements in another order, a
    statement or a branch that is missing.
    """
    source = textwrap.dedent(inspect.getsource(right))
    tree = ast.parse(source)
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    definition.decorator_list = []
    names = [argument.arg for argument in definition.args.args]
    nodes = list(ast.walk(tree))
    for i, node in enumerate(nodes):
        for said, change in _changes(node, names):
            mutated = copy.deepcopy(tree)
            change(list(ast.walk(mutated))[i])
            text = ast.unparse(ast.fix_missing_locations(mutated))
            if text != ast.unparse(tree):
                yield f"line {getattr(node, 'lineno', 1)}: {said}", _made(text, right)


def _made(text: str, right: Callable[..., Any]) -> Callable[..., Any]:
    file, made = f"<mutant {abs(hash(text))}>", {}
    linecache.cache[file] = len(text), None, text.splitlines(keepends=True), file
    exec(compile(text, file, "exec"), right.__globals__, made)
    return made[right.__name__]


def _become(node: ast.AST, expression: str) -> None:
    """Another expression in place of this one, whatever kind of node it is."""
    other = ast.parse(expression, mode="eval").body
    node.__class__ = type(other)
    vars(node).clear()
    vars(node).update(vars(other))


def _changes(node: ast.AST, names: list[str]) -> Iterator[tuple[str, Callable[[Any], None]]]:
    """What can be done to a node: in words, and as a function that does it to a copy of the node."""
    if isinstance(node, ast.Compare):
        for k, operator in enumerate(node.ops):
            for other in COMPARED.get(type(operator), ()):
                yield f"{ast.unparse(node)} with {other.__name__}", lambda n, k=k, o=other: n.ops.__setitem__(k, o())
            border = node.comparators[k]
            if isinstance(border, ast.Constant) and type(border.value) is int and border.value:
                for value in (border.value * 1.04, border.value * 0.96):
                    yield f"{value} for {border.value}", lambda n, k=k, v=value: setattr(n.comparators[k], "value", v)
    elif isinstance(node, ast.BinOp | ast.AugAssign):
        for other in RECKONED.get(type(node.op), ()):
            yield f"{ast.unparse(node)} with {other.__name__}", lambda n, o=other: setattr(n, "op", o())
    elif isinstance(node, ast.BoolOp):
        other = ast.Or if isinstance(node.op, ast.And) else ast.And
        yield f"{ast.unparse(node)} with {other.__name__}", lambda n: setattr(n, "op", other())
        for k in range(len(node.values)):
            yield f"{ast.unparse(node)} without its part {k + 1}", lambda n, k=k: n.values.pop(k)
    elif isinstance(node, ast.UnaryOp):
        yield f"{ast.unparse(node)} without {type(node.op).__name__}", lambda n: setattr(n, "op", ast.UAdd())
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
        more = (node.value * 1.04, node.value * 0.96) if type(node.value) is float and node.value else ()
        for value in (node.value + 1, node.value - 1, *more):
            yield f"{value} for {node.value}", lambda n, v=value: setattr(n, "value", v)
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        for other in (*(name for name in names if node.id in names), *CALLED.get(node.id, ())):
            if other != node.id:
                yield f"{other} for {node.id}", lambda n, o=other: setattr(n, "id", o)
    elif isinstance(node, ast.Attribute):
        for other in CALLED.get(node.attr, ()):
            yield f"{other} for {node.attr}", lambda n, o=other: setattr(n, "attr", o)
    elif isinstance(node, ast.Call) and len(node.args) == 1 and isinstance(node.args[0], ast.Name):
        for part in ("[1:]", "[:-1]", "[0]", "[-1]") if node.args[0].id in names else ():
            yield f"{ast.unparse(node)} of {part}", lambda n, p=part: setattr(n.args[0], "id", n.args[0].id + p)
            if ":" not in part:
                yield f"{node.args[0].id}{part} for {ast.unparse(node)}", lambda n, p=part: _become(n, n.args[0].id + p)
    elif isinstance(node, ast.IfExp):
        yield f"never {ast.unparse(node.test)}", lambda n: setattr(n, "test", ast.Constant(False))
        yield f"always {ast.unparse(node.test)}", lambda n: setattr(n, "test", ast.Constant(True))
    if isinstance(node, ast.If):
        yield f"never {ast.unparse(node.test)}", lambda n: setattr(n, "test", ast.Constant(False))
        yield f"always {ast.unparse(node.test)}", lambda n: setattr(n, "test", ast.Constant(True))
    for block in ("body", "orelse"):
        statements = getattr(node, block, None)
        statements = statements if isinstance(statements, list) else []
        for k, (one, other) in enumerate(pairwise(statements)):
            if _commute(one, other):
                continue
            said = f"{ast.unparse(other).splitlines()[0]} before {ast.unparse(one).splitlines()[0]}"
            yield said, lambda n, b=block, k=k: getattr(n, b).insert(k, getattr(n, b).pop(k + 1))
        for k, one in enumerate(statements):
            if isinstance(one, ast.Assign | ast.AugAssign | ast.Expr | ast.Return | ast.Break | ast.Continue):
                if isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant):
                    continue  # a docstring
                yield (f"no {ast.unparse(one)}", lambda n, b=block, k=k: getattr(n, b).__setitem__(k, ast.Pass()))


def _commute(one: ast.stmt, other: ast.stmt) -> bool:
    """Whether two statements do the same in any order: none leaves the function, or changes what the other names."""
    for a, b in ((one, other), (other, one)):
        if isinstance(a, ast.FunctionDef):  # what it names is looked up when it is called
            return a.name not in _names(b)
    if any(isinstance(node, ast.Return | ast.Break | ast.Continue) for s in (one, other) for node in ast.walk(s)):
        return False
    return _writes(one).isdisjoint(_names(other)) and _writes(other).isdisjoint(_names(one))


def _names(statement: ast.stmt) -> set[str]:
    """The names in a statement, without those that live in a comprehension alone."""
    inner = {
        name.id for node in ast.walk(statement) if isinstance(node, ast.comprehension) for name in _in(node.target)
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
    return isinstance(called, ast.Attribute) and ast.unparse(called.value) in ("math", "np")
