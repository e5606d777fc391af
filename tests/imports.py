"""What the project's files import from elsewhere."""

import ast
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]


def imports_of(folder: str) -> dict[str, set[str]]:
    """The first names of all modules that a folder's files import, each with the files; Python's own are left out."""
    found: dict[str, set[str]] = {}
    for path in (ROOT / folder).rglob("*.py"):
        file = path.relative_to(ROOT).as_posix()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            for module in _imported(node):
                name = module.partition(".")[0]
                if name not in sys.stdlib_module_names:
                    found.setdefault(name, set()).add(file)
    return found


def _imported(node: ast.AST) -> list[str]:
    match node:
        case ast.Import():
            return [alias.name for alias in node.names]
        case ast.ImportFrom(module=str(module), level=0):
            return [module]
    return []
