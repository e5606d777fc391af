"""Given code is folded on the site as it is in JupyterLab: its first line, a comment, says what it does."""

import json
from pathlib import Path
from typing import Any


def fold(notebook: Path) -> None:
    """Fold the cells of a copy of a lesson that JupyterLab folds, each below its first line."""
    content = json.loads(notebook.read_text(encoding="utf-8"))
    cells = [cell for cell in content["cells"] if is_folded(cell)]
    for cell in cells:
        line = cell["source"][0].removeprefix("# ").strip()
        cell["metadata"].setdefault("tags", []).append("hide-input")
        cell["metadata"]["mystnb"] = {
            "code_prompt_show": line,
            "code_prompt_hide": line,
        }
    if cells:  # a file that is as before keeps its time: Sphinx need not read it again
        notebook.write_text(json.dumps(content), encoding="utf-8")


def is_folded(cell: dict[str, Any]) -> bool:
    """Whether JupyterLab shows only the first line of a cell."""
    return bool(cell["metadata"].get("jupyter", {}).get("source_hidden"))
