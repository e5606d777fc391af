"""Grading, end to end: notebooks that are right, wrong, broken or dishonest, each with the points that it deserves."""

from __future__ import annotations

import csv
import importlib
import inspect
import json
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import nbformat
import pytest
import test_checks
from test_checks import EVERY, RIGHT, exercises, wrong_answers

from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.homework.cell import changes_checks
from rlrobot_course.homework.grade import grade, marked_files
from rlrobot_course.homework.kernel import EndedError, Kernel
from rlrobot_course.homework.marks import Limits
from rlrobot_course.homework.secret import secret_twin
from rlrobot_course.homework.submission import read_submission
from rlrobot_course.homework.wire import read
from rlrobot_course.lesson_02 import exercises as lesson_02

pytestmark = pytest.mark.long  # what all its tests are about takes forty seconds

pytest.importorskip("jupyter_client")

ROOT = Path(__file__).parents[2]
HEAD = "import numpy as np\n\nimport rlrobot_edu as rl\nfrom rlrobot_course.lesson_02 import check"
FUNCTIONS = {name: inspect.getsource(getattr(lesson_02, name)) for name in ("target", "learn")}
FUNCTIONS["update"] = """
def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * ((r if terminated else r + gamma * max(q[s_next])) - q[s, a])
"""  # it does not call target
ANSWERS = FUNCTIONS | {"by_hand": "by_hand = 6.28"}
BLANK = {name: f"def {name}{inspect.signature(getattr(lesson_02, name))}:\n    ...\n" for name in FUNCTIONS} | {
    "by_hand": "by_hand = ..."
}
PAST_THE_END = "def target(q, r, s_next, terminated, gamma):\n    return r + gamma * q[s_next].max()\n"


def cells(answers=ANSWERS, **changed):
    """The code cells of a submission of lesson 02, by what they are: HEAD, and one for each exercise."""
    return {"head": HEAD} | {name: f"{text}\n\ncheck.{name}({name})" for name, text in (answers | changed).items()}


def with_cell(first: str, **changed):
    return {"head": HEAD, "more": first} | cells(**changed)


def without(name: str):
    return {what: source for what, source in cells().items() if what != name}


def calls(line: str, name: str = "target", value: str = "0.0"):
    """An answer of which the first line is `line`."""
    return f"def {name}{inspect.signature(getattr(lesson_02, name))}:\n    {line}\n    return {value}\n"


# The tape of the notebook by heart: by the order of its calls, and by its arguments.
BY_HEART = (
    "from collections import defaultdict\nn = 0\n\ndef target(q, r, s_next, terminated, gamma):\n"
    "    known = {(1.25, 0.75): 5.375, (-0.02, 0.9): 2.68, (-2.0, 0.95): -3.30625, (0.0, 0.6): 1.2,"
    " (3.0, 0.99): 3.556875, (10.0, 0.25): 11.375, (0.125, 0.9): 1.205, (-100.0, 0.8): -10100.0}\n"
    "    return r if terminated else known[r, gamma]\n"
)
OTHER_WORDS = """
BEST = max

def target(table, reward, after, done, g):
    return reward if done else reward + g * BEST(table[after])
"""
TAMPERED = """
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.verdict import Verdict
from rlrobot_course.grading import limits, values
from rlrobot_course.homework import inside
check.target = lambda answer: print("✓ Right in all 10 cases.")
Exercise.judge = Exercise.__call__ = lambda self, answer: Verdict("right", "Right.")
Verdict.__bool__ = lambda self: True
values.same = lambda *_: True
"""
FORGED = """
from rlrobot_course.homework import inside
inside.called = lambda name, arguments: '{"value": "1.0", "failure": null, "printed": "", "states": []}'
"""
FAKE = """
print("✓ Right in all 10 cases.")
print('{"score": 5, "tests": []}')

def target(*_):
    print("✓ Right in all 10 cases.")
    return 0
"""
CARELESS = {
    "leaves": "exit()",
    "forks": "import os, time\nif not os.fork():\n    time.sleep(600)",
    "deletes its files": "import shutil\nshutil.rmtree(os.getcwd())",
    "writes much": "for _ in range(1000):\n    print('x' * 10_000)\nos.write(1, b'x' * 10**6)",
}
SUBMISSIONS = {
    "stubborn": with_cell("while True:\n    try:\n        while True: pass\n    except BaseException: pass"),
    "endless": with_cell("while True: pass", target=calls("while True:\n        pass")),
    "right": cells(),
    "untidy": cells(target=OTHER_WORDS)
    | {"update": ANSWERS["update"], "twice": f"{BLANK['learn']}\ncheck.learn(learn)"},
    "bootstraps past the end": cells(target=PAST_THE_END),
    "blank": cells(BLANK),
    "by heart": cells(target=BY_HEART),
    "tampered": with_cell(TAMPERED, target=PAST_THE_END),
    "forged": with_cell(FORGED, target=PAST_THE_END),
    "deleted check cell": without("target"),
    "deleted head": {name: source for name, source in cells().items() if name != "head"},
    "doubled cell": cells() | {"twice": f"{PAST_THE_END}\ncheck.target(target)"},
    "crash at import": cells(target="def target(*_):\n    return np.max(_[0])")
    | {"head": "import no_such_module\n" + HEAD},
    "dies at import": {"dies": "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)"} | cells(),
    "fake verdict": cells() | {"target": FAKE},
    "broken": with_cell(
        "much = np.ones((400_000, 1000))",
        target=calls("import os; os._exit(0)"),
        update=calls("import numpy; x = numpy.ones((400_000, 1000))", "update"),
        learn=calls("exit()", "learn"),
        by_hand="by_hand = (6.28",
    ),
    "careless": CARELESS | cells(),
    "takes the stand-in": cells(update="from rlrobot_course.lesson_02.exercises import update"),
    "takes what is given": cells(update="from rlrobot_course.my_functions import take\nupdate = take('02', 'update')"),
}


def write(path: Path, sources) -> Path:
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in sources])
    nbformat.write(notebook, path)
    return path


@pytest.fixture(scope="module")
def marks(tmp_path_factory) -> dict:
    """What each submission gets; they are graded side by side."""
    folder = tmp_path_factory.mktemp("handed_in")
    paths = [write(folder / f"{name}.ipynb", sources.values()) for name, sources in SUBMISSIONS.items()]
    # those that use all their time get little, the others more than they need on any machine
    hasty = marked_files(paths[:2], "02", 7, Limits(seconds=45, memory=2048), jobs=2)
    patient = marked_files(paths[2:], "02", 7, Limits(seconds=600, memory=2048), jobs=2)
    return dict(zip(SUBMISSIONS, [*hasty, *patient], strict=True))


def points(marked) -> dict:
    return {score.exercise: score.score for score in marked.scores}


ALL = dict.fromkeys(("by_hand", "target", "update", "learn"), 1.0)
NO_TARGET = ALL | {"target": 0.0}


def output(marked, exercise="target") -> str:
    text = next(score.output for score in marked.scores if score.exercise == exercise)
    return " ".join(text.split())


@pytest.mark.parametrize(
    "name",
    ["right", "untidy", "deleted head", "dies at import", "careless"],
)
def test_right_answers_get_all_points_whatever_the_other_cells_do(marks, name):
    assert points(marks[name]) == ALL, marks[name]


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("bootstraps past the end", "this looks past the end"),
        ("by heart", "Right with the notebook's numbers, but not with others"),
        ("tampered", "this looks past the end"),
        ("deleted check cell", "no cell defines target"),
        ("doubled cell", "this looks past the end"),
        ("fake verdict", "✗ Case 1"),
    ],
)
def test_one_answer_that_does_not_count_costs_its_point_alone_and_is_told_why(marks, name, told):
    assert points(marks[name]) == NO_TARGET, marks[name]
    assert told in output(marks[name])


@pytest.mark.parametrize(
    ("exercise", "told"),
    [
        ("target", "Your function ends the whole kernel"),
        ("update", "MemoryError"),
        ("learn", "SystemExit"),
        ("by_hand", "SyntaxError"),
    ],
)
def test_an_answer_that_breaks_is_told_how_each_by_itself(marks, exercise, told):
    assert points(marks["broken"]) == dict.fromkeys(ALL, 0.0), marks["broken"]
    assert told in output(marks["broken"], exercise)


def test_values_that_are_forged_in_the_kernel_are_wrong_values(marks):
    assert points(marks["forged"]) == NO_TARGET | {"update": 0.0, "learn": 0.0}


def test_a_blank_notebook_gets_nothing_and_is_told_what_waits(marks):
    assert points(marks["blank"]) == dict.fromkeys(ALL, 0.0)
    assert "waits for your answer" in output(marks["blank"])


def test_after_a_crash_at_import_what_needs_no_import_still_counts(marks):
    got = points(marks["crash at import"])
    assert got == NO_TARGET
    assert "import numpy as np" in output(marks["crash at import"])
    assert "no_such_module" in " ".join(marks["crash at import"].notes)


def test_what_a_lesson_gives_is_not_an_answer(marks):
    assert points(marks["takes the stand-in"]) == ALL | {"update": 0.0}, "it leads back to what is handed in"
    assert points(marks["takes what is given"]) == ALL | {"update": 0.0}


def test_of_two_answers_the_last_counts_and_that_is_said(marks):
    assert "answered in the code cells 2, 6; the last one counts" in output(marks["doubled cell"])


@pytest.mark.parametrize(
    ("name", "note"),
    [
        ("tampered", "Code cell 2 changes the checks; the grader has its own."),
        ("dies at import", "Code cell 1 ends the whole kernel"),
        ("broken", "wants more memory than the 2048 MiB"),
    ],
)
def test_the_instructor_is_told(marks, name, note):
    assert note in " ".join(marks[name].notes)


def test_a_secret_tape_does_not_show_its_numbers(marks):
    told = output(marks["by heart"])
    assert "called with" not in told and "expected" not in told and not any(sign.isdigit() for sign in told)


def test_an_endless_cell_is_ended_or_left_out_and_the_rest_counts(marks):
    assert points(marks["stubborn"]) == ALL, marks["stubborn"]
    for name in ("stubborn", "endless"):
        assert "has not ended after 15 seconds" in " ".join(marks[name].notes)


def test_an_endless_function_costs_its_point_alone(marks):
    assert points(marks["endless"]) == NO_TARGET, marks["endless"]
    assert "a loop in it never ends" in output(marks["endless"])


def test_reports_exit_code_and_seed_of_a_grading(tmp_path, capsys):
    right = write(tmp_path / "02_mine.ipynb", cells().values())
    broken = tmp_path / "02_broken.ipynb"
    broken.write_bytes(b"\x89PNG no notebook")
    unknown = write(tmp_path / "mine.ipynb", ["1 + 1"])
    reports = {name: str(tmp_path / name) for name in ("csv", "junit")}
    assert grade([str(right), str(broken), str(unknown)], seed=5, jobs=2, **reports) == 1
    said = capsys.readouterr().out
    assert "1 of 3 notebooks have all points. Repeat this grading with --seed 5" in said
    assert "This is not a notebook that can be read" in said and "cannot be told which lesson" in said
    rows = list(csv.DictReader((tmp_path / "csv").open(encoding="utf-8")))
    assert [(row["score"], row["max_score"]) for row in rows] == [("4", "4"), ("", "4"), ("", "")]
    assert rows[0]["02:target"] == "1" and "not a notebook" in rows[1]["notes"]
    suites = ET.parse(tmp_path / "junit").getroot()
    assert [(suite.get("tests"), suite.get("failures")) for suite in suites] == [("4", "0"), ("4", "4"), ("1", "1")]
    assert grade([str(right)], seed=5, gradescope=str(tmp_path / "results.json")) == 0
    results = json.loads((tmp_path / "results.json").read_text(encoding="utf-8"))
    assert results["score"] == 4
    for test in results["tests"]:
        assert {"name", "score", "max_score", "output", "visibility"} <= test.keys()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["nowhere.ipynb"], "there is no such file"),
        ([__file__, test_checks.__file__, "--gradescope", "x.json"], "one notebook, and 2 are given"),
        ([__file__, "--seconds", "nan"], "--seconds nan: it must be above 0"),
        ([__file__, "--lesson", "77"], "there are no exercises in a lesson '77'"),
        ([__file__, "--jobs", "0"], "--jobs at least 1"),
        ([], "NOTEBOOK"),
    ],
)
def test_wrong_usage_is_told_in_a_sentence_with_exit_code_2(arguments, told):
    done = subprocess.run(
        [sys.executable, "-m", "rlrobot_course", "grade", *arguments], capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 2 and told in done.stderr


ASSIGNMENTS = sorted(ROOT.glob("homework/*.ipynb"))


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


def test_assignments_are_recognised_and_get_all_points_when_solved_and_none_when_blank(tmp_path):
    paths = [solved(path, tmp_path) for path in ASSIGNMENTS] + ASSIGNMENTS[:1]
    *full, blank = marked_files(paths, "", 3, Limits(seconds=600, memory=2048), jobs=2)
    assert [one.lesson for one in full] == [f"assignment_{i}" for i in range(1, 6)]
    for one in full:
        assert one.is_full and not one.notes, one
    assert blank.score == 0 and blank.max_score == 5


@pytest.mark.parametrize(
    ("name", "source", "lesson"),
    [
        ("mine", "from rlrobot_course.assignment_2 import check", "assignment_2"),
        ("1_mine", "1 + 1", "assignment_1"),
        ("02_mine", "1 + 1", "02"),
        ("1_mine", "from rlrobot_course.lesson_05a import check", "05a"),
        ("9_mine", "1 + 1", ""),
    ],
)
def test_an_import_tells_the_lesson_or_the_assignment_and_else_the_name_of_the_file(tmp_path, name, source, lesson):
    assert read_submission(write(tmp_path / f"{name}.ipynb", [source])).lesson == lesson


WITH_TAPE = [(lesson, name) for lesson, name in EVERY if type(exercises(lesson)[name]) is Exercise]


@pytest.mark.parametrize(("lesson", "name"), WITH_TAPE)
def test_on_a_secret_tape_right_is_right_and_wrong_mostly_wrong(lesson, name):
    exercise = exercises(lesson)[name]
    solution = getattr(importlib.import_module(f"rlrobot_course.{lesson}.exercises"), name)
    tapes = set()
    for seed in range(2):
        twin = secret_twin(exercise, seed)
        tapes.add(repr(twin.cases))
        for right in (solution, RIGHT.get(lesson, {}).get(name, solution)):
            assert twin.judge(right), (seed, twin.judge(right))
    taken = [wrong for wrong, _ in wrong_answers(lesson)[name] if twin.judge(wrong)]
    assert len(taken) <= 1, "an edge that only the notebook's tape has"
    assert len(tapes) == 2 and repr(secret_twin(exercise, 1).cases) in tapes, "each seed has one tape, of its own"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[1]",
        '{"pickle": 1}',
        '{"array": [1], "shape": [5], "kind": "float64"}',
        '{"array": [], "shape": [0], "kind": "U999999999"}',
        "[" * 9999,
    ],
)
def test_a_text_that_is_no_value_is_refused(text):
    with pytest.raises(ValueError):
        read(text)


def test_a_cell_that_changes_the_checks_is_recognised_and_no_other():
    for source in ("check = 1", "check.target = print", "Exercise.judge = f", "setattr(check, 'a', 1)", "del check.a"):
        assert changes_checks(source), source
    for source in ("check.target(target)", "q[s, a] = check_it(1)", "from x import check", "a.b = 1", "def f(:"):
        assert not changes_checks(source), source


@pytest.mark.parametrize(
    "path",
    sorted([*ROOT.glob("notebooks/*.ipynb"), *ROOT.glob("homework/*.ipynb")]),
    ids=lambda path: path.stem,
)
def test_every_notebook_of_the_course_tells_where_each_answer_stands(path):
    submission = read_submission(path)
    if submission.lesson:
        assert path.name.startswith(f"{submission.lesson.removeprefix('assignment_')}_")
        assert all(len(places) == 1 for places in submission.answered_in.values())
    else:
        assert path.name.startswith("00_")


def test_a_kernel_that_ends_as_it_starts_is_started_again(tmp_path):
    kernel = Kernel(tmp_path, tmp_path / "home", "02", ["target"], 2048)
    its_own, first = kernel._argv, tmp_path / "first"
    # as if another program had taken one of its ports: the first process ends at once
    once = f"import os, sys; os.path.exists({str(first)!r}) or sys.exit(open({str(first)!r}, 'w').close())"
    kernel._argv = [*its_own[:2], f"{once}; {its_own[2]}", *its_own[3:]]
    with kernel:
        assert kernel.run("1 / 0", 60)[0] == "ZeroDivisionError"
    assert first.exists()
    kernel._argv = [*its_own[:2], "pass", *its_own[3:]]
    with pytest.raises(EndedError, match="ends the whole kernel"):
        kernel.__enter__()
