"""The stage's opening as a film of some five seconds, light and dark, and its picture: ``make pictures TASKS=stage``.

The picture that a saved notebook keeps of the stage is made from it, too.

A browser draws the page, whose clock moves only from picture to picture: so the film is the same on any machine.
"""

import io
import shutil
import tempfile
from pathlib import Path

from PIL import Image

import rlrobot_edu as rl
from rlrobot_edu.files import write_whole
from rlrobot_edu.show.images import (
    few_colours,
    image_of,
    in_few_colours,
    png_of,
    reduced,
)

OPENING = Path(rl.__file__).parent / "widgets/stage/opening.png"
WIDE, HIGH = 1000, 530  # of the page [px]
SMALL = (720, 382)  # of the film [px]
START = 600_000  # when the clock stops [ms]
COLOURS = 48
ARROW = 40  # the picture in which the arrow is there, and the step not yet taken
SEEN = (15, 33, -1)  # pictures in which all colours occur
# Buttons and small print are no part of a film, and nothing may move by a clock of its own
QUIET = """#keys, #lot, #who, #honest, details { display: none !important }
* { transition: none !important }"""
# How many pictures, and what passes on the page before each [ms]: the race, and the question with its answer
PARTS = ((16, 370), (34, 200))
SHOWN, AT_LAST = 100, 2500  # how long a picture is shown, and the last one [ms]


def film_of_stage(folder: Path) -> None:
    """Write stage.gif, stage_dark.gif and stage.png. Needs playwright and Chromium."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as home, sync_playwright() as p:
        file = Path(home) / "stage.html"
        rl.stage(file)
        browser = p.chromium.launch(
            executable_path=shutil.which("chromium"),
            args=["--no-sandbox", "--disable-gpu"],
        )
        for name, scheme in (("stage", "light"), ("stage_dark", "dark")):
            page = browser.new_page(
                viewport={"width": WIDE, "height": HIGH}, color_scheme=scheme
            )
            pictures = pictures_of(page, file.as_uri())
            if scheme == "light":
                write_whole(folder / "stage.png", png_of(pictures[ARROW]))
                kept = in_few_colours(pictures[ARROW].resize(SMALL), COLOURS)
                write_whole(OPENING, png_of(kept))
            small = [picture.resize(SMALL) for picture in pictures]
            times = [SHOWN] * (len(small) - 1) + [AT_LAST]
            write_whole(folder / f"{name}.gif", gif_of(small, times))
            print(f"{name}.gif: {page.inner_text('#said')}", flush=True)
        browser.close()


def pictures_of(page, address: str) -> list:
    """The opening, picture by picture."""
    page.clock.install(time=0)
    page.goto(address)
    page.add_style_tag(content=QUIET)
    page.clock.pause_at(START)
    page.evaluate("size(); race(RACE_MS)")
    pictures = []
    for n, passes in PARTS:
        for _ in range(n):
            page.clock.run_for(passes)
            pictures.append(image_of(page.screenshot()))
    return pictures


def gif_of(images: list, times: list[int]) -> bytes:
    """The film. Flat areas keep their colours; ribbons and crosses, which are small, get their own."""
    seen = Image.new("RGB", (SMALL[0], SMALL[1] * len(SEEN)))
    for i, n in enumerate(SEEN):
        seen.paste(images[n], (0, i * SMALL[1]))
    rare = seen.quantize(COLOURS, Image.Quantize.MAXCOVERAGE).getpalette()
    colours = few_colours(images, COLOURS)
    for i in range(0, 3 * COLOURS, 3):
        colours.append(tuple(rare[i : i + 3]))
    first, *rest = (reduced(image, colours) for image in images)
    file = io.BytesIO()
    first.save(file, "GIF", save_all=True, append_images=rest, loop=0, duration=times)
    return file.getvalue()
