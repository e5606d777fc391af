"""A right function, or a formula, with one thing in it that is different, and in words what that is.

The words go on after “it answers as if”. Pieces of code in them stand in “ and ”.
"""

from __future__ import annotations

import ast
import copy
import pickle
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from rlrobot_grading.answers.values import Function

Change = tuple[str, str]  # in words, and the code that stands in place of a node

# what is told with the code around it
SMALL = (ast.Name, ast.Constant, ast.Attribute, ast.Subscript)
LONGEST = 50  # characters of that code
SPENT = "_turns"  # of the loops in a changed function, so that it ends
TURNS = 5000


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
        for said, code in changes(node, names):
            other = pickle.loads(kept)
            nodes = list(ast.walk(other))
            become(nodes[i], code)
            if around is not node:
                thing = re.escape(said.rpartition(" ")[2].strip("“”"))
                is_clear = (
                    len(re.findall(rf"(?<!\w){thing}(?!\w)", ast.unparse(around))) == 1
                )
                new, old = quoted(nodes[places[around]]), quoted(around)
                said += f" in {old}" if is_clear else f": {new}, not {old}"
            yield said, ast.fix_missing_locations(other)


def _around(node: ast.AST, parents: Mapping[ast.AST, ast.AST]) -> ast.AST:
    """In which piece of code a name or a number stands, the smallest that says more; itself, if that is long."""
    pieces = ast.expr | ast.keyword | ast.Assign | ast.Return | ast.AugAssign
    around = node
    above = parents[around]
    while isinstance(above, pieces) and len(ast.unparse(above)) <= LONGEST:
        around = above
        if not isinstance(around, SMALL):
            break
        above = parents[around]
    return around


def made(tree: Any, right: Function) -> Function:
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


def expression(code: str) -> ast.expr:
    """A piece of code, read by Python."""
    return ast.parse(code, mode="eval").body


def with_parts(node: ast.AST, **parts: Any) -> str:
    """The code of a node of which some parts are others."""
    other = copy.copy(node)
    for name, part in parts.items():
        setattr(other, name, part)
    return ast.unparse(other)


def become(node: ast.AST, code: str) -> None:
    """Other code in place of a node, whatever kind of node it is."""
    if isinstance(node, ast.Module):
        node.body = ast.parse(code).body
        return
    context = getattr(node, "ctx", None)
    other: Any = ast.parse(code).body[0]
    if isinstance(node, ast.expr):
        other = other.value
    node.__class__ = type(other)
    vars(node).clear()
    vars(node).update(vars(other))
    if context and hasattr(node, "ctx"):
        node.ctx = context
