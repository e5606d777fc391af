"""A table of the library for a page in Markdown; the pages of the studies are made of them."""

import re

from rlrobot_edu.experiments.tables import Table

# what Markdown takes for a sign of its own, but for the underscore inside a word such as wander_1k
SIGNS = re.compile(r"[\\`*|~$&]|<(?=[A-Za-z/!?])|(?<=\])\(|(?<![^\W_])_|_(?![^\W_])")


def in_markdown(table: Table) -> str:
    """The caption in bold, an empty line, and the rows; any text reads as it stands."""
    flush, lines = table.lines(_escaped)
    lines.insert(1, ["---:" if sign == ">" else ":---" for sign in flush])
    rows = (f"| {' | '.join(line)} |" for line in lines)
    return "\n".join([f"**{_escaped(table.caption)}**", "", *rows])


def _escaped(text: str) -> str:
    return SIGNS.sub(r"\\\g<0>", " ".join(text.splitlines())).strip()
