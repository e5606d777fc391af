"""The rows of a recording: which numbers they may hold, and their text, which a spreadsheet can read."""

import re
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.source import Source

NAMES = (
    "episode",
    "step",
    "s",
    "a",
    "r",
    "s_next",
    "terminated",
)  # columns of the CSV file
HEADER = ",".join(NAMES)
_NUMBER = r"[-+]?(?:nan|inf|\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)"  # one way to match any text, so no search
ROW = re.compile(
    rf"{_NUMBER}(?:,{_NUMBER}){{{len(NAMES) - 1}}}", re.ASCII
)  # such as 0,12,5,1,-0.02,4,0
REMEDY = "put back the original file, or record again"
CHANGED = f"a spreadsheet may have saved it with its own separators, commas, quotes or columns; {REMEDY}"


def check_rows(
    columns: Mapping[str, NDArray[Any]],
    source: Source,
    where: Callable[[int], str],
    remedy: str = REMEDY,
) -> None:
    """Raises ValueError for the first row of `columns`, arrays (n,) by name, that `source` does not allow.

    where: what a message calls the row of this number
    """
    n_states, n_actions = source.states.n, source.actions.n
    sizes = {
        "s": n_states,
        "a": n_actions,
        "s_next": n_states,
        "terminated": 2,
        "truncated": 2,
    }
    for name, column in columns.items():
        if name == "r":
            good = np.isin(column, source.rewards)
            expected = f"one of the rewards {list(source.rewards)!s:.200}"
        else:
            size = sizes.get(name, 2**53)  # up to here a float holds every whole number
            good = (column == np.floor(column)) & (column >= 0) & (column < size)
            expected = "a whole number from 0" + (
                f" to {size - 1}" if name in sizes else " on"
            )
        if not good.all():
            row = int(np.argmin(good))
            found = repr(column[row].item()).removesuffix(".0")
            raise ValueError(
                f"{where(row)}: {name} is {found}, expected {expected}; {remedy}"
            )


def count_episodes(
    transitions: Transitions,
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Number of each row's episode, and of the step in it, arrays (n,); both count from 0."""
    ended = (transitions.terminated | transitions.truncated)[:-1]
    episode = np.cumsum(np.append(False, ended), dtype=np.int64)
    first_row = np.append(0, np.flatnonzero(ended) + 1)
    return episode, np.arange(len(episode), dtype=np.int64) - first_row[episode]


def to_csv(transitions: Transitions) -> str:
    """The rows as CSV text, the same for the same numbers. A reward reads back exactly."""
    columns = (
        dict(zip(NAMES, count_episodes(transitions), strict=False))
        | transitions._asdict()
    )
    rows = zip(*(columns[name].tolist() for name in NAMES), strict=True)
    lines = [f"{e},{t},{s},{a},{r!r},{n},{end:d}\n" for e, t, s, a, r, n, end in rows]
    return f"{HEADER}\n{''.join(lines)}"


def from_csv(text: str, source: Source, name: str) -> Transitions:
    """The rows in CSV `text`; `name` of the file is for messages, where rows count from 0 and lines from 1.

    An episode that did not terminate before the next began was truncated. Whether the last one was, the file
    does not say, and it counts as going on. Raises ValueError that names the first bad row.
    """

    def where(row: int) -> str:
        return f"{name}, row {row} (line {row + 2})"

    header, *lines = text.split("\n")
    if header.strip() != HEADER:
        raise ValueError(
            f"{name}, line 1: the columns are {header[:100]!r}, expected {HEADER!r}; {CHANGED}"
        )
    if not lines or lines.pop() != "":
        raise ValueError(
            f"{where(len(lines))}: the file is cut off in the middle of this row; {REMEDY}"
        )
    if not lines:
        raise ValueError(f"{name}: there are no rows after the header; {REMEDY}")
    for row, line in enumerate(lines):
        if not ROW.fullmatch(line):
            raise ValueError(
                f"{where(row)}: expected {len(NAMES)} numbers, found {line[:100]!r}; {CHANGED}"
            )
    columns = dict(zip(NAMES, np.loadtxt(lines, delimiter=",", ndmin=2).T, strict=True))
    check_rows(columns, source, where)

    episode, step = columns.pop("episode"), columns.pop("step")
    terminated = columns.pop("terminated").astype(bool)
    truncated = np.append(np.diff(episode) != 0, False) & ~terminated
    transitions = Transitions(**columns, terminated=terminated, truncated=truncated)
    episode_due, step_due = count_episodes(transitions)
    bad = (episode != episode_due) | (step != step_due)
    if bad.any():
        row = int(np.argmax(bad))
        it = f"episode {episode[row]:.0f}, step {step[row]:.0f}"
        due = f"episode {episode_due[row]}, step {step_due[row]}"
        raise ValueError(
            f"{where(row)}: {it} stands where {due} is due: rows are missing or moved; {REMEDY}"
        )
    return transitions
