"""The library stays small enough to be read: lines of code and statements are counted, part by part."""

import ast
import io
import re
import tokenize
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

PACKAGE = Path(__file__).parents[2] / "rlrobot_edu"
MOST_LINES_OF_A_FILE = 220
MOST_CHARACTERS = (
    110  # of a line of the core's code; comments and docstrings may have 120
)
ROW = re.compile(r"^\| (`[^|]*) \| ([\d,]+) \| ([\d,]+) \|", re.MULTILINE)
NOT_CODE = {
    tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING,
    tokenize.ENDMARKER,
}  # fmt: skip


def sources() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def docstring_lines(text: str) -> set[int]:
    """Numbers of the lines on which the docstrings of a module, its classes and its functions stand."""
    lines = set()
    for node in ast.walk(ast.parse(text)):
        is_documented = isinstance(
            node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
        )
        if is_documented and ast.get_docstring(node) is not None:
            lines.update(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return lines


def tokens_of_code(text: str) -> list[tokenize.TokenInfo]:
    """The tokens of a Python source, docstrings included, but for comments and what is blank."""
    return [
        token
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type not in NOT_CODE
    ]


def lines_of_code(text: str) -> int:
    """Number of lines of a Python source that are neither blank nor a comment nor part of a docstring."""
    lines = set()
    for token in tokens_of_code(text):
        lines.update(range(token.start[0], token.end[0] + 1))
    return len(lines - docstring_lines(text))


def statements(text: str) -> int:
    """Number of statements of a Python source without docstrings; one that assigns a tuple counts as its elements."""
    count = 0
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.Expr(value=ast.Constant(value=str())):
                pass
            case ast.Assign(targets=[ast.Tuple()], value=ast.Tuple(elts=elements)):
                count += len(elements)
            case ast.stmt():
                count += 1
    return count


class Count(NamedTuple):
    lines: int
    statements: int

    def __add__(self, other):
        return Count(self.lines + other.lines, self.statements + other.statements)


def limits() -> dict[str, Count]:
    """What CONTRIBUTING allows, by the first cell of each row there, the core's first."""
    page = (PACKAGE.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
    section = page.partition("## How large it may be")[2].partition("\n## ")[0]
    return {
        row: Count(*(int(most.replace(",", "")) for most in numbers))
        for row, *numbers in ROW.findall(section)
    }


def row_of(path: Path, rows: Iterable[str]) -> str:
    """The row that names the innermost folder of a file; the first, which is the core's, for a file of the root.

    Raises ValueError if no row names a folder of it.
    """
    if path.parent == PACKAGE:
        return next(iter(rows))
    for folder in path.relative_to(PACKAGE).parents:
        for row in rows:
            if f"`{folder.as_posix()}`" in row:
                return row
    raise ValueError(f"CONTRIBUTING says nothing of {path.parent.relative_to(PACKAGE)}")


def test_no_part_of_the_library_is_larger_than_it_may_be():
    allowed = limits()
    counted = dict.fromkeys(allowed, Count(0, 0))
    for path in sources():
        text = path.read_text(encoding="utf-8")
        counted[row_of(path, allowed)] += Count(lines_of_code(text), statements(text))
    report = "\n".join(
        f"{counted[row]} of {most} {row}" for row, most in allowed.items()
    )
    print(f"\n{report}")
    assert all(
        n <= most
        for row in allowed
        for n, most in zip(counted[row], allowed[row], strict=True)
    ), report


def test_no_line_of_the_cores_code_is_too_long_to_be_read_at_once():
    core, *others = limits()
    long = []
    for path in sources():
        text = path.read_text(encoding="utf-8")
        ends = (
            {token.end for token in tokens_of_code(text)}
            if row_of(path, (core, *others)) == core
            else set()
        )
        documented = docstring_lines(text)
        long += [
            f"{path.name}:{line}"
            for line, end in ends
            if end > MOST_CHARACTERS and line not in documented
        ]
    assert not long


def test_no_file_has_more_lines_of_code_than_can_be_read_in_one_sitting():
    long = {
        str(path.relative_to(PACKAGE)): n
        for path in sources()
        if (n := lines_of_code(path.read_text(encoding="utf-8"))) > MOST_LINES_OF_A_FILE
    }
    assert not long


def test_every_package_says_what_is_in_it_and_imports_nothing_of_ours():
    faults = []
    for path in PACKAGE.rglob("__init__.py"):
        tree, name = (
            ast.parse(path.read_text(encoding="utf-8")),
            path.parent.relative_to(PACKAGE.parent),
        )
        text = ast.get_docstring(tree) or ""
        if len(text.split()) < 4 or "TODO" in text:
            faults.append(f"{name}: its docstring {text!r} does not say what is in it")
        ours = [
            node
            for node in ast.walk(tree)
            if (getattr(node, "module", "") or "").startswith("rlrobot_edu")
        ]
        if path.parent != PACKAGE and ours:
            faults.append(
                f"{name}: it imports from the package; the public names stand in rlrobot_edu/__init__.pyi"
            )
    assert not faults, "\n".join(faults)
