"""A right function, or a formula, with one thing in it that is different, and in words what that is.

The words go on after “it answers as if”. Pieces of code in them stand in “ and ”.
"""

from __future__ import annotations

import ast
import builtins
import pickle
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

Change = tuple[
    str, Callable[[Any], None]
]  # in words, and as a function that does it to a copy of the node

SMALL = (
    ast.Name,
    ast.Constant,
    ast.Attribute,
    ast.Subscript,
)  # what is told with the code around it
LONGEST = 50  # characters of that code
SPENT = "_turns"  # of the loops in a changed function, so that it ends
TURNS = 5000
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


def changed(
    source: str,
    names: Sequence[str],
    changes: Callable[[ast.AST, Sequence[str]], Iterator[Change]],
) -> Iterator[tuple[str, ast.Module]]:
    """What is different, in words, and the code with this one difference, for each of `changes` in each of its parts.

    names: of arguments, one of which may stand in place of another
    """
    tree = ast.parse(source)
    if isinstance(tree.body[0], ast.FunctionDef):
        tree.body[0].decorator_list = []
    kept = pickle.dumps(tree)  # three times as fast as copy.deepcopy
    parents = {
        child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)
    }
    places = {node: i for i, node in enumerate(ast.walk(tree))}
    for node, i in places.items():
        around = _around(node, parents) if isinstance(node, SMALL) else node
        for said, change in changes(node, names):
            other = pickle.loads(kept)
            nodes = list(ast.walk(other))
            change(nodes[i])
            if around is not node:
                thing = re.escape(said.rpartition(" ")[2].strip("“”"))
                is_clear = (
                    len(re.findall(rf"(?<!\w){thing}(?!\w)", ast.unparse(around))) == 1
                )
                new, old = quoted(nodes[places[around]]), quoted(around)
                said += f" in {old}" if is_clear else f": {new}, not {old}"
            yield said, ast.fix_missing_locations(other)


def _around(node: ast.AST, parents: Mapping[ast.AST, ast.AST]) -> ast.AST:
    """In which piece of code a name or a number stands, if there is one that is short; else itself."""
    around = node
    while isinstance(
        above := parents[around],
        ast.expr | ast.keyword | ast.Assign | ast.Return | ast.AugAssign,
    ):
        if len(ast.unparse(above)) > LONGEST:
            break
        around = above
    return around


def made(tree: Any, right: Callable[..., Any]) -> Callable[..., Any]:
    """The function in a tree, which sees what `right` sees. Its loops have an end: it then raises StopIteration."""
    for node in ast.walk(tree):
        if isinstance(node, ast.While | ast.For):
            node.body.insert(0, ast.parse(f"next({SPENT})").body[0])
    tree.body[0].body.insert(0, ast.parse(f"{SPENT} = iter(range({TURNS}))").body[0])
    names: dict[str, Any] = {}
    exec(
        compile(ast.fix_missing_locations(tree), f"<changed {right.__name__}>", "exec"),
        right.__globals__,
        names,
    )
    return names[right.__name__]  # type: ignore[no-any-return]


def quoted(node: ast.AST) -> str:
    """A piece of code; of a block its first line."""
    return f"“{ast.unparse(node).splitlines()[0]}”"


def become(node: ast.AST, code: str) -> None:
    """Another expression or statement in place of this one, whatever kind of node it is."""
    other, context = ast.parse(code).body[0], getattr(node, "ctx", None)
    other = other.value if isinstance(node, ast.expr) else other
    node.__class__ = type(other)
    vars(node).clear()
    vars(node).update(vars(other))
    if context and hasattr(node, "ctx"):
        node.ctx = context


def simple_changes(node: ast.AST, names: Sequence[str]) -> Iterator[Change]:
    """Another comparison, operator, number, argument, call; two statements in another order, or one left out.

    The tapes of the course tell each from the right function: tests/course/test_mutants.py.
    """
    if isinstance(node, ast.Compare):
        for k, operator in enumerate(node.ops):
            for other in COMPARED.get(type(operator), ()):
                new = ast.Compare(
                    node.left,
                    [*node.ops[:k], other(), *node.ops[k + 1 :]],
                    node.comparators,
                )
                said = f"{quoted(new)} were asked, not {quoted(node)}"
                yield said, lambda n, k=k, o=other: n.ops.__setitem__(k, o())
            border = node.comparators[k]
            if (
                isinstance(border, ast.Constant)
                and type(border.value) is int
                and border.value
            ):
                for value in (border.value * 1.04, border.value * 0.96):
                    said = f"{value} stood in place of {border.value} in {quoted(node)}"
                    yield (
                        said,
                        lambda n, k=k, v=value: setattr(n.comparators[k], "value", v),
                    )
    elif isinstance(node, ast.BinOp | ast.AugAssign):
        left, right = (
            (node.left, node.right)
            if isinstance(node, ast.BinOp)
            else (node.target, node.value)
        )
        for other, said in RECKONED.get(type(node.op), {}).items():
            said = said.format(left=quoted(left), right=quoted(right))
            yield said, lambda n, o=other: setattr(n, "op", o())
    elif isinstance(node, ast.BoolOp):
        word, other = (
            ("or", ast.Or) if isinstance(node.op, ast.And) else ("and", ast.And)
        )
        yield (
            f"“{word}” joined the parts of {quoted(node)}",
            lambda n: setattr(n, "op", other()),
        )
        for k, part in enumerate(node.values):
            yield (
                f"{quoted(part)} were left out of {quoted(node)}",
                lambda n, k=k: _leave_out(n, k),
            )
    elif isinstance(node, ast.UnaryOp):
        word = "not" if isinstance(node.op, ast.Not) else "minus"
        yield (
            f"the {word} before {quoted(node.operand)} were left out",
            lambda n: setattr(n, "op", ast.UAdd()),
        )
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
        more = (
            (node.value * 1.04, node.value * 0.96)
            if type(node.value) is float and node.value
            else ()
        )
        for value in (node.value + 1, node.value - 1, *more):
            yield (
                f"{value} stood in place of {node.value}",
                lambda n, v=value: setattr(n, "value", v),
            )
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        for other in (
            *(name for name in names if node.id in names),
            *CALLED.get(node.id, ()),
        ):
            if other != node.id:
                yield (
                    f"“{other}” stood in place of “{node.id}”",
                    lambda n, o=other: setattr(n, "id", o),
                )
    elif isinstance(node, ast.Attribute):
        for other in CALLED.get(node.attr, ()):
            yield (
                f"“{other}” stood in place of “{node.attr}”",
                lambda n, o=other: setattr(n, "attr", o),
            )
    elif (
        isinstance(node, ast.Call)
        and len(node.args) == 1
        and isinstance(node.args[0], ast.Name)
    ):
        is_len = ast.unparse(node.func) == "len"
        if is_len:
            yield (
                f"{quoted(node)} were one less",
                lambda n: become(n, f"{ast.unparse(n)} - 1"),
            )
        for part, said in (
            PARTS.items() if node.args[0].id in names and not is_len else ()
        ):
            yield (
                said.format(quoted(node.args[0])),
                lambda n, p=part: become(n.args[0], n.args[0].id + p),
            )
            if ":" not in part:
                said = said.format(quoted(node.args[0])) + f", and {quoted(node)}, too"
                yield said, lambda n, p=part: become(n, n.args[0].id + p)
    if isinstance(node, ast.If | ast.IfExp):
        yield (
            f"{quoted(node.test)} never held",
            lambda n: setattr(n, "test", ast.Constant(False)),
        )
        yield (
            f"{quoted(node.test)} always held",
            lambda n: setattr(n, "test", ast.Constant(True)),
        )
    for block in ("body", "orelse"):
        statements = getattr(node, block, None)
        statements = statements if isinstance(statements, list) else []
        for k, (one, other) in enumerate(pairwise(statements)):
            if not _commute(one, other):
                said = f"{quoted(other)} came before {quoted(one)}"
                yield (
                    said,
                    lambda n, b=block, k=k: getattr(n, b).insert(
                        k, getattr(n, b).pop(k + 1)
                    ),
                )
        for k, one in enumerate(statements):
            if isinstance(
                one,
                ast.Assign
                | ast.AugAssign
                | ast.Expr
                | ast.Return
                | ast.Break
                | ast.Continue,
            ):
                if isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant):
                    continue  # a docstring
                yield (
                    f"{quoted(one)} were missing",
                    lambda n, b=block, k=k: getattr(n, b).__setitem__(k, ast.Pass()),
                )


def _leave_out(node: ast.BoolOp, k: int) -> None:
    rest = [f"({ast.unparse(part)})" for i, part in enumerate(node.values) if i != k]
    become(node, (" and " if isinstance(node.op, ast.And) else " or ").join(rest))


def _commute(one: ast.stmt, other: ast.stmt) -> bool:
    """Whether two statements do the same in any order: none leaves the function, or changes what the other names."""
    for a, b in ((one, other), (other, one)):
        if isinstance(
            a, ast.FunctionDef
        ):  # what it names is looked up when it is called
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
