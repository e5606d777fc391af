"""The site's list of lessons: a card for each, with its first picture, its minutes and what the learner writes."""

import base64
import html
import io
import json
import re
from pathlib import Path
from typing import NamedTuple

from PIL import Image

from rlrobot_course.authoring.lists import Lesson, facts

LISTS = re.compile(
    r"```\{toctree\}\n:glob:\n:maxdepth: 1\n\n\.\./notebooks/(more/)?\*\n```"
)
# A picture in the kept output of a cell
KEPT = re.compile(
    r'<img alt="(?P<alt>[^"]*)"[^>]*src="data:image/\w+;base64,(?P<data>[^"]+)"'
)
SIZE = 480, 320  # pixels of a card's picture, at most
COLOURS = 64


class Seen(NamedTuple):
    """A picture and its sentence."""

    alt: str
    png: bytes


def first_picture(notebook: Path) -> Seen:
    """The first picture that a notebook has kept, small; of a film its last frame. Raises ValueError without one."""
    content = json.loads(notebook.read_text(encoding="utf-8"))
    for cell in content["cells"]:
        for output in cell.get("outputs", []):
            kept = "".join(output.get("data", {}).get("text/html", ""))
            found = KEPT.search(kept)
            if found:
                return Seen(html.unescape(found["alt"]), _small(found["data"]))
    raise ValueError(f"{notebook.name} has kept no picture for its card")


def _small(data: str) -> bytes:
    kept = Image.open(io.BytesIO(base64.b64decode(data)))
    kept.seek(getattr(kept, "n_frames", 1) - 1)
    picture = kept.convert("RGB")
    picture.thumbnail(SIZE, Image.Resampling.LANCZOS)
    png = io.BytesIO()
    picture.quantize(COLOURS).save(png, "png", optimize=True)
    return png.getvalue()


def write_cards(source: Path, extra: Path) -> None:
    """Put cards in the place of both lists of lessons; the lists remain, hidden, for the sidebar.

    source: the site's copy of the project; extra: the folder of the site's docs, which gets the pictures
    Raises ValueError if the page has other lists, or a lesson has no picture.
    """
    (extra / "cards").mkdir(parents=True, exist_ok=True)
    cards: dict[bool, list[str]] = {False: [], True: []}
    for number, lesson in facts(source).items():
        seen = first_picture(lesson.path)
        (extra / f"cards/{number}.png").write_bytes(seen.png)
        cards[lesson.is_optional].append(card(number, lesson, seen.alt, source))

    def with_cards(found: re.Match[str]) -> str:
        hidden = found[0].replace(":maxdepth: 1", ":hidden:")
        its = "\n".join(cards[found[1] is not None])
        return f'{hidden}\n\n<div class="cards">\n{its}\n</div>'

    page = source / "docs/lessons.md"
    text = page.read_text(encoding="utf-8")
    text = re.sub(r"^\|.*\n", "", text, flags=re.M)  # cards say what the table says
    text, n = LISTS.subn(with_cards, text)
    if n != len(cards):
        raise ValueError(f"{page}: it has {n} lists of lessons, and not {len(cards)}")
    page.write_text(text, encoding="utf-8")


def card(number: str, lesson: Lesson, alt: str, source: Path) -> str:
    """A lesson in a list, in HTML: all of it is one link."""
    page = lesson.path.relative_to(source).with_suffix(".html").as_posix()
    writes = re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(lesson.writes))
    return (
        f'<a class="card" href="../{page}"><img src="cards/{number}.png" alt="{html.escape(alt)}" loading="lazy">'
        f"<strong>{number} {html.escape(lesson.title)}</strong>"
        f"<span>{lesson.minutes} minutes. You write: {writes}</span></a>"
    )
