"""The pages of the API: the names of rlrobot_edu/__init__.pyi, a page for each folder of the library."""

import ast
import inspect
from pathlib import Path

import rlrobot_edu as rl

TITLES = {  # by folder of the library: what one wants to do with its names
    "task": "Describe a task",
    "environments": "Make its world",
    "robots": "Make its robot more real",
    "learning": "Let an agent learn",
    "show": "Draw and film it",
    "widgets": "Step through, watch and drive it",
    "models": "Record, and learn from a model",
    "experiments": "Repeat and compare",
}


def groups() -> dict[str, list[str]]:
    """Public names by the folder that they come from, in the order of TITLES."""
    stub = ast.parse(Path(rl.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    found: dict[str, list[str]] = {folder: [] for folder in TITLES}
    for node in stub.body:
        if isinstance(node, ast.ImportFrom):
            found[node.module.split(".")[0]].append(node.names[0].name)
    return found


def described(name: str) -> str:
    """A heading and the directive that writes its docstring."""
    kind = "autoclass" if inspect.isclass(getattr(rl, name)) else "autofunction"
    return f"## {name}\n\n```{{eval-rst}}\n.. {kind}:: rlrobot_edu.{name}\n```\n"


def in_short(folder: str, name: str) -> str:
    """A link to a name, and the first sentence of its docstring."""
    first, _, _ = inspect.getdoc(getattr(rl, name)).partition("\n")
    return f"- [`{name}`]({folder}.md#{name.lower()}): {first}"


def write_api(api: Path) -> None:
    api.mkdir(parents=True, exist_ok=True)
    lines = [
        "# API by what you want to do",
        "",
        "These names are in `import rlrobot_edu as rl`; all else is imported from its module, which says what it is.",
    ]
    for folder, names in groups().items():
        text = f"# {TITLES[folder]}\n\n" + "\n".join(described(name) for name in names)
        (api / f"{folder}.md").write_text(text, encoding="utf-8")
        lines += [
            "",
            f"## {TITLES[folder]}",
            "",
            *(in_short(folder, name) for name in names),
        ]
    toc = "\n".join(TITLES)
    lines += ["", f"```{{toctree}}\n:hidden:\n\n{toc}\n```", ""]
    (api / "index.md").write_text("\n".join(lines), encoding="utf-8")
