"""Slides: what of a lesson is shown, and what is only said."""

from pathlib import Path

import nbformat
import pytest
from make_slides import headline, is_short, slides_of, tables

ROOT = Path(__file__).parents[2]


def test_a_section_is_its_heading_first_sentence_and_formulas():
    text = "## 3. Where nothing follows\n\nAn episode ends. Then more.\n\n$$r + 1$$\n\nAnd the rest."
    assert (
        headline(text) == "## 3. Where nothing follows\n\nAn episode ends.\n\n$$r + 1$$"
    )
    assert (
        headline("## A table\n\n| a |") == "## A table"
        and headline("Only words.") == ""
    )
    assert headline("### Exercise: `target`\n\nReturn it.") == ""


def test_a_table_is_a_slide_with_the_words_that_lead_to_it():
    text = "## 2. By hand\n\nFirst this. Now the means:\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\nAfter it."
    assert tables(text) == ["Now the means:\n\n| a | b |\n|---|---|\n| 1 | 2 |"]
    assert tables("No table. | none |") == [] and tables(
        "It is so.\n\n| a |\n|---|"
    ) == ["| a |\n|---|"]


@pytest.mark.parametrize(("output", "shown"), [
    ({"name": "stdout", "text": "state 21  Q = (0, 0, 0)\n"}, True), ({"name": "stdout", "text": "1\n" * 9}, False),
    ({"name": "stdout", "text": "given: update (yours comes here …)\n"}, False),
    ({"name": "stderr", "text": "x"}, False),
])  # fmt: skip
def test_a_few_printed_lines_are_shown(output, shown):
    assert is_short(output) == shown


def test_slides_have_all_sections_and_pictures_of_a_lesson_and_no_exercise():
    notebook = nbformat.read(ROOT / "notebooks" / "03_q_learning.ipynb", as_version=4)
    sections = sum(
        cell.source.startswith(("# ", "## "))
        for cell in notebook.cells
        if cell.cell_type == "markdown"
    )
    pictures = [
        cell for cell in notebook.cells if "image/png" in str(cell.get("outputs"))
    ]
    shown = slides_of(notebook).cells
    kinds = [cell.metadata.slideshow.slide_type for cell in shown]
    assert kinds.count("slide") == sections and kinds.count("subslide") >= max(
        8, len(pictures)
    )
    assert not any(
        "check." in cell.source for cell in shown if cell.cell_type == "code"
    )
