"""Phrases that make a reader stop are rare in docs, notebooks and docstrings, and become rarer."""

import ast
import json
import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGES = (
    "*.md",
    "docs/*.md",
    "docs/howto/*.md",
    "docs/reproduction/*.md",
    "rlrobot_course/*/*.md",
)
NOTEBOOKS = (
    "notebooks/*.ipynb",
    "notebooks/more/*.ipynb",
    "notebooks/homework/*.ipynb",
)
MOST = {  # how often each may occur: lower a number when you have mended a phrase, never raise it
    r"(is|are|was|were) told": 13,
    r"(to be (seen|had|told)|cannot be told)": 2,
    r"beside ([−\d]|[A-Z]|ours|your own|the paper)": 28,  # "6.68 beside 5.52": compared with
    r"what there is": 0,
    r"(is|are) (not|nowhere) shown": 17,
    r"rooms? of (the )?(lesson|course|library)": 0,
    r"Who \w+s [^.?!]*\.": 0,  # a sentence without a head: "Who acts by Q goes another way."
    r"(What|Where|Why|How|Whether) [^,.?!]*, (is|are) (told|said|shown)": 0,
    r"\([A-Z][^()]*[.!]\)": 60,  # a sentence in brackets
}  # fmt: skip


def prose() -> str:
    """All sentences that people read here, without code."""
    pages = [
        path
        for where in PAGES
        for path in ROOT.glob(where)
        if path.name != "CHANGELOG.md"
    ]
    texts = [page.read_text(encoding="utf-8") for page in pages]
    for notebook in (path for where in NOTEBOOKS for path in ROOT.glob(where)):
        cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
        texts += [
            "".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"
        ]
    for folder in ("rlrobot_edu", "rlrobot_course", "tasks"):
        for file in (ROOT / folder).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                if isinstance(
                    node,
                    ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef,
                ):
                    texts.append(ast.get_docstring(node) or "")
    return "\n".join(
        " ".join(re.sub(r"(?s)```.*?```|`[^`\n]*`", "", text).split()) for text in texts
    )


def test_a_phrase_that_stops_the_reader_becomes_rarer():
    text = prose()
    counted = {phrase: len(re.findall(rf"(?<!\w){phrase}", text)) for phrase in MOST}
    assert {phrase: n for phrase, n in counted.items() if n > MOST[phrase]} == {}
