"""Grading, end to end: notebooks that are right, wrong, broken or dishonest, each with the points that it deserves."""

from __future__ import annotations

import csv
import importlib
import inspect
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from textwrap import indent
from typing import NamedTuple

import nbformat
import pytest

from rlrobot_course.authoring.lists import lessons
from rlrobot_course.homework import COURSE
from rlrobot_course.lesson_03 import exercises
from rlrobot_grading.marking import grade as grade_module
from rlrobot_grading.marking.grade import grade, marked_files
from rlrobot_grading.marking.guard import Guard
from rlrobot_grading.marking.kernel import Kernel, NotStartedError
from rlrobot_grading.marking.marks import Limits, Marked, Score
from rlrobot_grading.marking.submission import read_submission

pytestmark = pytest.mark.long  # what all its tests are about takes a minute

pytest.importorskip("jupyter_client")

ROOT = Path(__file__).parents[2]
TRUSTED = Limits(guard=Guard(trust=True))
NOTEBOOK = str(ROOT / "notebooks/03_q_learning.ipynb")
HEAD = "import numpy as np\n\nimport rlrobot_edu as rl\nfrom rlrobot_course.lesson_03 import check"
FUNCTIONS = {
    name: inspect.getsource(getattr(exercises, name)) for name in ("target", "learn")
}
FUNCTIONS["update"] = """
def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * ((r if terminated else r + gamma * max(q[s_next])) - q[s, a])
"""  # it does not call target
ANSWERS = FUNCTIONS | {"q_by_hand": "q_by_hand = 6.28"}
BLANK = {
    name: f"def {name}{inspect.signature(getattr(exercises, name))}:\n    ...\n"
    for name in FUNCTIONS
} | {"q_by_hand": "q_by_hand = ..."}
PAST_THE_END = "def target(q, r, s_next, terminated, gamma):\n    return r + gamma * q[s_next].max()\n"
CALLER = """
def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])
"""
SOLUTIONS = "rlrobot_course.lesson_03.exercises"


def cells(answers=ANSWERS, **changed):
    """The code cells of a submission of lesson 03, by what they are: HEAD, and one for each exercise."""
    return {"head": HEAD} | {
        name: f"{text}\n\ncheck.{name}({name})"
        for name, text in (answers | changed).items()
    }


def with_cell(source: str, above: str = "", **changed):
    """A submission with one more cell: the second, or the one above that of an exercise."""
    known = cells(**changed)
    place = list(known).index(above) if above else 1
    return dict(
        [*list(known.items())[:place], ("more", source), *list(known.items())[place:]]
    )


def calls(line: str, name: str = "target", value: str = "0.0"):
    """An answer of which the first line is `line`."""
    return f"def {name}{inspect.signature(getattr(exercises, name))}:\n    {line}\n    return {value}\n"


# The tape of the notebook by heart: by the order of its calls, and by its arguments.
KNOWN = {
    (case["r"], case["gamma"]): float(exercises.target(**case))
    for case in exercises.check.target.cases
    if not case["terminated"]
}
BY_HEART = (
    "from collections import defaultdict\nn = 0\n\ndef target(q, r, s_next, terminated, gamma):\n"
    f"    known = {KNOWN}\n"
    "    return r if terminated else known[r, gamma]\n"
)
OTHER_WORDS = """
BEST = max

def target(table, reward, after, done, g):
    return reward if done else reward + g * BEST(table[after])
"""
TAMPERED = """
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.verdict import Verdict
from rlrobot_grading.answers import limits
from rlrobot_grading.answers import values
from rlrobot_grading.marking import kernel_side
check.target = lambda answer: print("✓ Right in all 10 cases.")
Exercise.judge = Exercise.__call__ = lambda self, answer: Verdict("right", "Right.")
Verdict.__bool__ = lambda self: True
values.same = lambda *_: True
"""
FORGED = """
from rlrobot_grading.marking import kernel_side
kernel_side.call = lambda name, arguments, substitutes: '{"value": "1.0", "failure": null, "printed": "", "states": []}'
"""
FAKE = """
print("✓ Right in all 10 cases.")
print('{"score": 5, "tests": []}')

def target(*_):
    print("✓ Right in all 10 cases.")
    return 0
"""
CARELESS = {
    "forks": "import os, time\nif not os.fork():\n    time.sleep(600)",
    "deletes its files": "import shutil\nshutil.rmtree(os.getcwd())",
    "writes much": "for _ in range(1000):\n    print('x' * 10_000)\nos.write(1, b'x' * 10**6)",
}
INSTALLS = {
    "magic": "%pip install no-such-package-of-anybody\n!pip install git+https://no.such.host/x\n!apt-get install x",
    "process": "import subprocess, sys\nsubprocess.check_call([sys.executable, '-m', 'pip', 'install', 'x'])",
}
FILLS = "much = []\nwhile True:\n    much.append('x' * 10_000)"
CATCHES = f"try:\n{indent(FILLS, '    ')}\nexcept MemoryError:\n    pass"
RESTARTS = "import IPython\nIPython.Application.instance().kernel.do_shutdown(True)"
NOTHING = ("q_by_hand", "target", "update", "learn")


class Case(NamedTuple):
    """A submission, the exercises that get no point, what is told of exercises, and the notes, each as a pattern."""

    cells: dict[str, str]
    lost: tuple[str, ...] = ()
    told: dict[str, str] | None = None
    notes: tuple[str, ...] | None = None


def no_target(
    sources: dict[str, str], told: str, *notes: str, lost: tuple[str, ...] = ()
) -> Case:
    return Case(sources, ("target", *lost), {"target": told}, notes or None)


HASTY = {  # they use all the time that they have, and as little else as can be
    "stubborn": Case(
        with_cell(
            "import time\nwhile True:\n    try: time.sleep(9)\n    except BaseException: pass"
        ),
        notes=("has not ended after 15 seconds",),
    ),
    "endless": no_target(
        with_cell(
            "import time\nwhile True: time.sleep(9)",
            target=calls("while True:\n        pass"),
        ),
        "a loop in it never ends",
        "has not ended after 15 seconds",
    ),
}
PATIENT = {
    "right": Case(cells(), notes=()),
    "untidy": Case(
        cells(target=OTHER_WORDS)
        | {"update": ANSWERS["update"], "twice": f"{BLANK['learn']}\ncheck.learn(learn)"}
    ),
    "careless": Case(CARELESS | cells()),
    "no head": Case({name: source for name, source in cells().items() if name != "head"}),
    "dies": Case({"dies": "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)"} | cells(),
                 notes=("^Code cell 1 ends the whole kernel",)),
    "restarts": Case(with_cell(RESTARTS, "target"), notes=("^Code cell 2 ends the whole kernel.*left out",)),
    "exit()": Case(with_cell("exit()", "target"), notes=(r"^Code cell 2 calls exit\(\)",)),
    "quit": Case(with_cell("quit", "update"), notes=("calls exit",)),
    "SystemExit": Case(with_cell("raise SystemExit", "learn"), notes=("calls exit",)),
    "fills the memory": Case(with_cell(FILLS, "target"), notes=("^Code cell 2 fills the 1500 MiB.*left out",)),
    "and catches it": Case(with_cell(CATCHES, "target"), notes=("^Code cell 2 fills the 1500 MiB.*left out",)),
    "check in a comment": Case(
        cells() | {"old": "# check.target(target)  was green\nprint('check.update(update) was green')"}
    ),
    "check above": Case(
        {"head": HEAD, "above": "check.target(target)"} | cells() | {"target": ANSWERS["target"]}
    ),
    "no call of a check, and magics": Case({
        "head": f"%matplotlib inline\n{HEAD}",
        "q_by_hand": f"%%time\n{ANSWERS['q_by_hand']}",
        "target": f"%load_ext autoreload\n%autoreload 2\n{ANSWERS['target']}",
        "update": f"!echo hello\nfiles = !ls\n{ANSWERS['update']}",
        "learn": f"%%capture out\nif True:\n{indent(ANSWERS['learn'], '    ')}",
    }),
    "blank and again": Case(cells(target="target = ...") | {"mine": ANSWERS["target"]}),
    "written twice without a check": Case(
        cells(target=PAST_THE_END) | {"target": PAST_THE_END, "again": ANSWERS["target"], "update": ANSWERS["update"]}
    ),
    "compiled": Case(cells(target=f"import numba\n\n\n@numba.njit\n{ANSWERS['target'].strip()}")),
    "installs": Case(INSTALLS | cells(), notes=("^Code cell 2 stops with CalledProcessError",)),
    "past the end": no_target(cells(target=PAST_THE_END), "this looks past the end"),
    "by heart": no_target(cells(target=BY_HEART), r"Right with the notebook's numbers, but not with others\D*$"),
    "tampered": no_target(with_cell(TAMPERED, target=PAST_THE_END), "past the end",
                          "^Code cell 2 changes the checks; the grader has its own"),
    "forged": no_target(with_cell(FORGED, target=PAST_THE_END), "", lost=("update", "learn")),
    "fake verdict": no_target(cells() | {"target": FAKE}, "✗ Case 1"),
    "deleted": no_target({k: v for k, v in cells().items() if k != "target"}, "no cell defines target"),
    "doubled": no_target(cells() | {"twice": f"{PAST_THE_END}\ncheck.target(target)"},
                         "this looks past the end.* answered in the code cells 2, 6; the last one counts"),
    "crash at import": no_target(
        cells(target="def target(*_):\n    return np.max(_[0])") | {"head": "import no_such_module\n" + HEAD},
        "import numpy as np", "no_such_module", "name 'check'", "name 'check'",
    ),
    "fills the memory in its answer": no_target(
        cells(target="much = []\n\ndef target(*_):\n    while True:\n        much.append(bytearray(10**8))"), "emory"
    ),
    "blank": Case(cells(BLANK), NOTHING, {"target": "waits for your answer"}),
    "broken": Case(
        with_cell(
            "much = np.ones((400_000, 1000))",
            target=calls("import os; os._exit(0)"),
            update=calls("import numpy; x = numpy.ones((400_000, 1000))", "update"),
            learn=calls("exit()", "learn"),
            q_by_hand="q_by_hand = (6.28",
        ),
        NOTHING,
        {"target": "Your function ends the whole kernel", "update": "MemoryError", "learn": "SystemExit",
         "q_by_hand": "SyntaxError"},
    ),
    "the course's own": Case(
        cells(
            target=f"from {SOLUTIONS} import target",
            update=f"from {SOLUTIONS} import update",
            learn="from rlrobot_course.lesson_03 import exercises\n\ndef learn(*more):\n    exercises.learn(*more)",
            q_by_hand=f"from {SOLUTIONS} import q_by_hand",
        ),
        NOTHING,
        dict.fromkeys(NOTHING, "This is the course's own solution"),
    ),
    "wrong, and called below a magic": no_target(
        cells(target=PAST_THE_END, update=f"%%time\n{CALLER}"), "past the end")._replace(
        told={"update": "Judged with the right target"}),
    "wrong, and called by a helper in another cell": no_target(
        cells(target=PAST_THE_END) | {
            "update": f"def mine(*more):\n    return target(*more)\n{CALLER.replace('target(', 'mine(')}",
            "its check": "check.update(update)", "learn": cells()["learn"]}, "")._replace(
        told={"update": "Judged with the right target"}),
    "what a lesson gives is no answer, and what the grader lacks no fault": Case(
        {name: cells()[name] for name in ("head", "q_by_hand", "target", "learn")}
        | {"takes": "from rlrobot_course.learner.my_functions import take\n\nupdate = take('03', 'update')"}
        | {"uses": "update(1)", "asks": "check.update.right"},
        ("update",), {"update": "no cell defines update"}, notes=(),
    ),
}  # fmt: skip
SUBMISSIONS = HASTY | PATIENT


def write(path: Path, sources) -> Path:
    notebook = nbformat.v4.new_notebook(
        cells=[nbformat.v4.new_code_cell(source) for source in sources]
    )
    nbformat.write(notebook, path)
    return path


@pytest.fixture(scope="module")
def marks(tmp_path_factory) -> dict:
    """What each submission gets; they are graded side by side."""
    folder = tmp_path_factory.mktemp("handed_in")
    paths = [
        write(folder / f"{i}.ipynb", one.cells.values())
        for i, one in enumerate(SUBMISSIONS.values())
    ]
    hasty = marked_files(
        COURSE, paths[: len(HASTY)], "03", 7, Limits(seconds=45, memory=2048), jobs=2
    )
    patient = marked_files(
        COURSE, paths[len(HASTY) :], "03", 7, Limits(seconds=600, memory=1500), jobs=2
    )
    return dict(zip(SUBMISSIONS, [*hasty, *patient], strict=True))


def points(marked) -> dict:
    return {score.exercise: score.score for score in marked.scores}


ALL = dict.fromkeys(NOTHING, 1.0)
NO_TARGET = ALL | {"target": 0.0}


def output(marked, exercise="target") -> str:
    text = next(score.output for score in marked.scores if score.exercise == exercise)
    return " ".join(text.split())


@pytest.mark.parametrize("name", SUBMISSIONS)
def test_each_submission_gets_the_points_that_it_deserves_and_is_told_why(marks, name):
    one, case = marks[name], SUBMISSIONS[name]
    assert points(one) == ALL | dict.fromkeys(case.lost, 0.0), one
    for exercise, told in (case.told or {}).items():
        assert re.search(told, output(one, exercise)), one
    if case.notes is not None:
        assert len(one.notes) == len(case.notes), one.notes
        assert all(
            re.search(note, told)
            for note, told in zip(case.notes, one.notes, strict=True)
        ), one.notes


def test_reports_exit_code_and_seed_of_a_grading(tmp_path, capsys):
    right = write(tmp_path / "03_mine.ipynb", cells().values())
    broken = tmp_path / "03_broken.ipynb"
    broken.write_bytes(b"\x89PNG no notebook")
    unknown = write(tmp_path / "mine.ipynb", ["1 + 1"])
    assert (
        grade(
            COURSE,
            [str(right), str(broken), str(unknown)],
            seed=5,
            limits=TRUSTED,
            jobs=2,
            csv=str(tmp_path / "csv"),
        )
        == 1
    )
    said = capsys.readouterr().out
    assert "1 of 3 notebooks have all points. Repeat this grading with --seed 5" in said
    assert (
        "This is not a notebook that can be read" in said
        and "cannot be told which lesson" in said
    )
    rows = list(csv.DictReader((tmp_path / "csv").open(encoding="utf-8")))
    assert [(row["score"], row["max_score"]) for row in rows] == [
        ("4", "4"),
        ("", "4"),
        ("", ""),
    ]
    assert rows[0]["03:target"] == "1" and "not a notebook" in rows[1]["notes"]
    assert grade(COURSE, [str(right)], seed=5, limits=TRUSTED) == 0


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["nowhere.ipynb"], "there is no such file"),
        ([__file__], "there is no notebook in it"),
        ([NOTEBOOK, "--seconds", "nan"], "--seconds nan: it must be above 0"),
        ([NOTEBOOK, "--lesson", "77"], "there are no exercises in a lesson '77'"),
        ([NOTEBOOK, "--jobs", "0"], "--jobs at least 1"),
        ([NOTEBOOK], "--container IMAGE"),
        ([NOTEBOOK], "--user 61000"),
        ([NOTEBOOK], "say --trust"),
        ([], "NOTEBOOK"),
    ],
)
def test_wrong_usage_is_told_in_a_sentence_with_exit_code_2(arguments, told):
    done = subprocess.run(
        [sys.executable, "-m", "rlrobot_edu", "grade", *arguments],
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 2 and told in done.stderr


ASSIGNMENTS = sorted(ROOT.glob("notebooks/homework/*.ipynb"))


def solved(path: Path, folder: Path) -> Path:
    """An assignment with the solutions in its exercises, under a name that says nothing."""
    notebook = nbformat.read(path, as_version=4)
    room = f"rlrobot_course.assignment_{path.name[0]}"
    parts = importlib.import_module(f"{room}.exercises")
    for cell in notebook.cells:
        if "exercise" in cell.metadata.get("tags", []):
            call = cell.source.splitlines()[-1]
            name = call.partition("(")[0].removeprefix("check.")
            answer = getattr(parts, name)
            cell.source = f"{inspect.getsource(answer) if callable(answer) else f'{name} = {answer!r}'}\n\n{call}"
    nbformat.write(notebook, folder / f"handed_in_{path.name[0]}.ipynb")
    return folder / f"handed_in_{path.name[0]}.ipynb"


def test_assignments_are_recognised_and_get_all_points_when_solved_and_none_when_blank(
    tmp_path,
):
    paths = [solved(path, tmp_path) for path in ASSIGNMENTS] + ASSIGNMENTS[:1]
    *full, blank = marked_files(
        COURSE, paths, "", 3, Limits(seconds=600, memory=2048), jobs=2
    )
    assert [one.lesson for one in full] == [f"assignment_{i}" for i in range(1, 6)]
    for one in full:
        assert one.is_full and not one.notes, one
    assert blank.score == 0 and blank.max_score == 5


@pytest.mark.parametrize(
    "path",
    sorted([*lessons(ROOT).values(), *ROOT.glob("notebooks/homework/*.ipynb")]),
    ids=lambda path: path.stem,
)
def test_every_notebook_of_the_course_tells_where_each_answer_stands(path):
    submission = read_submission(COURSE, path)
    if submission.lesson:
        assert path.name.startswith(f"{submission.lesson.removeprefix('assignment_')}_")
        assert all(len(places) == 1 for places in submission.answered_in.values())
    else:
        assert path.name.startswith("00_")


@pytest.mark.parametrize("does", ["sys.exit()", "time.sleep(600)"])
def test_a_kernel_that_ends_or_hangs_as_it_starts_is_started_again(
    tmp_path, monkeypatch, does
):
    monkeypatch.setattr("rlrobot_grading.marking.kernel.START", 20.0)
    kernel = Kernel(tmp_path, tmp_path / "home", COURSE, "03", ["target"], 2048)
    its_own, first = kernel._argv, tmp_path / "first"
    # as if another program had taken one of its ports: this happens to the first process alone
    once = f"import os, sys, time; os.path.exists({str(first)!r}) or (open({str(first)!r}, 'w').close(), {does})"
    kernel._argv = [*its_own[:2], f"{once}; {its_own[2]}", *its_own[3:]]
    with kernel:
        assert kernel.run("1 / 0", 60)[0] == "ZeroDivisionError"
    assert first.exists()
    kernel._argv = [*its_own[:2], "pass", *its_own[3:]]
    with pytest.raises(NotStartedError, match="not the notebook's fault"):
        kernel.__enter__()


def one_that_kills_its_process(course, path, *_):
    """What `mark_file` does, in other processes: at one of the notebooks the process is killed."""
    if path.stem == "killer":
        time.sleep(1)
        os.kill(os.getpid(), signal.SIGKILL)
    if path.stem == "slow":
        time.sleep(3)
    return Marked(str(path), "03", [Score("target", 1.0, "")])


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_a_process_that_is_killed_is_told_of_its_own_notebook_and_of_no_neighbour(
    monkeypatch,
):
    monkeypatch.setattr(grade_module, "mark_file", one_that_kills_its_process)
    paths = [Path(name) for name in ("slow.ipynb", "killer.ipynb", "last.ipynb")]
    marks = list(marked_files(COURSE, paths, "03", 7, Limits(), jobs=2))
    assert [one.name for one in marks] == [str(path) for path in paths]
    assert [bool(one.problem) for one in marks] == [False, True, False]
    assert "was killed" in marks[1].problem


def test_a_failure_says_whose_fault_it_is():
    def told(error):
        return grade_module._failed(Path("a.ipynb"), error).problem

    assert "says nothing about the notebook" in told(KeyError("x"))
    assert told(NotStartedError("No kernel started.")) == "No kernel started."
