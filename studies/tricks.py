"""Tricks in Python sources: what well-kept libraries do without, because a reader has to stop at it."""

import ast
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

FORBIDDEN = (
    "walrus",
    "writing through vars()",
    "text or list times a truth value",
    "conditional within a conditional",
    "unpacked generator or map",
    "call of a conditional",
)
COUNTED = ("nested comprehension, or with two for",)
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
# Methods and functions whose answer is a truth value
ASKING = {
    "all",
    "any",
    "bool",
    "endswith",
    "is_dir",
    "is_file",
    "isinstance",
    "isspace",
    "startswith",
}


def kinds_of(node: ast.AST) -> Iterable[str]:
    """The kinds of tricks that one node of a syntax tree is."""
    match node:
        case ast.NamedExpr():
            yield "walrus"
        case ast.Subscript(ctx=ast.Store(), value=ast.Call(func=ast.Name(id="vars"))):
            yield "writing through vars()"
        case ast.Call(
            func=ast.Attribute(attr="update", value=ast.Call(func=ast.Name(id="vars")))
        ):
            yield "writing through vars()"
        case ast.BinOp(op=ast.Mult(), left=left, right=right):
            if (_is_sequence(left) and _is_truth(right)) or (
                _is_truth(left) and _is_sequence(right)
            ):
                yield "text or list times a truth value"
        case ast.IfExp() if _holds(node, (ast.IfExp,)):
            yield "conditional within a conditional"
        case ast.Starred(value=ast.Call(func=ast.Name(id="map" | "zip"))):
            yield "unpacked generator or map"
        case ast.Starred(value=ast.GeneratorExp() | ast.ListComp() | ast.IfExp()):
            yield "unpacked generator or map"
        case ast.Call(func=ast.IfExp()):
            yield "call of a conditional"
        case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
            if len(node.generators) > 1 or _holds(node, COMPREHENSIONS):
                yield "nested comprehension, or with two for"


def tricks_in(paths: Iterable[Path]) -> Counter[str]:
    """How often each kind occurs in Python files."""
    counts: Counter[str] = Counter()
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            counts.update(kinds_of(node))
    return counts


def places_of(kind: str, paths: Iterable[Path]) -> list[str]:
    """Where a kind occurs: file and line."""
    places = []
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if kind in kinds_of(node):
                places.append(f"{path}:{node.lineno}")
    return places


def _holds(node: ast.AST, kinds: tuple[type[ast.AST], ...]) -> bool:
    inner = [other for other in ast.walk(node) if other is not node]
    return any(isinstance(other, kinds) for other in inner)


def _is_sequence(node: ast.AST) -> bool:
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str | bytes)
    return isinstance(node, ast.List | ast.Tuple | ast.JoinedStr)


def _is_truth(node: ast.AST) -> bool:
    match node:
        case ast.Compare() | ast.BoolOp() | ast.UnaryOp(op=ast.Not()):
            return True
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)):
            return name in ASKING
    return False
