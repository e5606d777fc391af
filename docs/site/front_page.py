"""The front page of the site: where GitHub shows a film, a robot learns."""

import re
from pathlib import Path

import rlrobot_edu as rl

FILM = re.compile(r"^!\[.*\]\(pictures/wander_1k\.gif\)$", re.MULTILINE)
FRAME = """<iframe class="live playground" src="a_robot_learns.html" title="A robot learns, while you watch"></iframe>
<p><a href="a_robot_learns.html">The playground on a page of its own</a>: one file, which works without a network.</p>

<noscript>

{film}

</noscript>"""


def write_playground(index: Path, extra: Path) -> None:
    """Put the playground in the place of the film on the front page; without scripts the film stays.

    index: the site's copy of the page; extra: the folder that gets the playground. Raises ValueError without a film.
    """
    extra.mkdir(parents=True, exist_ok=True)
    rl.playground(extra / "a_robot_learns.html")
    text, n = FILM.subn(
        lambda film: FRAME.format(film=film[0]), index.read_text(encoding="utf-8")
    )
    if n != 1:
        raise ValueError(
            f"{index}: there are {n} films on the front page, and one is to be replaced"
        )
    index.write_text(text, encoding="utf-8")
