"""The pages of the API: the names of rlrobot_edu/__init__.pyi, a page for each folder of the library."""

import ast
import inspect
from pathlib import Path

import rlrobot_edu as rl

TITLES = {
    "task": "Tasks",
    "learning": "Agents and learning",
    "environments": "Environments",
    "robots": "Robots",
    "models": "Recordings and models",
    "experiments": "Experiments",
    "show": "Pictures and films",
    "widgets": "Widgets",
    "tools": "Tools",
    "ros": "Real robots",
}


def groups() -> dict[str, list[str]]:
    """Public names by the folder that they come from, in the order of TITLES."""
    stub = ast.parse(Path(rl.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    found: dict[str, list[str]] = {room: [] for room in TITLES}
    for node in stub.body:
        if isinstance(node, ast.ImportFrom):
            found[node.module.split(".")[0]].append(node.names[0].name)
    return found


def described(name: str) -> str:
    """A heading and the directive that writes its docstring."""
    kind = "autoclass" if inspect.isclass(getattr(rl, name)) else "autofunction"
    return f"## {name}\n\n```{{eval-rst}}\n.. {kind}:: rlrobot_edu.{name}\n```\n"


def write_api(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    lines = ["# API reference", "", "What `import rlrobot_edu as rl` offers.", ""]
    for room, names in groups().items():
        text = f"# {TITLES[room]}\n\n" + "\n".join(described(name) for name in names)
        (folder / f"{room}.md").write_text(text, encoding="utf-8")
        links = ", ".join(f"[`{name}`]({room}.md#{name.lower()})" for name in names)
        lines.append(f"- [{TITLES[room]}]({room}.md): {links}")
    toc = "\n".join(TITLES)
    lines += ["", f"```{{toctree}}\n:hidden:\n\n{toc}\n```", ""]
    (folder / "index.md").write_text("\n".join(lines), encoding="utf-8")
