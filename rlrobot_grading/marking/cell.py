"""What can be read off the source of a code cell: from its syntax as IPython understands it, never from its text."""

from __future__ import annotations

import ast
import copy
import re
import warnings
from collections import defaultdict, deque
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import lru_cache

COURSE = "rlrobot_course."
CHECK = "check"  # the name by which notebooks know the checks of their lesson
# Cell magics below which no code of this notebook stands; below others, of extensions, too, mostly Python
NO_PYTHON = re.compile(
    "writefile|file|bash|sh|script|system|sx|cmd|perl|ruby|pypy|python[23]?|html|javascript|js|svg|latex|markdown",
    re.IGNORECASE,
)
MOST_WORK = 1_000_000  # characters times magics: IPython reads a cell anew for each of its magics
UNREADABLE = (SyntaxError, ValueError, RecursionError, MemoryError, RuntimeError)
SCOPES = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.Lambda
DEFINITIONS = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
COMPREHENSIONS = ast.ListComp | ast.SetComp | ast.DictComp | ast.GeneratorExp
JUDGING = ("judge", "__call__", "__bool__")  # what judges an answer


@lru_cache(maxsize=1000)
def tree(source: str) -> ast.Module | None:
    """The syntax of a cell; None where it cannot be read."""
    while (parsed := _parsed(source)) and (below := _below_magic(parsed)) is not None:
        source = below
    return parsed


def _parsed(source: str) -> ast.Module | None:
    for as_python in (str, _with_calls):
        try:
            with warnings.catch_warnings(action="ignore"):
                return ast.parse(as_python(source))
        except UNREADABLE:
            continue
    return None


def _below_magic(parsed: ast.Module) -> str | None:
    """The code below a cell magic, which IPython and exported scripts hand to a function as a text."""
    match parsed.body:
        case [
            ast.Expr(
                ast.Call(
                    ast.Attribute(ast.Call(ast.Name("get_ipython")), "run_cell_magic"),
                    [ast.Constant(name), _, ast.Constant(str(code))],
                )
            )
        ]:
            return "" if NO_PYTHON.fullmatch(str(name)) else code
    return None


def _with_calls(source: str) -> str:
    """The cell in Python: magics become calls, as in IPython. Raises ValueError if there are too many."""
    from IPython.core.inputtransformer2 import TransformerManager

    if len(source) * sum(map(source.count, "%!?")) > MOST_WORK:
        raise ValueError("this cell has too many magics")
    return TransformerManager().transform_cell(source)


def bound(source: str, by_take: bool = False) -> set[str]:
    """Names that a cell gives a value to; by_take: also those for which `take` gives it."""
    return set().union(
        *(names for names, value in _bindings(source) if by_take or not _takes(value))
    )


def _takes(value: ast.AST) -> bool:
    return not isinstance(value, DEFINITIONS) and "take" in _names_in(value)


def defined_in(source: str, name: str) -> ast.stmt | None:
    """The last function of this name that a cell defines, by def or as a lambda."""
    found = [node for node in _outside(tree(source)) if _defines(node, name)]
    with suppress(RecursionError):  # of one that is nested too deep
        return (
            copy.deepcopy(max(found, key=lambda node: node.lineno)) if found else None
        )
    return None


def _defines(node: ast.AST, name: str) -> bool:
    if isinstance(node, ast.Assign) and isinstance(node.value, ast.Lambda):
        return any(
            isinstance(target, ast.Name) and target.id == name
            for target in node.targets
        )
    return isinstance(node, ast.FunctionDef) and node.name == name


def handed_in(source: str) -> set[str]:
    """The exercises whose checks a cell calls."""
    return {
        _exercise(node.func) for node in _all(source) if isinstance(node, ast.Call)
    } - {""}


def handed_in_last(source: str) -> str:
    """The exercise that a cell hands to its check in its last line, as check.NAME(NAME); empty if it does not."""
    last = (body := getattr(tree(source), "body", [])) and body[-1]
    if not (isinstance(last, ast.Expr) and isinstance(last.value, ast.Call)):
        return ""
    name = _exercise(last.value.func)
    return name if name and ast.unparse(last) == f"{CHECK}.{name}({name})" else ""


def hints_asked(cells: Sequence[str], exercise: str) -> int:
    """How many different hints of an exercise the cells ask for."""
    calls = [
        node for source in cells for node in _all(source) if isinstance(node, ast.Call)
    ]
    asked = [
        call
        for call in calls
        if isinstance(call.func, ast.Attribute) and call.func.attr == "hint"
    ]
    numbers = [[*call.args, *(keyword.value for keyword in call.keywords)] for call in asked
               if _exercise(call.func.value) == exercise]  # fmt: skip
    known = (number[0] if number else ast.Constant(1) for number in numbers)
    return len(
        {one.value if isinstance(one, ast.Constant) else id(one) for one in known}
    )


def lessons_imported(source: str) -> list[str]:
    """The lessons whose checks a cell imports, as lesson_03 or assignment_1."""
    imported = []
    for node in _all(source):
        if isinstance(node, ast.ImportFrom):
            imported += [f"{node.module}.{one.name}" for one in node.names]
        elif isinstance(node, ast.Import):
            imported += [one.name for one in node.names]
    paths = [
        name.removeprefix(COURSE).split(".")
        for name in imported
        if name.startswith(COURSE)
    ]
    return [path[0] for path in paths if path[1:2] == [CHECK]]


def made_for(source: str) -> str:
    """The student whose variant a cell asks for, by own(check, "…"); empty if it does not."""
    calls = [
        node
        for node in _all(source)
        if isinstance(node, ast.Call) and _root(node.func) == "own"
    ]
    students = [
        part.value
        for call in calls
        for part in call.args[1:2]
        if isinstance(part, ast.Constant)
    ]
    return str(students[0]) if students else ""


def changes_checks(source: str) -> bool:
    """Whether a cell gives the checks, or something in them, another value."""
    return any(map(_changes_checks, _all(source)))


def _changes_checks(node: ast.AST) -> bool:
    if isinstance(node, ast.Name | ast.Attribute) and isinstance(
        node.ctx, ast.Store | ast.Del
    ):
        if isinstance(node, ast.Name):
            return node.id == CHECK
        return node.attr in JUDGING or _root(node) == CHECK
    if isinstance(node, ast.Call) and node.args and _root(node.func) == "setattr":
        return _root(node.args[0]) == CHECK
    return isinstance(node, ast.FunctionDef) and node.name == CHECK


def calls_in(cells: Sequence[str]) -> dict[str, set[str]]:
    """For each name that the cells bind, or check, the names that stand in what it is bound to."""
    found = defaultdict(set)
    for source in cells:
        for names, value in _bindings(source):
            for name in names:
                found[name] |= _names_in(value)
        for call in _all(source):
            if isinstance(call, ast.Call) and (name := _exercise(call.func)):
                found[name] |= {
                    part for argument in call.args for part in _names_in(argument)
                }
    return found


def _exercise(node: ast.AST) -> str:
    """Which exercise check.NAME is, or lesson_03.check.NAME; empty for anything else."""
    if not isinstance(node, ast.Attribute):
        return ""
    owner = node.value
    return (
        node.attr
        if CHECK in (getattr(owner, "id", ""), getattr(owner, "attr", ""))
        else ""
    )


def _root(node: ast.AST) -> str:
    """The name that an expression like check.target.hints begins with."""
    while isinstance(node, ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""


def _bindings(source: str) -> Iterator[tuple[set[str], ast.AST]]:
    """What a cell gives values to, outside of functions: names, and the syntax that the value comes from."""
    for node in _outside(tree(source)):
        if isinstance(node, DEFINITIONS):
            yield {node.name}, node
        elif isinstance(node, ast.Import | ast.ImportFrom):
            yield {one.asname or one.name.partition(".")[0] for one in node.names}, node
        elif isinstance(node, ast.Assign | ast.AnnAssign | ast.NamedExpr):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield set().union(*map(_names_in, targets)), node


def _names_in(node: ast.AST) -> set[str]:
    return {part.id for part in ast.walk(node) if isinstance(part, ast.Name)}


def _all(source: str) -> Iterator[ast.AST]:
    yield from ast.walk(tree(source) or ast.Module([], []))


def _outside(top: ast.AST | None) -> Iterator[ast.AST]:
    """The parts of a cell that are in no function and in no class of it."""
    ahead = deque([top] if top else [])
    while ahead:
        yield (node := ahead.popleft())
        if not isinstance(node, SCOPES | COMPREHENSIONS):
            ahead.extend(ast.iter_child_nodes(node))
