"""The front page of the site: where GitHub shows a film, a robot asks."""

import re
from pathlib import Path

import rlrobot_edu as rl

FILM = re.compile(r"^!\[.*\]\(pictures/stage\.gif\)$", re.MULTILINE)
FRAME = """<iframe class="live stage" src="who_does_it_ask.html" title="A robot asks its own memories"></iframe>
<p><a href="who_does_it_ask.html">The stage on a page of its own</a>, and
<a href="a_robot_learns.html">the playground</a>, in which a robot learns:
each is one file, which works without a network.</p>

<noscript>

{film}

</noscript>"""
# GitHub shows the one that fits its own colours, light or dark
BOTH = re.compile(
    r'<picture>.*?<img alt="([^"]*)" src="([^"]*)">\s*</picture>', re.DOTALL
)


def write_pages(index: Path, extra: Path) -> None:
    """Write stage and playground, and put the stage in the place of the film on the front page.

    Without scripts the film stays. index: the site's copy of the page; extra: the folder that gets the pages. Raises
    ValueError without a film.
    """
    extra.mkdir(parents=True, exist_ok=True)
    rl.stage(extra / "who_does_it_ask.html")
    rl.playground(extra / "a_robot_learns.html")
    text, n = FILM.subn(
        lambda film: FRAME.format(film=film[0]), index.read_text(encoding="utf-8")
    )
    if n != 1:
        raise ValueError(
            f"{index}: there are {n} films on the front page, and one is to be replaced"
        )
    index.write_text(text, encoding="utf-8")


def take_light_picture(readme: Path) -> None:
    """Of a film in two colours the site takes the light one, since Sphinx knows no other way to write a picture.

    readme: the site's copy of README.md
    """
    text = readme.read_text(encoding="utf-8")
    readme.write_text(BOTH.sub(r"![\1](\2)", text), encoding="utf-8")
