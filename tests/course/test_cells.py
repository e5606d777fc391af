"""Which cells of a notebook answer which exercise, and who is blamed: innocent habits cost no right answer."""

from __future__ import annotations

import json
import random
import re
import textwrap
from pathlib import Path

import nbformat
import pytest
from test_grade import ALL, ANSWERS, HEAD, NO_TARGET, PAST_THE_END, cells, output, points, write

from rlrobot_course.homework.grade import marked_files
from rlrobot_course.homework.marks import Limits
from rlrobot_course.homework.submission import read_submission

pytest.importorskip("jupyter_client")

CALLER = """
def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])
"""
FILLS = "much = []\nwhile True:\n    much.append('x' * 10_000)"
RESTARTS = "import IPython\nIPython.Application.instance().kernel.do_shutdown(True)"
SOLUTIONS = "rlrobot_course.lesson_02.exercises"


def in_order(*names, **more):
    """Cells of these names, of `cells()` or of `more`, in this order."""
    known = cells() | more
    return {name: known[name] for name in names}


INNOCENT = {
    "exit() above target": in_order("head", "by_hand", "leaves", "target", "update", "learn", leaves="exit()"),
    "leaves in other ways": in_order(
        "head", "by_hand", "target", "quit", "update", "exit", "learn", "error",
        quit="quit", exit="exit", error="raise SystemExit",
    ),
    "restarts": in_order("head", "by_hand", "restart", "target", "update", "learn", restart=RESTARTS),
    "fills the memory": in_order("head", "by_hand", "fills", "target", "update", "learn", fills=FILLS),
    "fills the memory and catches it": in_order(
        "head", "by_hand", "fills", "target", "update", "learn",
        fills=f"try:\n{textwrap.indent(FILLS, '    ')}\nexcept MemoryError:\n    pass",
    ),
    "check above, and in a comment": {"head": HEAD, "above": "check.target(target)"}
    | cells(target=ANSWERS["target"])
    | {"target": ANSWERS["target"], "old": "# check.target(target)\nprint('check.update(update)')"},
    "no call of a check, and magics": {
        "head": f"%matplotlib inline\n{HEAD}",
        "by_hand": f"%%time\n{ANSWERS['by_hand']}",
        "target": f"%load_ext autoreload\n%autoreload 2\n{ANSWERS['target']}",
        "update": f"!echo hello\nfiles = !ls\n{ANSWERS['update']}",
        "learn": f"%%capture out\nif True:\n{textwrap.indent(ANSWERS['learn'], '    ')}",
    },
    "the blank cell is still there": cells(target="target = ...") | {"mine": ANSWERS["target"]},
    "written twice without a check": cells(target=PAST_THE_END.strip())
    | {"target": PAST_THE_END, "again": ANSWERS["target"], "update": ANSWERS["update"]},
    "the check by its own name": cells(by_hand="by_hand = ...")
    | {"by_hand": "from rlrobot_course.lesson_02.check import by_hand, target"}
    | {"by_hand again": "by_hand = 6.28", "target": ANSWERS["target"]},
    "compiled": cells(target=f"import numba\n\n\n@numba.njit\n{ANSWERS['target'].strip()}"),
    "installs": {
        "magic": "%pip install no-such-package-of-anybody\n!pip install git+https://no.such.host/x\n!apt-get install x",
        "process": "import subprocess, sys\nsubprocess.check_call([sys.executable, '-m', 'pip', 'install', 'x'])",
        "conda": "%conda install x\n!sudo apt install y",
    }
    | cells(),
}  # fmt: skip
OTHERS = {
    "wrong, and called below a magic": cells(target=PAST_THE_END, update=f"%%time\n{CALLER}"),
    "wrong, and called in another cell": cells(target=PAST_THE_END)
    | {"update": CALLER, "helper": "half = 1 / 2", "its check": "check.update(update)"}
    | {"learn": cells()["learn"]},
    "wrong, and called by a helper": cells(
        target=PAST_THE_END, update=f"def mine(*more):\n    return target(*more)\n{CALLER.replace('target(', 'mine(')}"
    ),
    "the course's own": cells(
        target=f"from {SOLUTIONS} import target",
        update="from rlrobot_course.lesson_02.exercises import update",
        learn="from rlrobot_course.lesson_02 import exercises\n\ndef learn(*more):\n    exercises.learn(*more)",
        by_hand=f"from {SOLUTIONS} import by_hand",
    ),
    "blank, with the lesson's own cells": in_order("head", "by_hand", "target", "learn")
    | {
        "takes": "from rlrobot_course.my_functions import take\n\nupdate = take('02', 'update')",
        "uses": "update(1)",
    },
    "fills the memory in its answer": cells(
        target="much = []\n\ndef target(*_):\n    while True:\n        much.append('x' * 10_000)"
    ),
}


@pytest.fixture(scope="module")
def marks(tmp_path_factory) -> dict:
    folder = tmp_path_factory.mktemp("handed_in")
    all_of_them = INNOCENT | OTHERS
    paths = [write(folder / f"{i}.ipynb", sources.values()) for i, sources in enumerate(all_of_them.values())]
    graded = marked_files(paths, "02", 7, Limits(seconds=600, memory=1500), jobs=2)
    return dict(zip(all_of_them, graded, strict=True))


@pytest.mark.long
@pytest.mark.parametrize("name", INNOCENT)
def test_an_innocent_habit_costs_no_point(marks, name):
    assert points(marks[name]) == ALL, (marks[name].scores, marks[name].notes)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "note"),
    [
        ("exit() above target", r"^Code cell 3 calls exit\(\)"),
        ("restarts", "^Code cell 3 ends the whole kernel.*left out"),
        ("fills the memory", "^Code cell 3 fills the 1500 MiB.*left out"),
        ("fills the memory and catches it", "^Code cell 3 fills the 1500 MiB.*left out"),
    ],
)
def test_the_one_note_names_the_cell_that_has_done_it(marks, name, note):
    (told,) = marks[name].notes
    assert re.search(note, told)


@pytest.mark.long
def test_what_should_have_been_installed_is_a_note_for_each_cell_and_nothing_is_installed(marks):
    told = [note for note in marks["installs"].notes if "install" in note]
    assert [note.partition(" wants to install something")[0] for note in told] == [f"Code cell {i}" for i in (1, 2, 3)]
    assert marks["installs"].notes == told, "nor does it fail"


@pytest.mark.long
@pytest.mark.parametrize("name", [name for name in OTHERS if name.startswith("wrong, and called")])
def test_who_calls_a_wrong_function_is_judged_with_the_right_one_wherever_it_stands(marks, name):
    assert points(marks[name]) == NO_TARGET
    assert "Judged with the right target" in output(marks[name], "update")


@pytest.mark.long
def test_the_courses_own_solution_is_no_answer_and_that_is_said(marks):
    assert points(marks["the course's own"]) == dict.fromkeys(ALL, 0.0)
    for exercise in ALL:
        assert "This is the course's own solution" in output(marks["the course's own"], exercise)


@pytest.mark.long
def test_what_only_the_grader_lacks_is_never_told_as_a_fault(marks):
    one = marks["blank, with the lesson's own cells"]
    assert points(one) == ALL | {"update": 0.0} and one.notes == []
    assert "no cell defines update" in output(one, "update")


@pytest.mark.long
def test_an_answer_that_fills_the_memory_costs_its_point_alone(marks):
    assert points(marks["fills the memory in its answer"]) == NO_TARGET


# --- by chance: a right notebook, changed in ways that change nothing


def split(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "\n\ncheck." in one])
    answer, call = sources[i].rsplit("\n\n", 1)
    sources[i : i + 1] = [answer, call]


def without_check(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "\n\ncheck." in one])
    sources[i] = sources[i].rsplit("\n\n", 1)[0]


def check_above(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "\n\ncheck." in one])
    answer, call = sources[i].rsplit("\n\n", 1)
    sources[i] = answer
    sources.insert(rng.randint(1, i), call)


def wrapped(rng, sources):
    i = rng.randrange(len(sources))
    head, tail = rng.choice(
        [("if True:", ""), ("try:", "finally:\n    pass"), ("import contextlib\nwith contextlib.suppress():", ""),
         ("for _ in range(1):", ""), ("while True:", "    break")]
    )  # fmt: skip
    sources[i] = f"{head}\n{textwrap.indent(sources[i], '    ')}\n{tail}"


def decorated(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "\ndef " in f"\n{one}"] or [0])
    sources[i] = re.sub(r"^def ", "@(lambda function: function)\ndef ", sources[i], count=1, flags=re.MULTILINE)


def under_another_name(rng, sources):
    i = rng.choice([i for i, one in enumerate(sources) if "check.target(target)" in one] or [0])
    sources[i] = sources[i].replace("check.target(target)", "mine = target\ncheck.target(mine)")


def checks_under_another_name(rng, sources):
    sources[:] = [re.sub(r"(import \(?\s*check)\b", r"\1 as c", one) for one in sources]
    sources[:] = [re.sub(r"\bcheck\.", "c.", one) if "was green" not in one else one for one in sources]


def import_over_several_lines(rng, sources):
    sources[:] = [
        re.sub(r"import (check( as c)?)$", r"import (\n    \1,\n)", one, flags=re.MULTILINE) for one in sources
    ]


def moved(rng, sources):
    answers = [i for i, one in enumerate(sources) if "\n\ncheck." in one]
    i, j = rng.sample(answers, 2) if len(answers) > 1 else (0, 0)
    sources[i], sources[j] = sources[j], sources[i]


def inserted(rng, sources):
    more = [
        "# check.target(target)\n", "'''\ncheck.update(update)\n'''", "print('check.learn(learn) was green')", "exit()",
        "quit", "exit", "import sys\nsys.exit(0)", "%pip install x", "!pip3 install x", "x = (", "1 / 0", "target?",
        "!ls",

        "%time 1 + 1", "%%bash\necho def target", "%%writefile target.py\ndef target():\n    return 1", "%lsmagic",
        "import no_such_module", "%no_such_magic", "input()", "assert False, 'check.target(target)'", "",
        "   # nothing",
    ]  # fmt: skip
    sources.insert(rng.randint(0, len(sources)), rng.choice(more))


def below_a_magic(rng, sources):
    i = rng.randrange(len(sources))
    sources[i] = (
        rng.choice(["%%time\n", "%%capture\n", "%matplotlib inline\n", "!ls\n", "files = !ls\n", "\n\n%%time\n"])
        + sources[i]
    )


CHANGES = (
    split, without_check, check_above, wrapped, decorated, under_another_name, checks_under_another_name,
    import_over_several_lines, moved, inserted, inserted, inserted,
)  # fmt: skip


def as_handed_in(rng, sources, folder: Path) -> Path:
    """Written as some program writes it: with outputs, without ids, in another encoding, of an older format."""
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in sources])
    for one in notebook.cells:
        one.outputs = [
            nbformat.v4.new_output("stream", text="check.target(target)\n") for _ in range(rng.randint(0, 2))
        ]
        if rng.random() < 0.5:
            one.source = one.source.replace("\n", "\r\n")
    version = rng.choice([3, 4, 4])
    if version == 4:
        notebook.nbformat_minor = rng.choice([2, 5])
        for one in notebook.cells if notebook.nbformat_minor == 2 else ():
            del one["id"]
    text = json.dumps(notebook if version == 4 else nbformat.convert(notebook, 3), indent=rng.choice([None, 1]))
    path = folder / rng.choice(["02_q_learning.ipynb", "Copy of it (1).ipynb", "07_no.ipynb", "hausübung.ipynb"])
    path.write_bytes(text.encode(rng.choice(["utf-8", "utf-8-sig", "utf-16"])))
    return path


def by_chance(seed: int, folder: Path) -> Path:
    rng, sources = random.Random(seed), list(cells().values())
    for change in rng.sample(CHANGES, 6):
        before = list(sources)
        try:
            change(rng, sources)
        except IndexError:  # no cell is left to which this applies
            sources = before
    if rng.random() < 0.7:
        below_a_magic(rng, sources)
    folder.mkdir()
    return as_handed_in(rng, sources, folder)


@pytest.mark.long
def test_whatever_changes_nothing_costs_nothing(tmp_path):
    paths = [by_chance(seed, tmp_path / str(seed)) for seed in range(5)]
    for path, one in zip(paths, marked_files(paths, "", 7, Limits(seconds=600, memory=2048), jobs=2), strict=True):
        assert points(one) == ALL, (path, read_submission(path).cells, one)
