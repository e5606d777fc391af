"""How large the packages are: ``make size`` writes docs/howto/size.md. Nothing here is a limit.

Size is counted in tokens of code, as Python reads it: names, numbers, texts and signs. Unlike lines, they do not become
fewer when code is packed. Tokens a statement say how dense it is. Comments and docstrings do not count.
"""

import ast
import io
import json
import os
import subprocess
import sys
import tokenize
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from tricks import COUNTED, FORBIDDEN, tricks_in

ROOT = Path(__file__).parents[1]
PACKAGES = ("rlrobot_edu", "rlrobot_ros", "rlrobot_grading", "rlrobot_course")
OTHER_LANGUAGES = ("js", "css", "html")
NO_CODE = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENCODING,
    tokenize.ENDMARKER,
}
# In a process of its own: which modules of ours the first steps of an agent load
FIRST_STEPS = """
import json, sys
import rlrobot_edu as rl
env = rl.make_env("wander_1k", seed=0)
agent = rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0)
rl.learn(agent, env, steps=10, progress=False)
print(json.dumps([getattr(module, "__file__", None) for module in sys.modules.values()]))
"""
PAGE = """# How large it is

Written by `make size`. A token is a name, a number, a text or a sign of Python; comments and docstrings do not count.
There is no limit of tokens or lines for a package: growth is for reviewers to see. A file has at most 260 lines of
code, which is what one reads in a sitting.

## Four packages

{packages}

## The library, by folder

{folders}

## The reading path

These {modules} modules, {path_tokens} tokens in all, are loaded by `make_env`, `Agent` and `learn` on `wander_1k`:

{path}

## JavaScript, CSS and HTML

{languages}

## Tricks

A test lets none of the first {forbidden} kinds become more frequent; those that are left will be rewritten. Nested
comprehensions are only counted.

{tricks}
"""


class Size(NamedTuple):
    """The size of some Python files."""

    files: int
    statements: int
    tokens: int

    @property
    def cells(self) -> tuple[str, ...]:
        """Files, tokens, and tokens a statement, for a table."""
        density = self.tokens / max(1, self.statements)
        return (f"{self.files}", f"{self.tokens:,}", f"{density:.1f}")


def docstring_lines(text: str) -> set[int]:
    """The lines on which the docstrings of a module, its classes and its functions stand."""
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    lines = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, documented) and ast.get_docstring(node) is not None:
            docstring = node.body[0]
            lines.update(range(docstring.lineno, docstring.end_lineno + 1))
    return lines


def tokens_of_code(text: str) -> list[tokenize.TokenInfo]:
    """The tokens of a Python source without comments, docstrings and blanks."""
    no_code = docstring_lines(text)
    tokens = []
    open_texts = 0  # since Python 3.12 an f-string is many tokens; here it is one
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        kind = tokenize.tok_name[token.type]
        is_code = token.type not in NO_CODE and token.start[0] not in no_code
        if is_code and open_texts == 0 and kind != "FSTRING_END":
            tokens.append(token)
        if kind == "FSTRING_START":
            open_texts += 1
        elif kind == "FSTRING_END":
            open_texts -= 1
    return tokens


def lines_of_code(text: str) -> int:
    """The number of lines that hold code."""
    lines = set()
    for token in tokens_of_code(text):
        lines.update(range(token.start[0], token.end[0] + 1))
    return len(lines)


def statements(text: str) -> int:
    """The number of statements, without docstrings. An assignment of a tuple counts once for each of its values."""
    count = 0
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.Expr(value=ast.Constant(value=str())):
                pass
            case ast.Assign(targets=[ast.Tuple()], value=ast.Tuple(elts=values)):
                count += len(values)
            case ast.stmt():
                count += 1
    return count


def size_of(paths: Iterable[Path]) -> Size:
    """The size of Python files together."""
    texts = [path.read_text(encoding="utf-8") for path in paths]
    return Size(
        files=len(texts),
        statements=sum(statements(text) for text in texts),
        tokens=sum(len(tokens_of_code(text)) for text in texts),
    )


def sources(*folders: str) -> list[Path]:
    """All Python files below folders of the project."""
    paths = [path for name in folders for path in (ROOT / name).rglob("*.py")]
    return sorted(path for path in paths if "__pycache__" not in path.parts)


def reading_path() -> list[Path]:
    """The files of ours that an agent's first steps load, in that order, kernels as plain Python."""
    done = subprocess.run(
        [sys.executable, "-c", FIRST_STEPS],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    files = [Path(name) for name in json.loads(done.stdout) if name]
    ours = [ROOT / name for name in PACKAGES]
    return [
        file
        for file in files
        if file.suffix == ".py" and any(file.is_relative_to(where) for where in ours)
    ]


def table(head: str, rows: Iterable[Iterable[str]]) -> str:
    """A table in Markdown; numbers stand to the right."""
    columns = head.split(" | ")
    rule = ["---", *["---:"] * (len(columns) - 1)]
    lines = [columns, rule, *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def packages_table() -> str:
    rows = [(f"`{name}`", *size_of(sources(name)).cells) for name in PACKAGES]
    rows.append(("together", *size_of(sources(*PACKAGES)).cells))
    return table("package | files | tokens | tokens a statement", rows)


def folders_table() -> str:
    library = ROOT / "rlrobot_edu"
    folders = sorted(path.parent.name for path in library.glob("*/__init__.py"))
    rows = [("the root's files", *size_of(sorted(library.glob("*.py"))).cells)]
    for name in folders:
        rows.append((f"`{name}`", *size_of(sources(f"rlrobot_edu/{name}")).cells))
    return table("folder | files | tokens | tokens a statement", rows)


def path_table(files: Iterable[Path]) -> str:
    rows = []
    for file in files:
        rows.append((f"`{file.relative_to(ROOT)}`", f"{size_of([file]).tokens:,}"))
    return table("module | tokens", rows)


def languages_table() -> str:
    rows = []
    for name in PACKAGES:
        for ending in OTHER_LANGUAGES:
            contents = [
                path.read_bytes() for path in ROOT.glob(f"{name}/**/*.{ending}")
            ]
            if contents:
                lines = sum(content.count(b"\n") for content in contents)
                size = sum(len(content) for content in contents)
                row = (f"`{name}`, .{ending}", f"{len(contents)}")
                rows.append((*row, f"{lines:,}", f"{size:,}"))
    return table("where | files | lines | bytes", rows)


def tricks_table() -> str:
    counts = tricks_in(sources(*PACKAGES))
    kinds = (*FORBIDDEN, *COUNTED)
    return table("kind | how often", [(kind, f"{counts[kind]}") for kind in kinds])


def page() -> str:
    """The text of docs/howto/size.md."""
    path = reading_path()
    return PAGE.format(
        packages=packages_table(),
        folders=folders_table(),
        modules=len(path),
        path_tokens=f"{size_of(path).tokens:,}",
        path=path_table(path),
        languages=languages_table(),
        forbidden=len(FORBIDDEN),
        tricks=tricks_table(),
    )


if __name__ == "__main__":
    (ROOT / "docs/howto/size.md").write_text(page(), encoding="utf-8")
