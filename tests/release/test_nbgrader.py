"""make homework, end to end through nbgrader: export, hand out, hand in, autograde, feedback."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path

import nbformat
import numpy as np
import pytest
from test_grade import ANSWERS, BY_HEART, PAST_THE_END, TAMPERED

from rlrobot_course.authoring.lists import lessons
from rlrobot_grading.marking.nbgrader_course import export, solution_of, source_of
from rlrobot_grading.marking.submission import exercises_of, read_submission

ROOT = Path(__file__).parents[2]
NOTEBOOKS = [
    path
    for path in sorted(
        [*lessons(ROOT).values(), *ROOT.glob("notebooks/homework/*.ipynb")]
    )
    if read_submission(path).lesson
]
SEED, NAME = 918273645546372819, "03_q_learning"
needs_nbgrader = pytest.mark.skipif(
    importlib.util.find_spec("nbgrader") is None,
    reason="needs nbgrader: pip install 'rlrobot-edu[teach]'",
)


def parts(notebook) -> dict:
    """The cells that nbgrader knows, by their names."""
    return {
        cell.metadata.nbgrader.grade_id: cell
        for cell in notebook.cells
        if "nbgrader" in cell.metadata
    }


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_the_instructors_version_holds_a_right_answer_to_each_exercise(path):
    lesson = read_submission(path).lesson
    cells, here = parts(source_of(path)), {"np": np}
    for name, exercise in exercises_of(lesson).items():
        answer, test = cells[f"{name}-answer"], cells[name]
        exec(answer.source, here)
        assert getattr(exercise, "judge", exercise)(here[name]), name
        assert (
            solution_of(name, lesson) in answer.source
            and not answer.metadata.nbgrader.locked
        )
        assert test.metadata.nbgrader.locked and test.metadata.nbgrader.points == 1


def test_without_the_judge_an_exported_test_gives_no_points():
    test = parts(source_of(ROOT / f"notebooks/{NAME}.ipynb"))["target"]
    with pytest.raises(AssertionError, match=r"nbgrader_config\.py"):
        exec(test.source.partition("\n")[2])


def test_a_notebook_without_exercises_is_refused_before_anything_is_written(tmp_path):
    nbformat.write(
        nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("1 + 1")]),
        tmp_path / "mine.ipynb",
    )
    with pytest.raises(ValueError, match="no cell imports the check"):
        export([tmp_path / "mine.ipynb"], tmp_path / "course")
    assert not (tmp_path / "course").exists()


def test_an_exercise_that_is_not_checked_in_a_cell_of_its_own_is_refused(tmp_path):
    notebook = nbformat.read(ROOT / f"notebooks/{NAME}.ipynb", as_version=4)
    notebook.cells = [
        cell for cell in notebook.cells if "check.learn(" not in cell.source
    ]
    nbformat.write(notebook, tmp_path / f"{NAME}.ipynb")
    with pytest.raises(
        ValueError, match=r"one cell must end with check\.learn\(learn\), not 0"
    ):
        source_of(tmp_path / f"{NAME}.ipynb")


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ("c.Judge.seed = 1\n", "has a seed already"),
        ("c.Exchange = 1\n", "belongs to another course"),
    ],
)
def test_settings_that_are_there_are_not_overwritten(tmp_path, settings, told):
    (tmp_path / "nbgrader_config.py").write_text(settings, encoding="utf-8")
    with pytest.raises(FileExistsError, match=told):
        export([ROOT / f"notebooks/{NAME}.ipynb"], tmp_path, seed=2)
    assert (tmp_path / "nbgrader_config.py").read_text(encoding="utf-8") == settings


@needs_nbgrader
def test_the_answer_in_words_has_points_and_a_rubric_and_rules_and_hints_are_the_instructors(
    tmp_path,
):
    (tmp_path / "rules.toml").write_text("[points]\nstate_of = 3\n", encoding="utf-8")
    name = "1_a_robots_day_as_numbers"
    export(
        [ROOT / f"notebooks/homework/{name}.ipynb"],
        tmp_path / "course",
        seed=1,
        hints=1,
        rules=str(tmp_path / "rules.toml"),
    )
    source, release = (
        nbformat.read(tmp_path / "course" / room / name / f"{name}.ipynb", as_version=4)
        for room in ("source", "release")
    )
    words = parts(source)["in-words"]
    assert (
        words.metadata.nbgrader.points == words.source.count("\n- ") == 4
        and "The border runs" in words.source
    )
    handed_out = nbformat.writes(release)
    assert (
        "The border runs" not in handed_out
        and "SOLUTION" not in handed_out
        and "RLROBOT_EDU_HINTS=1" in handed_out
    )
    assert "Your answer" in parts(release)["in-words"].source
    assert parts(release)["state_of"].metadata.nbgrader.points == 3
    assert "rules.toml" in (tmp_path / "course" / "nbgrader_config.py").read_text(
        encoding="utf-8"
    )


# How a learner changes the released notebook: a function that gets it, and its cells by name.


def answered(**changed: str) -> Callable:
    def fill(notebook, cells):
        for name, answer in (ANSWERS | changed).items():
            cells[f"{name}-answer"].source = answer

    return fill


def tamper(notebook, cells):
    answered(target=PAST_THE_END)(notebook, cells)
    notebook.cells.insert(2, nbformat.v4.new_code_cell(TAMPERED))
    cells["target"].source = "print('✓ Right in all 10 cases.')"
    cells["target"].metadata.nbgrader.points = 100
    cells["update"].metadata.nbgrader.grade = False
    cells["learn"].metadata.nbgrader = {"grade_id": ["what"]}


def delete(notebook, cells):
    answered()(notebook, cells)
    for name in ("target", "learn-answer", "learn"):
        notebook.cells.remove(cells[name])


def double(notebook, cells):
    answered()(notebook, cells)
    twice = deepcopy([cells["target-answer"], cells["target"]])
    twice[0].source = PAST_THE_END
    for cell in twice:
        cell.id = f"{cell.id}-again"
    notebook.cells += twice


# What the grader makes of other submissions is tested in test_grade.py: each change, the exercises without a point, and
# what the feedback says.
HANDED_IN: dict[str, tuple[Callable, tuple[str, ...], str]] = {
    "right": (answered(), (), "Right in all"),
    "blank": (
        lambda notebook, cells: None,
        tuple(exercises_of("03")),
        "waits for your answer",
    ),
    "by_heart": (
        answered(target=BY_HEART),
        ("target",),
        "Right with the notebook's numbers, but not with others",
    ),
    "tampered": (tamper, ("target",), "this looks past the end"),
    "deleted": (delete, ("learn",), "no cell defines learn"),
    "doubled": (double, ("target",), "; the last one counts"),
}
LINES_OF_SOLUTIONS = [
    "gamma * max(q[s_next])",
    "s_next, r, terminated, truncated = env.step(a)",
]


def nbgrader(folder: Path, *arguments: str) -> subprocess.CompletedProcess:
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return subprocess.run(
        [sys.executable, "-m", "nbgrader", *arguments], cwd=folder, env=os.environ | {"PATH": path},
        capture_output=True, text=True, timeout=600,
    )  # fmt: skip


GRADES = """
import json
from nbgrader.api import Gradebook

with Gradebook("sqlite:///gradebook.db") as gradebook:
    handed_in = [gradebook.find_submission_notebook(NAME, NAME, student).grades for student in STUDENTS]
    scores = [{grade.name: [grade.score, grade.needs_manual_grade] for grade in grades} for grades in handed_in]
    print(json.dumps(scores))
"""


@pytest.fixture(scope="module")
def grades(course) -> dict[str, dict]:
    """Score and need of a grader of each exercise, by students. In a process of its own: nbgrader imports setuptools,
    which refuses a process in which anything has imported distutils before."""
    names = f"NAME, STUDENTS = {NAME!r}, {list(HANDED_IN)}"
    told = subprocess.run(
        [sys.executable, "-c", names + GRADES],
        cwd=course,
        stdout=subprocess.PIPE,
        check=True,
    )
    return dict(zip(HANDED_IN, json.loads(told.stdout), strict=True))


@pytest.fixture(scope="module")
def course(tmp_path_factory) -> Path:
    """A course folder in which all has been done, from the export to the feedback."""
    folder = tmp_path_factory.mktemp("course")
    lesson = nbformat.read(ROOT / f"notebooks/{NAME}.ipynb", as_version=4)
    lesson.cells = [
        cell
        for cell in lesson.cells
        if cell.cell_type == "code" and "check" in cell.source
    ]  # a short one
    nbformat.write(lesson, folder / f"{NAME}.ipynb")
    assert export([folder / f"{NAME}.ipynb"], folder, SEED) == [NAME]
    settings = folder / "nbgrader_config.py"
    settings.write_text(
        settings.read_text(encoding="utf-8").replace(
            "seconds = 300.0", "seconds = 60.0"
        ),
        encoding="utf-8",
    )
    for student, (change, *_) in HANDED_IN.items():
        notebook = nbformat.read(folder / f"release/{NAME}/{NAME}.ipynb", as_version=4)
        change(notebook, parts(notebook))
        path = folder / f"submitted/{student}/{NAME}/{NAME}.ipynb"
        path.parent.mkdir(parents=True)
        path.write_text(nbformat.writes(notebook), encoding="utf-8")
    path = folder / f"submitted/a_picture/{NAME}/{NAME}.ipynb"
    path.parent.mkdir(parents=True)
    path.write_bytes(b"\x89PNG no notebook")
    (folder / "log").write_text(
        nbgrader(folder, "autograde", NAME).stderr, encoding="utf-8"
    )
    assert nbgrader(folder, "generate_feedback", NAME).returncode == 0
    return folder


@needs_nbgrader
def test_what_is_handed_out_is_the_lessons_cells_without_answers(course):
    lesson = nbformat.read(course / f"{NAME}.ipynb", as_version=4)
    released = nbformat.read(course / f"release/{NAME}/{NAME}.ipynb", as_version=4)
    here, there = (
        "\n".join(cell.source for cell in notebook.cells)
        for notebook in (lesson, released)
    )
    assert re.sub(r"\n+", "\n", here) == re.sub(r"\n+", "\n", there)
    assert {
        path.name for path in (course / "release").rglob("*") if path.is_file()
    } == {f"{NAME}.ipynb"}
    for name, cell in parts(released).items():
        assert cell.metadata.get("editable", True) is name.endswith("-answer")


def feedback(course: Path, student: str) -> str:
    """What a learner can read in the feedback, and in what stands behind it."""
    page = (course / f"feedback/{student}/{NAME}/{NAME}.html").read_text(
        encoding="utf-8"
    )
    return re.sub(
        r"<(style|script)\b.*?</\1>|<[^>]*>", "", page, flags=re.DOTALL
    ).replace("&#39;", "'")


@needs_nbgrader
@pytest.mark.parametrize("student", HANDED_IN)
def test_each_submission_gets_the_points_that_it_deserves_and_the_feedback_says_why(
    course, grades, student
):
    _, lost, told = HANDED_IN[student]
    assert grades[student] == {
        name: [name not in lost, False] for name in exercises_of("03")
    }
    assert told in " ".join(feedback(course, student).split())


@needs_nbgrader
def test_a_file_that_is_no_notebook_is_named_and_stops_no_other(course):
    log = (course / "log").read_text(encoding="utf-8")
    assert set(
        re.findall(r"error processing assignment '.*' for student '(\w+)'", log)
    ) == {"a_picture"}
    assert {path.name for path in (course / "feedback").iterdir()} == set(HANDED_IN)


@needs_nbgrader
def test_neither_seed_nor_hidden_tests_stand_in_what_learners_get(course):
    files = [
        path
        for place in ("release", "feedback", "autograded")
        for path in course.glob(f"{place}/**/{NAME}.*")
    ]
    assert len(files) == 1 + 2 * len(HANDED_IN)
    for path in files:
        text = path.read_text(encoding="utf-8")
        assert not [
            word
            for word in (str(SEED), "HIDDEN TEST", "SOLUTION", "not judged")
            if word in text
        ], path
    unanswered = [
        path for path in files if "release" in path.parts or "blank" in path.parts
    ]
    for path in unanswered:
        text = path.read_text(encoding="utf-8")
        assert not [line for line in LINES_OF_SOLUTIONS if line in text], path


@needs_nbgrader
def test_a_failed_hidden_test_tells_no_number_of_its_tape(course):
    notebook = nbformat.read(
        course / f"autograded/by_heart/{NAME}/{NAME}.ipynb", as_version=4
    )
    told = str(parts(notebook)["target"].outputs)
    assert "not with others" in told and not any(sign.isdigit() for sign in told)
