"""Buttons above a lesson: run it in the browser, or on a machine of Colab, Binder or GitHub, where there is a way."""

import html
import json
import os
from pathlib import Path
from urllib.parse import quote

# Colab, Binder and Codespaces fetch a repository: REPOSITORY=owner/name make docs, once the project has a home
REPOSITORY = os.environ.get("REPOSITORY", "")
HOSTED = {
    "Open in Colab": "https://colab.research.google.com/github/{repository}/blob/main/notebooks/{name}",
    "Open in Binder": "https://mybinder.org/v2/gh/{repository}/main?labpath=notebooks%2F{name}",
    "Open in Codespaces": "https://codespaces.new/{repository}",
}
IN_BROWSER = "../lite/index.html?path={name}"


def ways(name: str, in_browser: bool, repository: str) -> dict[str, str]:
    """What the buttons say, and where they lead.

    name: of a notebook's file
    in_browser: whether the site carries this lesson for the browser, as `make lite` builds it
    repository: ``owner/name`` on GitHub, empty if there is none
    """
    templates = {"Run in your browser": IN_BROWSER} if in_browser else {}
    templates |= HOSTED if repository else {}
    return {label: url.format(name=quote(name), repository=repository) for label, url in templates.items()}


def add_buttons(notebook: Path, lite: Path, repository: str = REPOSITORY) -> None:
    """Put the buttons under the title of a copy of a lesson.

    lite: the folder of JupyterLite's site, which need not be there
    """
    links = ways(notebook.name, (lite / "files" / notebook.name).is_file(), repository)
    if not links:
        return
    buttons = (f'<a class="launch" href="{html.escape(url)}">{label}</a>' for label, url in links.items())
    content = json.loads(notebook.read_text(encoding="utf-8"))
    cell = {"cell_type": "markdown", "id": "launch", "metadata": {}, "source": f"<p>{' '.join(buttons)}</p>"}
    content["cells"].insert(1, cell)
    notebook.write_text(json.dumps(content), encoding="utf-8")
