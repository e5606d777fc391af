"""A right notebook, changed by chance in ways that change nothing, keeps all its points."""

from __future__ import annotations

import random
import re
from pathlib import Path
from textwrap import indent

import pytest
from test_grade import ALL, cells, points, write

from rlrobot_course.homework import COURSE
from rlrobot_grading.marking.grade import marked_files
from rlrobot_grading.marking.marks import Limits
from rlrobot_grading.marking.submission import read_submission

pytest.importorskip("jupyter_client")

MAGICS = (
    "%%time\n",
    "%%capture\n",
    "%matplotlib inline\n",
    "!ls\n",
    "files = !ls\n",
    "\n\n%%time\n",
)
MORE = (
    "# check.target(target)\n", "'''\ncheck.update(update)\n'''", "print('check.learn(learn) was green')", "exit()",
    "quit", "exit", "import sys\nsys.exit(0)", "%pip install x", "!pip3 install x", "x = (", "1 / 0", "target?", "!ls",
    "%time 1 + 1", "%%bash\necho def target", "%%writefile target.py\ndef target():\n    return 1", "%lsmagic",
    "import no_such_module", "%no_such_magic", "input()", "assert False, 'check.target(target)'", "", "   # nothing",
)  # fmt: skip
AROUND = (
    ("if True:", ""), ("try:", "finally:\n    pass"), ("import contextlib\nwith contextlib.suppress():", ""),
    ("for _ in range(1):", ""), ("while True:", "    break"),
)  # fmt: skip


def answers(sources):
    return [i for i, one in enumerate(sources) if "\n\ncheck." in one]


def check_elsewhere(rng, sources):
    """In the next cell, in one above, or nowhere."""
    i = rng.choice(answers(sources))
    sources[i], call = sources[i].rsplit("\n\n", 1)
    if place := rng.choice([i + 1, rng.randint(1, i), 0]):
        sources.insert(place, call)


def wrapped(rng, sources):
    i, (head, tail) = rng.randrange(len(sources)), rng.choice(AROUND)
    sources[i] = f"{head}\n{indent(sources[i], '    ')}\n{tail}"


def decorated(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "\ndef " in f"\n{one}"])
    sources[i] = re.sub(
        r"^def ",
        "@(lambda function: function)\ndef ",
        sources[i],
        count=1,
        flags=re.MULTILINE,
    )


def under_another_name(rng, sources):
    i = rng.choice(
        [i for i, one in enumerate(sources) if "check.target(target)" in one]
    )
    sources[i] = sources[i].replace(
        "check.target(target)", "mine = target\ncheck.target(mine)"
    )


def checks_under_another_name(rng, sources):
    sources[:] = [
        re.sub(
            r"import check$", "import (\n    check as c,\n)", one, flags=re.MULTILINE
        )
        for one in sources
    ]
    sources[:] = [
        re.sub(r"\bcheck\.", "c.", one) if "was green" not in one else one
        for one in sources
    ]


def moved(rng, sources):
    i, j = rng.sample(answers(sources), 2)
    sources[i], sources[j] = sources[j], sources[i]


def inserted(rng, sources):
    sources.insert(rng.randint(0, len(sources)), rng.choice(MORE))


def below_a_magic(rng, sources):
    i = rng.randrange(len(sources))
    sources[i] = rng.choice(MAGICS) + sources[i]


CHANGES = (
    check_elsewhere, check_elsewhere, wrapped, decorated, under_another_name, checks_under_another_name, moved,
    inserted, inserted, inserted,
)  # fmt: skip


def by_chance(seed: int, folder: Path) -> Path:
    rng, sources = random.Random(seed), list(cells().values())
    for change in [
        *rng.sample(CHANGES, 6),
        below_a_magic,
    ]:  # a magic cannot stand in an if
        before = list(sources)
        try:
            change(rng, sources)
        except (IndexError, ValueError):  # no cell is left to which this applies
            sources = before
    folder.mkdir()
    return write(
        folder
        / rng.choice(
            ["03_q_learning.ipynb", "Copy of it (1).ipynb", "hausübung.ipynb"]
        ),
        sources,
    )


@pytest.mark.long
def test_whatever_changes_nothing_costs_nothing(tmp_path):
    paths = [by_chance(seed, tmp_path / str(seed)) for seed in range(12)]
    for path, one in zip(
        paths,
        marked_files(COURSE, paths, "", 7, Limits(seconds=600, memory=2048), jobs=2),
        strict=True,
    ):
        assert points(one) == ALL, (path, read_submission(COURSE, path).cells, one)
