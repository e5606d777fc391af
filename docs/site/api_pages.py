"""The pages of the API: the public names of rlrobot_edu and of rlrobot_ros, a page for each folder of the library."""

import ast
import inspect
from pathlib import Path
from types import ModuleType

import rlrobot_edu as rl
import rlrobot_ros

TITLES = {  # by folder of the library: what one wants to do with its names
    "task": "Describe a task",
    "environments": "Make its world",
    "robots": "Make its robot more real",
    "learning": "Let an agent learn",
    "show": "Draw and film it",
    "widgets": "Step through, watch and drive it",
    "models": "Record, and learn from a model",
    "experiments": "Repeat and compare",
    "tools": "Check a task, explain values, transfer knowledge",
    "ros": "Use a real robot",
}


def groups() -> dict[str, list[str]]:
    """Public names by the folder that they come from, in the order of TITLES."""
    stub = ast.parse(Path(rl.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    found: dict[str, list[str]] = {folder: [] for folder in TITLES}
    for node in stub.body:
        if isinstance(node, ast.ImportFrom):
            found[node.module.split(".")[0]].append(node.names[0].name)
    found["ros"] = list(rlrobot_ros.__all__)
    return found


def package_of(name: str) -> ModuleType:
    """The package that offers the name."""
    return rlrobot_ros if name in rlrobot_ros.__all__ else rl


def described(name: str) -> str:
    """A heading and the directive that writes its docstring."""
    package = package_of(name)
    kind = "autoclass" if inspect.isclass(getattr(package, name)) else "autofunction"
    path = f"{package.__name__}.{name}"
    return f"## {name}\n\n```{{eval-rst}}\n.. {kind}:: {path}\n```\n"


def in_short(folder: str, name: str) -> str:
    """A link to a name, and the first sentence of its docstring."""
    first, _, _ = inspect.getdoc(getattr(package_of(name), name)).partition("\n")
    return f"- [`{name}`]({folder}.md#{name.lower()}): {first}"


def write_api(api: Path) -> None:
    api.mkdir(parents=True, exist_ok=True)
    lines = [
        "# API by what you want to do",
        "",
        "All names are in `import rlrobot_edu as rl`, those of real robots in `rlrobot_ros`.",
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
