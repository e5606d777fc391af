"""The library stays small enough to be read: lines of code are counted, room by room."""

import ast
import io
import re
import tokenize
from collections import Counter
from pathlib import Path

PACKAGE = Path(__file__).parents[2] / "rlrobot_edu"
MOST_LINES_OF_A_FILE = 220
ROW = re.compile(r"^\| (`[^|]*) \| ([\d,]+) \|", re.MULTILINE)
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
        is_documented = isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
        if is_documented and ast.get_docstring(node) is not None:
            lines.update(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return lines


def lines_of_code(text: str) -> int:
    """Number of lines of a Python source that are neither blank nor a comment nor part of a docstring."""
    lines = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in NOT_CODE:
            lines.update(range(token.start[0], token.end[0] + 1))
    return len(lines - docstring_lines(text))


def room(path: Path) -> str:
    """The room of the library in which a file lies; a file beside the rooms is one of its own."""
    return path.relative_to(PACKAGE).parts[0]


SAMPLE = '''"""Two
lines."""

# a comment
x = """not a
docstring"""  # 2


def f(
    a,
):
    """One."""
    return a
'''


def test_only_code_is_counted():
    assert lines_of_code(SAMPLE) == 2 + 3 + 1


def parts() -> dict[str, int]:
    """The limits that CONTRIBUTING says, by the part's words there: rooms and files between ` signs."""
    page = (PACKAGE.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")
    section = page.partition("## How large it may be")[2].partition("\n## ")[0]
    return {part: int(most.replace(",", "")) for part, most in ROW.findall(section)}


def test_no_part_of_the_library_has_more_lines_of_code_than_it_may():
    lines = Counter()
    for path in sources():
        lines[room(path)] += lines_of_code(path.read_text(encoding="utf-8"))
    of_the_core, *around = parts()
    its_rooms = re.findall("`(.*?)`", of_the_core)
    rooms_around = [name for part in around for name in re.findall("`(.*?)`", part)]
    its_files = [name for name in lines if name.endswith(".py") and name not in rooms_around]
    counted = {part: sum(lines[name] for name in re.findall("`(.*?)`", part)) for part in around}
    counted = {of_the_core: sum(lines[name] for name in its_rooms + its_files)} | counted
    report = "\n".join(f"{n:6,} of {parts()[part]:6,} {part}" for part, n in counted.items())
    print(f"\nlines of code\n{report}")
    assert all(n <= parts()[part] for part, n in counted.items()), f"a part has become too large:\n{report}"
    forgotten = lines.keys() - {*its_rooms, *its_files, *rooms_around, "course", "reproduction"}
    assert not forgotten, f"CONTRIBUTING says nothing of {forgotten}"


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
        tree, name = ast.parse(path.read_text(encoding="utf-8")), path.parent.relative_to(PACKAGE.parent)
        text = ast.get_docstring(tree) or ""
        if len(text.split()) < 4 or "TODO" in text:
            faults.append(f"{name}: its docstring {text!r} does not say what is in it")
        ours = [node for node in ast.walk(tree) if (getattr(node, "module", "") or "").startswith("rlrobot_edu")]
        if path.parent != PACKAGE and ours:
            faults.append(f"{name}: it imports from the package; the public names stand in rlrobot_edu/__init__.pyi")
    assert not faults, "\n".join(faults)
