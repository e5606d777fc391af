"""Run notebooks from top to bottom and keep their outputs: ``python notebooks/run_all.py [notebooks/02….ipynb …]``.

Without names, all lessons and all assignments.

Widgets stay out of the files: without a kernel, JupyterLab would say "model not found" in place of the still that
stands beside each. The metadata of an output says that a widget was there. The pages of 3D views stay out, too: a
notebook keeps the still picture or GIF beside them. So do progress bars, which would be different every time.
"""

import os
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from rlrobot_course.authoring.lists import lessons

ROOT = Path(__file__).parents[1]
WIDGET = "application/vnd.jupyter.widget-view+json"


def run(path: Path) -> None:
    """Run one notebook in place."""
    notebook = nbformat.read(path, as_version=4)
    client = NotebookClient(
        notebook,
        kernel_name="python3",
        resources={"metadata": {"path": str(path.parent)}},
        store_widget_state=False,
        coalesce_streams=True,
    )
    os.environ.update(RLROBOT_EDU_PROGRESS="0")
    begin = time.perf_counter()
    client.execute()
    seconds = 10 * round((time.perf_counter() - begin) / 10)
    for cell in notebook.cells:
        cell.metadata.pop(
            "execution", None
        )  # clock times, which would change at every run
    keep_stills(notebook)
    notebook.metadata = {
        "kernelspec": {
            "display_name": "Python 3",
            "language": "python",
            "name": "python3",
        },
        "language_info": {"name": "python"},
        # what the author says of the lesson, and the seconds, which a test compares with what the text says of a wait
        "rlrobot_edu": {**notebook.metadata.get("rlrobot_edu", {}), "seconds": seconds},
    }
    nbformat.write(notebook, path)


def keep_stills(notebook: nbformat.NotebookNode) -> None:
    """Take the widgets, which live no longer than their kernel, out of the outputs; their stills remain."""
    for output in (
        output for cell in notebook.cells for output in cell.get("outputs", [])
    ):
        if output.get("data", {}).pop(WIDGET, None):
            output.metadata["rlrobot_edu"] = {"widget": True}


if __name__ == "__main__":
    given = [Path(name).resolve() for name in sys.argv[1:]]
    for path in given or [
        *lessons(ROOT).values(),
        *sorted(ROOT.glob("notebooks/homework/*.ipynb")),
    ]:
        run(path)
        print(path.name)
