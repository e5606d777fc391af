"""The parts of lessons that work without a kernel: steppers, bias explorers and 3D replays, as `save` writes them."""

import ast
import contextlib
import html
import io
import json
import re
from pathlib import Path
from typing import Any, NamedTuple

from cell_names import needed_by

MORE = 20  # steps of a stepper after the one that a lesson shows


class Kind(NamedTuple):
    """What a cell shows: how its text begins, the folder of its pages, and what it is called."""

    text: str
    folder: str
    name: str


KINDS = (
    Kind("<Stepper at step", "steppers", "stepper"),
    Kind("<BiasExplorer of", "explorers", "bias explorer"),
    Kind("Replay of", "replays", "replay in 3D"),
    Kind("<Playground", "playgrounds", "playground"),
    Kind("<Stage", "stages", "stage"),
    Kind("<Handle", "handles", "picture that can be moved"),
)


def enliven(notebook: Path, extra: Path) -> None:
    """Replace each still twin in a copy of a lesson by its interactive page; without scripts the twin remains.

    extra: the folder that gets the pages. Raises ValueError if something is not as the notebook has kept it.
    """
    content, lesson = json.loads(notebook.read_text(encoding="utf-8")), notebook.stem
    cells = [cell for cell in content["cells"] if cell["cell_type"] == "code"]
    sources = ["".join(cell["source"]) for cell in cells]
    lives = False
    for i, cell in enumerate(cells):
        if "still" in cell["metadata"].get("tags", []):
            continue  # what it shows hangs on files that other cells have changed
        for data in (output["data"] for output in cell["outputs"] if "data" in output):
            kept = "".join(data.get("text/plain", ""))
            for kind in KINDS:
                if kept.startswith(kind.text):
                    shown = shown_by(
                        sources[i], needed_by(sources[i], sources[:i]), lesson
                    )
                    if repr(shown) != kept:
                        raise ValueError(
                            f"{lesson}: its {kind.name} is kept as {kept}, but is {shown!r}"
                        )
                    page = f"{kind.folder}/{lesson}_{i}.html"
                    (extra / page).parent.mkdir(parents=True, exist_ok=True)
                    shown.save(
                        extra / page,
                        *([shown.t + MORE] if kind.folder == "steppers" else []),
                    )
                    data["text/html"] = frame_of(page, kind, "".join(data["text/html"]))
                    lives = True
    if lives:  # a file that is as before keeps its time: Sphinx need not read it again
        notebook.write_text(json.dumps(content), encoding="utf-8")


def shown_by(source: str, before: list[str], lesson: str) -> Any:
    """The value of the last line of a cell that is run after the cells `before` it."""
    names: dict[str, Any] = {}
    *lines, last = ast.parse("\n".join([*before, source])).body
    assert isinstance(last, ast.Expr)
    with contextlib.redirect_stdout(io.StringIO()):
        exec(compile(ast.Module(lines, []), lesson, "exec"), names)
        return eval(compile(ast.Expression(last.value), lesson, "eval"), names)


def frame_of(page: str, kind: Kind, still: str) -> str:
    """A page in a frame, in the place of its still twin."""
    alt = re.search(
        r'alt="([^"]*)"', still
    )  # without a picture its name says what there is
    title = html.escape(
        f"A {kind.name}. " + (html.unescape(alt[1]) if alt else "")
    ).strip()
    return (
        f'<iframe class="live {kind.folder}" src="{page}" title="{title}" loading="lazy"></iframe>'
        f'<p><a href="{page}">The {kind.name} on a page of its own</a></p><noscript>{still}</noscript>'
    )
