"""Wheels and source archives have the notebooks without outputs, which are the most of them; hatchling runs this.

In a wheel, where a link leads to a page of the repository, its text and the page's name stand instead.
"""

import json
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

FOLDERS = ("notebooks", "notebooks/more", "homework")
TO_REPOSITORY = re.compile(r"\[([^]]+)\]\((?:\.\./)+([\w/]+\.(?:md|py))(?:#[\w-]*)?\)")


class Blank(BuildHookInterface):
    """Put blank notebooks into what is built, but into no editable install: that one reads those of the checkout."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Write them to a temporary folder, and have them included."""
        self.folder = Path(tempfile.mkdtemp())
        is_wheel = self.target_name == "wheel"
        for name in () if version == "editable" else FOLDERS:
            for path in Path(self.root, name).glob("*.ipynb"):
                mine = self.folder / name.replace("/", "_") / path.name
                mine.parent.mkdir(exist_ok=True)
                mine.write_text(blank(path, is_wheel), encoding="utf-8", newline="\n")
                build_data["force_include"][str(mine)] = f"{'rlrobot_edu/' * is_wheel}{name}/{path.name}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove the temporary folder."""
        shutil.rmtree(self.folder)


def blank(path: Path, is_wheel: bool) -> str:
    """The text of a notebook without outputs."""
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell |= {"outputs": [], "execution_count": None}
        elif is_wheel:
            cell["source"] = [TO_REPOSITORY.sub(r"\1 (in the repository: \2)", line) for line in cell["source"]]
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"
