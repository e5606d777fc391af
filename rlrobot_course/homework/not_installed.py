"""While a notebook is graded, nothing is installed: pip, conda, apt and their like only say so.

Notebooks for Colab begin with ``%pip install …``, which would change what grades them. No lock: whoever wants to change
something finds another way, and meets the guard.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

SAID = "While a notebook is graded, nothing is installed."
# conda and uv as magics, too; what pip is called goes by Python's module of this name
PROGRAMS = ("conda", "mamba", "micromamba", "uv", "apt", "apt-get", "sudo", "brew")
PIP = """
def main(*_):
    print({said!r})
    open({asked!r}, "w").close()
    return 0
"""
PROGRAM = """#!/bin/sh
echo '{said}'
: > '{asked}'
"""
_asked: list[Path] = []  # where it is noted that something has been asked for


def install_nothing(shell: Any, home: Path) -> None:
    """Have what this kernel and its children call pip and so on install nothing; `home`: an empty folder of theirs."""
    folder, asked = home / "not_installed", home / "installs"
    _asked.append(asked)
    pip, programs = folder / "modules" / "pip", folder / "programs"
    for package in (pip, pip / "_internal", pip / "_internal" / "cli"):
        package.mkdir(parents=True)
        (package / "__init__.py").touch()
    code = PIP.format(said=SAID, asked=str(asked))
    (pip / "__init__.py").write_text(code, encoding="utf-8")
    (pip / "__main__.py").write_text("from pip import main\n\nmain()\n", encoding="utf-8")
    (pip / "_internal" / "cli" / "main.py").write_text("from pip import main\n", encoding="utf-8")
    programs.mkdir()
    for name in PROGRAMS:
        (programs / name).write_text(PROGRAM.format(said=SAID, asked=asked), encoding="utf-8")
        (programs / name).chmod(0o755)
        shell.register_magic_function(_say, "line", name)
    sys.path.insert(0, str(pip.parent))
    for variable, first in (("PYTHONPATH", pip.parent), ("PATH", programs)):
        os.environ[variable] = os.pathsep.join([str(first), *filter(None, [os.environ.get(variable)])])


def _say(_: str) -> None:
    print(SAID)
    _asked[0].touch()


def is_asked_for() -> bool:
    """Whether something should have been installed since this was asked last."""
    is_asked = _asked[0].exists()
    _asked[0].unlink(missing_ok=True)
    return is_asked
