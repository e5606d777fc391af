"""What hatchling runs: notebooks travel without outputs, which are the most of them, and links lead to the repository.

Its address is `Source` in pyproject.toml's `[project.urls]`. Without one, the words of a link stand alone.
"""

import json
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

FOLDERS = ("notebooks", "notebooks/more", "notebooks/homework")
OF_README = re.compile(r"(!?)\[([^]]+)\]\((?!https?:|#)([^)]+)\)")
OF_A_NOTEBOOK = re.compile(r"\[([^]]+)\]\((?:\.\./)+([\w/]+\.(?:md|py))(#[\w-]*)?\)")


class Readme(MetadataHookInterface):
    """The README as PyPI shows it, where a link within the repository would lead nowhere."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Write it into what is told of the package."""
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        text = from_elsewhere(text, metadata["urls"].get("Source"), metadata["version"])
        metadata["readme"] = {"content-type": "text/markdown", "text": text}


class Blank(BuildHookInterface):
    """Put blank notebooks and the tested versions into what is built.

    No editable install has copies of them: it reads those of the checkout.
    """

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Write them to a temporary folder, and have them included."""
        self.folder = Path(tempfile.mkdtemp())
        is_wheel = self.target_name == "wheel"
        source = self.metadata.core.urls.get("Source")
        pages = (
            f"[\\1]({source}/blob/v{self.metadata.version}/\\2\\3)"
            if source
            else r"\1 (in the repository: \2)"
        )
        if is_wheel and version != "editable":
            pins = str(Path(self.root, "constraints.txt"))
            build_data["force_include"][pins] = "rlrobot_edu/constraints.txt"
        for name in () if version == "editable" else FOLDERS:
            for path in Path(self.root, name).glob("*.ipynb"):
                mine = self.folder / name.replace("/", "_") / path.name
                mine.parent.mkdir(exist_ok=True)
                mine.write_text(
                    blank(path, pages if is_wheel else r"\g<0>"),
                    encoding="utf-8",
                    newline="\n",
                )
                build_data["force_include"][str(mine)] = (
                    f"{'rlrobot_edu/' * is_wheel}{name}/{path.name}"
                )

    def finalize(
        self, version: str, build_data: dict[str, Any], artifact_path: str
    ) -> None:
        """Remove the temporary folder."""
        shutil.rmtree(self.folder)


def from_elsewhere(text: str, source: str | None, version: str) -> str:
    """A page of the repository's root with links that lead to this version in the repository, if it has an address."""
    if not source:
        return OF_README.sub(r"\2", text)
    return OF_README.sub(
        lambda x: (
            f"{x[1]}[{x[2]}]({source}/{'raw' if x[1] else 'blob'}/v{version}/{x[3]})"
        ),
        text,
    )


def blank(path: Path, pages: str) -> str:
    """The text of a notebook without outputs.

    pages: what stands for a link to a page of the repository, as in `re.sub`
    """
    notebook = json.loads(path.read_text(encoding="utf-8"))
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell |= {"outputs": [], "execution_count": None}
        else:
            cell["source"] = [OF_A_NOTEBOOK.sub(pages, line) for line in cell["source"]]
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"
