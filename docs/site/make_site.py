"""Build the documentation site from the committed notebooks and pages: `make docs`. Nothing is fetched, and of the
notebooks nothing is run but what lives on their pages (steppers, the bias explorer, 3D replays) and the cells that
these need; all must come to what is committed.

Sphinx wants all pages below one folder, and the notebooks link to their neighbours as they lie in the repository. So
docs/_build/source is a copy of what the site shows, in the repository's own order; the pages of the API are written
into it. The site is docs/_build/html.
"""

import os
import shutil
import sys
from pathlib import Path

from api_pages import write_api
from folded import fold
from front_page import take_light_picture, write_pages
from launch import SOURCE, add_buttons, in_colab, write_colab
from lesson_cards import write_cards
from live_pages import enliven
from stepper_pages import write_steppers

from rlrobot_course.authoring.lists import lessons

DOCS = Path(__file__).parents[1]
ROOT = DOCS.parent
LITE = (
    ROOT / "docs/lite/_build/site"
)  # the course in the browser, if `make lite` has built it
SHOWN = [
    "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md", "CITATION.cff", "LICENSE*",
    "constraints.txt", "tosl.py",
    "studies/benchmarks/README.md", "notebooks/*.ipynb", "notebooks/more/*.ipynb", "notebooks/homework/*.ipynb",
    "docs/*.md", "docs/howto/*.md", "docs/studies/*.md", "docs/pictures/*", "docs/reproduction/*",
    "studies/**/*", "tasks/*", "datasets/**/*", "rlrobot_*/**/*.py", "tests/**/*.py", "docs/lite/*.toml",
]  # fmt: skip
CARD = "docs/card.png"  # what a shared link shows, of a page without a picture
# Where the site stands, with a / at its end. Who shows a shared link needs the whole address of its picture
ADDRESS = os.environ.get("SITE_ADDRESS", "")
NO_PAGES = "_template.md"
ABOUT = (
    "Learn tabular reinforcement learning on simulated robots, in Jupyter notebooks."
)
TO_THE_SITE = f"""<!doctype html>
<html lang="en"><meta charset="utf-8"><title>RLROBOT-EDU</title><link rel="icon" href="_static/favicon.svg">
<meta name="description" content="{ABOUT}"><meta property="og:type" content="website">
<meta property="og:title" content="RLROBOT-EDU"><meta property="og:description" content="{ABOUT}">
<meta http-equiv="refresh" content="0; url=docs/index.html"><a href="docs/index.html">RLROBOT-EDU</a></html>
"""


def write_source(source: Path) -> None:
    """Everything that Sphinx reads. Old copies are removed; new ones keep their time, so Sphinx reads only changes."""
    shutil.rmtree(source, ignore_errors=True)
    for pattern in SHOWN:
        for path in ROOT.glob(pattern):
            if path.is_file() and not path.name.endswith(NO_PAGES):
                copy = source / path.relative_to(ROOT)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, copy)
    root = source / "to_the_root"
    root.mkdir()
    (root / "index.html").write_text(TO_THE_SITE, encoding="utf-8")
    write_api(source / "docs/api")
    write_steppers(source / "docs", root / "docs")
    write_pages(source / "docs/index.md", root / "docs")
    take_light_picture(source / "README.md")
    write_cards(source, root / "docs")
    for notebook in lessons(source).values():
        name = notebook.relative_to(source)
        enliven(notebook, root / name.parent)
        fold(notebook)
        colab = in_colab(name.as_posix(), SOURCE)
        add_buttons(notebook, LITE, colab)
        if colab:
            write_colab(name.as_posix(), root / "colab", SOURCE)
    shutil.copy2(ROOT / "docs/pictures/stage.png", root / CARD)
    for page in root.rglob("*.html"):
        show_when_shared(page, page.relative_to(root))


def show_when_shared(page: Path, name: Path) -> None:
    """Add the project's picture to the card of a page that Sphinx does not make. name: the page's path in the site"""
    here = "../" * (len(name.parts) - 1)
    picture = f'<meta property="og:image" content="{ADDRESS or here}{CARD}">'
    text = page.read_text(encoding="utf-8")
    page.write_text(
        text.replace(
            '<meta property="og:title"', f'{picture}<meta property="og:title"', 1
        ),
        encoding="utf-8",
    )


def main() -> int:
    """Sphinx's exit code: not 0 if there was a warning."""
    from sphinx.cmd.build import build_main

    build = Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "_build"
    source = build / "source"
    write_source(source)
    options = ["-q", "-W", "--keep-going", "-j", "auto", "-b", "html", "-c", str(DOCS)]
    options += [
        "-D",
        f"html_extra_path={source / 'to_the_root'}",
        "-d",
        str(build / "doctrees"),
    ]
    failed = build_main([*options, str(source), str(build / "html")])
    if (
        LITE.is_dir() and not failed
    ):  # afterwards: to Sphinx its notebooks would be pages
        shutil.rmtree(build / "html/lite", ignore_errors=True)
        shutil.copytree(LITE, build / "html/lite")
    return failed


if __name__ == "__main__":
    sys.exit(main())
