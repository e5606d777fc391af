"""Slides of each lesson from its committed notebook: `make slides [LESSON=02]` writes docs/_build/slides/02_….html.

A section's heading, its first sentence and its formulas are a slide. Below it come, a slide each, its tables, its
pictures, the few lines that a cell prints, and its questions before a run. The whole text is in the speaker's notes
(key S). Code and exercises stay in the notebook. The slides are Jupyter's, of reveal.js, which comes from the network
when they are shown.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import nbformat
from nbconvert import SlidesExporter

from rlrobot_course.authoring.lists import lessons

ROOT = Path(__file__).parents[2]
TO = ROOT / "docs" / "_build" / "slides"
LINES = 8  # that are printed and can be read from the last row
PICTURE = re.compile(r"<img|<svg|<figure|<b>Predict|role=\"radiogroup\"", re.IGNORECASE)


def slides_of(notebook: Any) -> Any:
    """The notebook with the cells that are shown, each marked as what it is among slides."""
    shown = []
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            if text := headline(cell.source):
                shown.append(marked(nbformat.v4.new_markdown_cell(text), "slide"))
            shown += [
                marked(nbformat.v4.new_markdown_cell(table), "subslide")
                for table in tables(cell.source)
            ]
            shown.append(marked(nbformat.v4.new_markdown_cell(cell.source), "notes"))
        elif not {"exercise", "challenge"} & set(cell.metadata.get("tags", [])):
            cell.outputs = [
                output
                for output in cell.get("outputs", ())
                if is_picture(output) or is_short(output)
            ]
            if cell.outputs:
                shown.append(marked(cell, "subslide"))
    notebook.cells = shown
    return notebook


def headline(text: str) -> str:
    """What of a section's text is on its slide: heading, first sentence, formulas; empty if no section begins in it."""
    heading = re.match(r"#{1,2} .*", text)
    if heading is None:
        return ""
    formulas = re.findall(r"\$\$.*?\$\$", text, re.DOTALL)
    rest = re.sub(r"\$\$.*?\$\$", "", text[heading.end() :], flags=re.DOTALL).strip()
    paragraph = (
        "" if rest.startswith(("#", "|", "-", "1.")) else rest.partition("\n\n")[0]
    )
    first = re.match(r"(?:.|\n)*?[.:?!](?=\s|$)", paragraph)
    return "\n\n".join([heading[0], first[0] if first else "", *formulas]).strip()


def tables(text: str) -> list[str]:
    """The tables of a text, each with the sentence that leads to it."""
    parts = text.split("\n\n")
    leads = [re.split(r"(?<=[.?!]) ", part.strip())[-1] for part in ["", *parts]]
    found = [
        (lead, part)
        for lead, part in zip(leads, parts, strict=False)
        if part.startswith("|")
    ]
    return [
        f"{lead if lead.endswith(':') else ''}\n\n{table}".strip()
        for lead, table in found
    ]


def is_short(output: Any) -> bool:
    """Whether an output is a few printed lines, and none that say whose functions are used."""
    text = output.get("text", "") if output.get("name") == "stdout" else ""
    return 0 < len(text.splitlines()) <= LINES and not text.startswith(
        ("given:", "yours:")
    )


def is_picture(output: Any) -> bool:
    """Whether an output is a picture, or a question that a class can vote on."""
    data = output.get("data", {})
    return any(kind.startswith("image/") for kind in data) or bool(
        PICTURE.search("".join(data.get("text/html", "")))
    )


def marked(cell: Any, kind: str) -> Any:
    """A cell with its kind of slide."""
    cell.metadata["slideshow"] = {"slide_type": kind}
    return cell


def main() -> None:
    """Write the slides of the lessons named, or of all."""
    TO.mkdir(parents=True, exist_ok=True)
    exporter = SlidesExporter(
        exclude_input=True, exclude_input_prompt=True, exclude_output_prompt=True
    )
    for path in lessons(ROOT).values():
        if not sys.argv[1:] or path.name.partition("_")[0] in sys.argv[1:]:
            page, _ = exporter.from_notebook_node(
                slides_of(nbformat.read(path, as_version=4))
            )
            (TO / f"{path.stem}.html").write_text(page, encoding="utf-8")
            print(TO / f"{path.stem}.html")


if __name__ == "__main__":
    main()
