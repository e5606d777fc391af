"""What can be read off the source of a code cell: from its syntax as IPython understands it, never from its text."""

from __future__ import annotations

import ast
import re
import warnings
from collections import defaultdict, deque
from collections.abc import Iterator, Sequence
from functools import lru_cache

CHECK = "check"  # the name by which notebooks know the checks of their lesson
VARIANT = "use_variant"  # by which a notebook asks for the variant of a student
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
    while True:
        parsed = _parsed(source)
        below = None if parsed is None else _below_magic(parsed)
        if below is None:
            return parsed
        source = below


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
    found: set[str] = set()
    for names, value in _bindings(source):
        if by_take or not _takes(value):
            found |= names
    return found


def _takes(value: ast.AST) -> bool:
    return not isinstance(value, DEFINITIONS) and "take" in _names_in(value)


def handed_in(source: str) -> set[str]:
    """The exercises whose checks a cell calls."""
    return {
        _exercise(node.func) for node in _all(source) if isinstance(node, ast.Call)
    } - {""}


def exercise_in_last_line(source: str) -> str:
    """The exercise that a cell hands to its check in its last line, as check.NAME(NAME); empty if it does not."""
    parsed = tree(source)
    if parsed is None or not parsed.body:
        return ""
    last = parsed.body[-1]
    if not isinstance(last, ast.Expr) or not isinstance(last.value, ast.Call):
        return ""
    name = _exercise(last.value.func)
    is_its_check = ast.unparse(last) == f"{CHECK}.{name}({name})"
    return name if is_its_check else ""


def hints_asked(cells: Sequence[str], exercise: str) -> int:
    """How many different hints of an exercise the cells ask for."""
    asked = set()
    for source in cells:
        for call in _all(source):
            if not isinstance(call, ast.Call) or not _asks_hint(call.func, exercise):
                continue
            numbers = call.args + [keyword.value for keyword in call.keywords]
            number = numbers[0] if numbers else ast.Constant(1)
            asked.add(number.value if isinstance(number, ast.Constant) else id(number))
    return len(asked)


def _asks_hint(function: ast.AST, exercise: str) -> bool:
    """Whether this is check.NAME.hint of the exercise."""
    is_hint = isinstance(function, ast.Attribute) and function.attr == "hint"
    return is_hint and _exercise(function.value) == exercise


def imported(source: str) -> list[str]:
    """The full names of what a cell imports."""
    names = []
    for node in _all(source):
        if isinstance(node, ast.ImportFrom):
            names += [f"{node.module}.{one.name}" for one in node.names]
        elif isinstance(node, ast.Import):
            names += [one.name for one in node.names]
    return names


def lessons_imported(source: str, package: str) -> list[str]:
    """The lessons of a course whose checks a cell imports, as lesson_03 or assignment_1."""
    lessons = []
    for name in imported(source):
        match name.split("."):
            case [course, lesson, attribute, *_]:
                if course == package and attribute == CHECK:
                    lessons.append(lesson)
    return lessons


def made_for(source: str) -> str:
    """The student whose variant a cell asks for, by use_variant(check, "…"); empty if it does not."""
    for node in _all(source):
        match node:
            case ast.Call(ast.Name(name), [_, ast.Constant(student), *_]):
                if name == VARIANT:
                    return str(student)
    return ""


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
            if isinstance(call, ast.Call):
                name = _exercise(call.func)
                for argument in call.args:
                    found[name] |= _names_in(argument)
    found.pop("", None)
    return found


def _exercise(node: ast.AST) -> str:
    """Which exercise check.NAME is, or lesson_03.check.NAME; empty for anything else."""
    if not isinstance(node, ast.Attribute):
        return ""
    owner = node.value
    is_check = CHECK in (getattr(owner, "id", ""), getattr(owner, "attr", ""))
    return node.attr if is_check else ""


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
        node = ahead.popleft()
        yield node
        if not isinstance(node, SCOPES | COMPREHENSIONS):
            ahead.extend(ast.iter_child_nodes(node))
