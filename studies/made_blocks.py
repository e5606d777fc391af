"""Blocks of a page that a command writes; people write the rest of it."""

import re
from collections.abc import Mapping

BLOCK = re.compile(r"<!-- made: (.+?) -->\n.*?<!-- end -->", re.S)


def block(name: str, content: str) -> str:
    """A block of a page; what stands between its marks is written anew each time."""
    return f"<!-- made: {name} -->\n\n{content}\n\n<!-- end -->"


def filled(page: str, made: Mapping[str, str]) -> str:
    """The page with what was made in its blocks; a block of which nothing was made stays as it is."""
    return BLOCK.sub(
        lambda found: block(found[1], made[found[1]]) if found[1] in made else found[0],
        page,
    )
