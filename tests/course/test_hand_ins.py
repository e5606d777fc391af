"""Which files are graded and which count: files of the system, copies, what vanishes, what is overwritten."""

from __future__ import annotations

import csv
import glob
import os
import random
import re
import sys
import tempfile
import warnings
import zipfile
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rlrobot_course.homework import COURSE
from rlrobot_grading.marking import grade as grade_module
from rlrobot_grading.marking.guard import Guard
from rlrobot_grading.marking.handed_in import handed_in
from rlrobot_grading.marking.marks import NO_RULES, Limits, Marked, Score
from rlrobot_grading.marking.one_notebook import mark_file
from rlrobot_grading.marking.submission import read_submission

APPLE_DOUBLE = bytes.fromhex("00051607000200004d6163204f532058")
ZIP = b"PK\x03\x04 and so on"
HEAD = "from rlrobot_course.lesson_03 import check"
TRUSTED = Limits(guard=Guard(trust=True))
grade = partial(grade_module.grade, limits=TRUSTED)


def notebook(path: Path, points: int) -> Path:
    """A notebook of lesson 03 to which the stand-in of the grader gives so many points."""
    path.parent.mkdir(parents=True, exist_ok=True)
    cells = [nbformat.v4.new_code_cell(text) for text in (HEAD, f"# {points} points")]
    for i, cell in enumerate(cells):
        cell.id = f"c{i}"
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
    return path


def stand_in(course, paths, lesson, *_):
    """What `marked_files` does, without a kernel."""
    for path in paths:
        submission = read_submission(course, path, lesson)
        if submission.problem:
            yield mark_file(course, path, lesson, 0, Limits(), NO_RULES)
            continue
        points = int(re.search(r"# (\d) points", submission.cells[1])[1])
        names = list(course.exercises_of("03"))
        yield Marked(str(path), "03", [
            Score(name, float(i < points), "✗ No.", is_answered=True) for i, name in enumerate(names)
        ])  # fmt: skip


@pytest.fixture(autouse=True)
def _without_a_kernel(monkeypatch, tmp_path):
    monkeypatch.setattr(grade_module, "marked_files", stand_in)
    monkeypatch.setattr(
        grade_module, "Digests", lambda course: SimpleNamespace(check=lambda name: None)
    )
    monkeypatch.chdir(tmp_path)


def rows(path: str = "points.csv") -> list[dict[str, str]]:
    return list(csv.DictReader(Path(path).read_text(encoding="utf-8").splitlines()))


def test_a_name_may_be_a_file_a_folder_or_a_pattern(tmp_path):
    for name in (
        "b/two.ipynb",
        "a.ipynb",
        "b/.ipynb_checkpoints/two.ipynb",
        "b/other.txt",
        "c/THREE.IPYNB",
    ):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    all_three = [
        tmp_path / name for name in ("a.ipynb", "b/two.ipynb", "c/THREE.IPYNB")
    ]

    def found(*names: str) -> list[Path]:
        with tempfile.TemporaryDirectory() as folder:
            notebooks, _ = handed_in(
                [str(tmp_path / name) for name in names], Path(folder)
            )
            return [one.path for one in notebooks]

    assert found("") == all_three and found("a.ipynb") == all_three[:1]
    assert found("*.ipynb") == all_three[:1] and found("**/t*.ipynb") == all_three[1:2]
    assert found("[ac]*") == [all_three[0], all_three[2]], (
        "a folder that a pattern stands for is looked into"
    )
    assert found("b", "b/two.ipynb", "b/../b/two.ipynb", "a.ipynb") == [
        all_three[1],
        all_three[0],
    ], "each once"
    for nothing in ("d", "*.nothing"):
        with pytest.raises(FileNotFoundError, match="there is no such file"):
            found(nothing)
    assert found("a.ipynb", "b/.ipynb_checkpoints") == all_three[:1]
    (tmp_path / "empty").mkdir()
    with pytest.raises(FileNotFoundError, match="there is no notebook in it"):
        found("empty")


OF_THE_SYSTEM = (
    "__MACOSX/s1/._02.ipynb",
    "s1/._02.ipynb",
    "s1/.DS_Store",
    "s1/.ipynb_checkpoints/02-checkpoint.ipynb",
)


@pytest.mark.parametrize("asked", ["in", "in/*", "in/**/*", "every file by its name"])
def test_files_of_the_system_are_no_hand_ins(tmp_path, asked):
    notebook(tmp_path / "in/s1/02.ipynb", 3)
    for name in OF_THE_SYSTEM:
        (tmp_path / "in" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "in" / name).write_bytes(APPLE_DOUBLE)
    (tmp_path / "roster.csv").write_text("id\ns1\ns2\n", encoding="utf-8")
    names = [
        str(path.relative_to(tmp_path))
        for path in (tmp_path / "in").rglob("*")
        if path.is_file()
    ]
    assert (
        grade(
            COURSE,
            names if asked.startswith("every") else [asked],
            roster="roster.csv",
            csv="points.csv",
            seed=1,
        )
        == 1
    )
    assert [(row["id"], row["score"]) for row in rows()] == [
        ("s1", "3"),
        ("s2", ""),
    ]


def test_files_that_are_no_notebooks_are_named_but_not_the_graders_own(
    tmp_path, capsys
):
    notebook(tmp_path / "in/s1/02.ipynb", 4)
    for name in ("s2/work.zip", "s3/02.pages"):
        (tmp_path / "in" / name).parent.mkdir()
        (tmp_path / "in" / name).write_bytes(ZIP)
    (tmp_path / "in/roster.csv").write_text("id\ns1\ns2\ns3\n", encoding="utf-8")
    for _ in range(2):  # the second time with its own reports in the folder
        assert (
            grade(
                COURSE,
                ["in"],
                roster="in/roster.csv",
                csv="in/points.csv",
                feedback="in/sheets",
                seed=1,
            )
            == 0
        )
        said = capsys.readouterr().out
        assert "end in .ipynb: in/s2/work.zip, in/s3/02.pages." in said
        assert "There is no notebook of s2, s3." in said
    assert [row["reasons"] for row in rows("in/points.csv")][1:] == [
        "not graded: No notebook was handed in."
    ] * 2


def test_of_two_notebooks_of_a_student_the_better_counts_and_every_report_has_one(
    tmp_path, capsys
):
    notebook(tmp_path / "in/s1/02.ipynb", 1)
    notebook(tmp_path / "in/s1/02-1.ipynb", 3)
    (tmp_path / "in/s1/02-2.ipynb").write_bytes(b"\x89PNG")
    notebook(tmp_path / "in/s2/02.ipynb", 2)
    (tmp_path / "roster.csv").write_text("id,name\ns2,Bob\ns1,Ada\n", encoding="utf-8")
    reports = {"csv": "points.csv", "mistakes": "m.csv", "feedback": "sheets"}
    assert grade(COURSE, ["in"], roster="roster.csv", seed=1, **reports) == 1
    told = (
        "3 notebooks of s1: the one with the most points counts, in/s1/02-1.ipynb (3), and not "
        "in/s1/02-2.ipynb (not graded) nor in/s1/02.ipynb (1)."
    )
    assert told in capsys.readouterr().out
    assert [(row["id"], row["score"]) for row in rows()] == [("s2", "2"), ("s1", "3")]
    assert told in rows()[-1]["notes"]
    assert set(os.listdir("sheets")) == {"s1_lesson_03.md", "s2_lesson_03.md"}
    assert rows("m.csv")[-1]["how many"] == "2"


def test_of_resubmissions_with_the_same_points_the_last_counts(tmp_path):
    for name in ("02.ipynb", "02-9.ipynb", "02-10.ipynb"):
        notebook(tmp_path / "in/s1" / name, 2)
    (tmp_path / "roster.csv").write_text("id\ns1\n", encoding="utf-8")
    grade(COURSE, ["in"], roster="roster.csv", csv="points.csv", seed=1)
    assert [row["notebook"] for row in rows()] == ["in/s1/02-10.ipynb"]


PLACES = ("in/{id}/03_q_learning.ipynb", "in/{id}/my work.ipynb")


@settings(
    max_examples=25,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(data=st.data())
def test_in_any_order_and_among_any_files_of_the_system_each_student_has_one_row_with_the_same_points(
    data, tmp_path_factory, monkeypatch
):
    monkeypatch.chdir(tmp_path_factory.mktemp("class"))
    best: dict[str, int] = {}
    place = data.draw(st.sampled_from(PLACES))
    for student in data.draw(
        st.lists(st.sampled_from(range(1, 13)), min_size=3, max_size=6, unique=True)
    ):
        file = Path(place.format(id=student))
        for again, points in enumerate(
            data.draw(st.lists(st.integers(0, 4), min_size=1, max_size=3))
        ):
            notebook(file.with_stem(f"{file.stem}{f'-{again}' * bool(again)}"), points)
            best[str(student)] = max(best.get(str(student), 0), points)
        for name in data.draw(st.sets(st.sampled_from(OF_THE_SYSTEM))):
            junk = file.parent / name
            junk.parent.mkdir(parents=True, exist_ok=True)
            junk.write_bytes(APPLE_DOUBLE)
    Path("roster.csv").write_text(
        "id\n" + "".join(f"{i}\n" for i in range(1, 13)), encoding="utf-8"
    )
    names = [str(path) for path in Path("in").rglob("*") if path.is_file()]
    tables = []
    for asked in (["in"], names, random.Random(1).sample(names, len(names))):
        grade(COURSE, asked, roster="roster.csv", csv="points.csv", seed=1)
        tables.append(Path("points.csv").read_text(encoding="utf-8"))
    assert tables[0] == tables[1] == tables[2]
    assert {row["id"]: row["score"] for row in rows()} == {
        str(i): str(best.get(str(i), "")) for i in range(1, 13)
    }
    assert len(rows()) == 12


@pytest.mark.parametrize("what", ["vanishes", "changes"])
def test_a_notebook_that_changes_or_vanishes_meanwhile_counts_as_it_was(
    tmp_path, monkeypatch, what
):
    first = notebook(tmp_path / "in/s1.ipynb", 4)
    notebook(tmp_path / "in/s2.ipynb", 4)

    def meanwhile(*arguments):
        first.unlink() if what == "vanishes" else notebook(first, 0)
        yield from stand_in(*arguments)

    monkeypatch.setattr(grade_module, "marked_files", meanwhile)
    reports = {"csv": "p.csv", "mistakes": "m.csv", "feedback": "sheets"}
    assert grade(COURSE, ["in"], seed=1, **reports) == 0
    assert (
        all(Path(path).exists() for path in reports.values())
        and len(list(Path("sheets").iterdir())) == 2
    )
    assert [row["score"] for row in rows("p.csv")] == ["4", "4"]


def test_a_file_that_cannot_be_read_costs_no_other(tmp_path):
    notebook(tmp_path / "in/s1.ipynb", 4)
    (tmp_path / "in/s2.ipynb").symlink_to(tmp_path / "nowhere.ipynb")
    assert grade(COURSE, ["in"], csv="points.csv", seed=1) == 1
    assert [row["score"] for row in rows()] == ["4", ""]
    assert "is a link to" in rows()[1]["reasons"]


@pytest.mark.skipif(
    os.name == "nt" or sys.platform == "darwin",
    reason="names of files are Unicode here",
)
def test_a_name_in_another_encoding_costs_no_report(tmp_path):
    notebook(tmp_path / "s1.ipynb", 4)
    for i, name in enumerate((b"caf\xe9.ipynb", b"caf\xe8.ipynb")):
        os.rename(notebook(tmp_path / f"x{i}.ipynb", i), name)
    reports = {"csv": "p.csv", "mistakes": "m.csv", "feedback": "sheets"}
    assert grade(COURSE, ["."], seed=1, **reports) == 1
    assert (
        sorted(row["score"] for row in rows("p.csv")) == ["0", "1", "4"]
        and len(os.listdir("sheets")) == 3
    )


def test_a_folder_that_is_a_link_is_not_passed_over_in_silence(tmp_path, capsys):
    notebook(tmp_path / "elsewhere/s2.ipynb", 4)
    notebook(tmp_path / "in/s1.ipynb", 4)
    (tmp_path / "in/s2").symlink_to(tmp_path / "elsewhere")
    assert grade(COURSE, ["in"], seed=1) == 0
    assert "since these are links: in/s2." in capsys.readouterr().out


def a_link(path: Path, ann: Path) -> None:
    path.symlink_to(ann)


def a_relative_link(path: Path, ann: Path) -> None:
    path.symlink_to(os.path.relpath(ann, path.parent))


def a_link_to_a_link(path: Path, ann: Path) -> None:
    path.with_name("between").symlink_to(ann)
    path.symlink_to("between")


def a_hard_link(path: Path, ann: Path) -> None:
    path.hardlink_to(ann)


def a_pipe(path: Path, ann: Path) -> None:
    os.mkfifo(path)


def a_folder_that_is_a_link(path: Path, ann: Path) -> None:
    path.parent.rmdir()
    path.parent.symlink_to(ann.parent)


NOT_ONES_OWN = (a_link, a_relative_link, a_link_to_a_link, a_hard_link, a_pipe)


@pytest.mark.skipif(os.name == "nt", reason="Windows has other links, and no pipes")
@pytest.mark.parametrize("asked", ["in", "in/*", "in/*/*.ipynb", "in/**/*.ipynb"])
@pytest.mark.parametrize(
    "made", [*NOT_ONES_OWN, a_folder_that_is_a_link], ids=lambda made: made.__name__
)
@pytest.mark.parametrize("where", ["the same class", "elsewhere"])
@pytest.mark.parametrize("by_the_shell", [False, True], ids=["pattern", "names"])
def test_what_is_no_file_of_ones_own_gets_no_points_and_a_word(
    tmp_path, made, asked, where, by_the_shell, capsys
):
    notebook(tmp_path / "in/cid/x.ipynb", 3)
    folder = "in/ann" if where == "the same class" else "home/ann"
    ann = notebook(tmp_path / folder / "x.ipynb", 4)
    (tmp_path / "in/bob").mkdir()
    made(tmp_path / "in/bob/x.ipynb", ann)
    names = [asked]
    if by_the_shell:
        names = sorted(glob.glob(asked, recursive=True))
    grade(COURSE, names, csv="points.csv", seed=1)
    points = {Path(row["notebook"]).parts[1]: row["score"] for row in rows()}
    said = capsys.readouterr().out
    assert points["cid"] == "3"
    if made is a_hard_link and where == "elsewhere":
        # as good as a copy, but for the note: he could read it
        assert "2 names on this computer" in said
    else:
        assert points.get("bob", "") == ""
        assert re.search(r"in/bob(/x\.ipynb)?\b", said)
    if where == "the same class" and made is not a_hard_link:
        assert points["ann"] == "4"


@pytest.mark.skipif(os.name == "nt", reason="links need rights on Windows")
def test_the_teachers_own_folder_may_be_a_link(tmp_path):
    notebook(tmp_path / "disk/ann/x.ipynb", 4)
    notebook(tmp_path / "disk/bob/x.ipynb", 3)
    (tmp_path / "in").symlink_to(tmp_path / "disk")
    for names in (["in"], ["in/*"], ["in/ann", "in/bob"]):
        grade(COURSE, names, csv="points.csv", seed=1)
        assert [row["score"] for row in rows()] == ["4", "3"]


@pytest.mark.skipif(os.name == "nt", reason="links need rights on Windows")
def test_a_file_that_becomes_a_link_while_it_is_looked_at_is_not_followed(
    tmp_path, monkeypatch
):
    notebook(tmp_path / "ann.ipynb", 4)
    (tmp_path / "in").mkdir()
    (tmp_path / "in/bob.ipynb").symlink_to(tmp_path / "ann.ipynb")
    monkeypatch.setattr(Path, "is_symlink", lambda path: False)
    (one,), _ = handed_in(["in"], tmp_path / "in")
    assert one.fault and not one.copy.exists()


def test_an_archive_is_named_and_not_opened_whatever_is_in_it(tmp_path, capsys):
    notebook(tmp_path / "in/ann.ipynb", 4)
    source = (tmp_path / "in/ann.ipynb").read_text(encoding="utf-8")
    with zipfile.ZipFile(tmp_path / "in/bob.zip", "w") as archive:
        for name in ("bob.ipynb", "bob.ipynb", "../bob.ipynb", "/tmp/bob.ipynb"):
            with warnings.catch_warnings(action="ignore"):  # of the second of one name
                archive.writestr(name, source)
    grade(COURSE, ["in"], csv="points.csv", seed=1)
    assert [row["id"] for row in rows()] == ["ann"]
    assert "no files that end in .ipynb: in/bob.zip." in capsys.readouterr().out


def test_a_grading_without_a_guard_needs_a_word_of_trust_before_anything_runs(
    tmp_path, capsys
):
    notebook(tmp_path / "s1.ipynb", 4)
    for limits in (None, Limits()):
        with pytest.raises(ValueError, match=r"--container .* --user .* --trust"):
            grade(COURSE, ["s1.ipynb"], csv="points.csv", limits=limits)
    assert capsys.readouterr().out == "" and not Path("points.csv").exists()


def test_students_whose_folders_differ_in_their_capitals_alone_are_two(tmp_path):
    notebook(tmp_path / "in/a/Kim/02.ipynb", 4)
    if (tmp_path / "in/A").exists():
        pytest.skip("this file system knows no capitals")
    notebook(tmp_path / "in/A/Kim/02.ipynb", 3)
    grade(COURSE, ["in"], csv="points.csv", seed=1)
    assert len(rows()) == 2


@pytest.mark.parametrize("text", ["[]", '{"cells": 3}', '{"cells": [1]}', "{}", "7"])
def test_a_file_of_another_form_is_told_in_words_and_not_in_pythons(tmp_path, text):
    (tmp_path / "s1.ipynb").write_text(text, encoding="utf-8")
    assert read_submission(COURSE, tmp_path / "s1.ipynb", "03").problem == (
        "This is not a notebook that can be read (it has no cells where a notebook has them)."
    )


def test_a_report_that_cannot_be_made_costs_no_other(tmp_path, capsys, monkeypatch):
    notebook(tmp_path / "s1.ipynb", 4)

    def fails(*_):
        raise RecursionError("too deep")

    monkeypatch.setattr(grade_module, "mistakes_table", fails)
    assert (
        grade(
            COURSE,
            ["s1.ipynb"],
            csv="p.csv",
            mistakes="m.csv",
            feedback="sheets",
            seed=1,
        )
        == 2
    )
    assert (
        "m.csv could not be written: RecursionError: too deep"
        in capsys.readouterr().err
    )
    assert {"p.csv", "sheets"} <= set(os.listdir()) and not Path("m.csv").exists()


REPORTS = ("csv", "mistakes")
WAYS = (
    "itself",
    "another way to write it",
    "a link to it",
    "through a folder's link",
)


@pytest.mark.parametrize("report", REPORTS)
@pytest.mark.parametrize("of", ["s1.ipynb", "roster.csv", "rules.toml"])
@pytest.mark.parametrize("way", WAYS)
def test_a_report_over_an_input_is_refused_before_anything_runs(
    tmp_path, report, of, way, capsys
):
    notebook(tmp_path / "s1.ipynb", 4)
    (tmp_path / "roster.csv").write_text("id\ns1\n", encoding="utf-8")
    (tmp_path / "rules.toml").write_text("late_off = 0.1\n", encoding="utf-8")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    path = of
    if way == WAYS[1]:
        path = f"../{tmp_path.name}/./{of}"
    elif way == WAYS[2]:
        Path(path := "link").symlink_to(of)
    elif way == WAYS[3]:
        Path("folder").symlink_to(tmp_path)
        path = f"folder/{of}"
    with pytest.raises(
        ValueError,
        match=rf"--{report} .* would be written over .*{of}",
    ):
        grade(
            COURSE,
            ["s1.ipynb"],
            roster="roster.csv",
            rules="rules.toml",
            seed=1,
            **{report: path},
        )
    assert {name: (tmp_path / name).read_bytes() for name in before} == before
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("reports", "told"),
    [
        ({"csv": "a", "mistakes": "b/../a"}, "--mistakes b/../a would be written over"),
        ({"csv": "a", "feedback": "a"}, "--feedback a would be written over a"),
        ({"csv": "folder"}, "this is a folder"),
        ({"feedback": "file"}, "this is a file, not a folder"),
    ],
)
def test_paths_that_cannot_be_meant_are_refused_before_anything_runs(
    tmp_path, reports, told, capsys
):
    notebook(tmp_path / "s1.ipynb", 4)
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder/s1.md").write_text("id\ns1\n", encoding="utf-8")
    with pytest.raises(ValueError, match=re.escape(told)):
        grade(COURSE, ["s1.ipynb"], seed=1, **reports)
    assert (
        capsys.readouterr().out == ""
        and (tmp_path / "folder/s1.md").read_text(encoding="utf-8") == "id\ns1\n"
    )


@pytest.mark.parametrize(
    "limits",
    [Limits(seconds=float(text)) for text in ("inf", "nan", "-inf", "0", "1e300")]
    + [Limits(memory=memory) for memory in (0, 255, 2**40)],
)
def test_limits_are_finite_numbers(tmp_path, limits):
    notebook(tmp_path / "s1.ipynb", 4)
    with pytest.raises(ValueError, match=r"must be (above 0|at least 256)"):
        grade(COURSE, ["s1.ipynb"], limits=limits, seed=1)


def test_points_for_an_exercise_that_is_not_there_are_named(tmp_path, capsys):
    notebook(tmp_path / "s1.ipynb", 4)
    (tmp_path / "rules.toml").write_text(
        "[points]\ntarget = 2\ntraget = 2\n", encoding="utf-8"
    )
    grade(COURSE, ["s1.ipynb"], rules="rules.toml", seed=1)
    assert "rules.toml: no exercise here is called traget." in capsys.readouterr().out


@pytest.mark.parametrize("name", ["mine.ipynb", "02_mine.ipynb"])
def test_a_notebook_of_another_year_is_told_so_whatever_its_name(tmp_path, name):
    theirs = nbformat.v4.new_code_cell("from rlrobot_edu.course.lesson_02 import check")
    ours = nbformat.v4.new_code_cell(HEAD)
    path = tmp_path / name
    nbformat.write(nbformat.v4.new_notebook(cells=[theirs]), path)
    old = read_submission(COURSE, path)
    assert old.lesson == "" and "a notebook of another year" in old.problem
    assert "rlrobot_edu.course.lesson_02.check" in old.problem
    nbformat.write(nbformat.v4.new_notebook(cells=[theirs, ours]), path)
    assert read_submission(COURSE, path).lesson == "03"
