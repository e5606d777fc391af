"""Buttons above a lesson: run it in the browser, or in Colab, which opens its own copy from the site's `colab/`."""

import html
import json
import posixpath
import re
import tomllib
from pathlib import Path
from urllib.parse import quote

import rlrobot_edu as rl
from rlrobot_course.learner.my_course import blank

ROOT = Path(__file__).parents[2]
SOURCE = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))[
    "project"
]["urls"].get("Source", "")
IN_BROWSER = "../lite/index.html?path={name}"
GITHUB, COLAB = "https://github.com/", "https://colab.research.google.com/github/"
LINK = re.compile(r"\]\((?!https?:|#|attachment:)([^)]+)\)")
FIRST_CELL = f"""\
# Run this cell first. What you write is kept in your Google Drive, in the folder my_course.
%pip install --quiet "rlrobot-edu[notebook,arm]=={rl.__version__}"
from google.colab import drive, output
output.enable_custom_widget_manager()
drive.mount("/content/drive")  # without it and the two lines below, my_functions.py is lost when Colab stops
%mkdir -p /content/drive/MyDrive/my_course
%cd /content/drive/MyDrive/my_course"""


def in_colab(notebook: str, source: str) -> str:
    """Where Colab opens a notebook of the site's branch, `gh-pages`; empty if the repository is not on GitHub."""
    home = source.replace(GITHUB, COLAB)
    return (
        f"{home}/blob/gh-pages/colab/{quote(notebook)}"
        if source.startswith(GITHUB)
        else ""
    )


def write_colab(notebook: str, folder: Path, source: str = SOURCE) -> None:
    """Write the copy of a notebook that can start in Colab: its first cell installs the toolkit.

    notebook: its path in the repository; folder: the site's for such copies
    source: the address of the repository, from pyproject.toml
    """

    def whole(link: re.Match[str]) -> str:
        path = posixpath.normpath(posixpath.join(posixpath.dirname(notebook), link[1]))
        return f"]({in_colab(path, source) if path.endswith('.ipynb') else f'{source}/blob/v{rl.__version__}/{path}'})"

    content = blank(ROOT / notebook)
    for cell in content["cells"]:
        if cell["cell_type"] == "markdown":
            cell["source"] = [LINK.sub(whole, line) for line in cell["source"]]
    first = {
        "cell_type": "code",
        "id": "colab",
        "metadata": {},
        "outputs": [],
        "execution_count": None,
    }
    content["cells"].insert(0, first | {"source": FIRST_CELL})
    (folder / notebook).parent.mkdir(parents=True, exist_ok=True)
    (folder / notebook).write_text(json.dumps(content), encoding="utf-8")


def add_buttons(notebook: Path, lite: Path, colab: str) -> None:
    """Put the buttons under the title of a copy of a lesson.

    lite: the folder of JupyterLite's site, which need not be there; colab: where Colab opens it, empty if nowhere
    """
    runs = (lite / "files" / notebook.name).is_file()
    links = {
        "Run in your browser": IN_BROWSER.format(name=quote(notebook.name))
        if runs
        else "",
        "Open in Colab": colab,
    }
    buttons = [
        f'<a class="launch" href="{html.escape(url)}">{label}</a>'
        for label, url in links.items()
        if url
    ]
    if buttons:
        content = json.loads(notebook.read_text(encoding="utf-8"))
        cell = {
            "cell_type": "markdown",
            "id": "launch",
            "metadata": {},
            "source": f"<p>{' '.join(buttons)}</p>",
        }
        content["cells"].insert(1, cell)
        notebook.write_text(json.dumps(content), encoding="utf-8")
