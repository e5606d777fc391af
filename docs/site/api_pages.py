"""The pages of the API: the public names of rlrobot_edu, a page for each of its folders, and those of rlrobot_ros."""

import inspect
import sys
from pathlib import Path

import rlrobot_edu
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
    "rlrobot_ros": "Use a real robot",
}
ABOUT = """# API by what you want to do

The names of the last group are in `rlrobot_ros`, all others in `import rlrobot_edu as rl`. Authors of lessons also use
[rlrobot_course](../../rlrobot_course/__init__.py) and [rlrobot_grading](../../rlrobot_grading/__init__.py).
"""


def groups() -> dict[str, list[str]]:
    """What is public, by folder in the order of TITLES. Raises KeyError for a folder without a title."""
    found: dict[str, list[str]] = {folder: [] for folder in TITLES}
    for name in rlrobot_edu.__all__:
        folder = getattr(rlrobot_edu, name).__module__.split(".")[1]
        found[folder].append(f"rlrobot_edu.{name}")
    for name in rlrobot_ros.__all__:
        found["rlrobot_ros"].append(f"rlrobot_ros.{name}")
    return {folder: names for folder, names in found.items() if names}


def thing(full_name: str) -> object:
    """What a full name stands for."""
    package, name = full_name.split(".")
    return getattr(sys.modules[package], name)


def described(name: str) -> str:
    """A heading and the directive that writes its docstring."""
    kind = "autoclass" if inspect.isclass(thing(name)) else "autofunction"
    short = name.partition(".")[2]
    return f"## {short}\n\n```{{eval-rst}}\n.. {kind}:: {name}\n```\n"


def in_short(folder: str, name: str) -> str:
    """A link to a name, and the first sentence of its docstring."""
    first, _, _ = inspect.getdoc(thing(name)).partition("\n")
    short = name.partition(".")[2]
    return f"- [`{short}`]({folder}.md#{short.lower()}): {first}"


def write_api(api: Path) -> None:
    """index.md and a page for each folder."""
    api.mkdir(parents=True, exist_ok=True)
    lines = [ABOUT]
    for folder, names in groups().items():
        text = f"# {TITLES[folder]}\n\n" + "\n".join(described(name) for name in names)
        (api / f"{folder}.md").write_text(text, encoding="utf-8")
        lines += ["", f"## {TITLES[folder]}", ""]
        lines += [in_short(folder, name) for name in names]
    toc = "\n".join(groups())
    lines += ["", f"```{{toctree}}\n:hidden:\n\n{toc}\n```", ""]
    (api / "index.md").write_text("\n".join(lines), encoding="utf-8")
