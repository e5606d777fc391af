"""What is read off a cell and off a file: syntax, not text; and files as other programs write them."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_grade import HEAD, cells, write

from rlrobot_course.homework import COURSE
from rlrobot_grading.marking import cell, submission
from rlrobot_grading.marking.submission import read_submission, sections_of

pytest.importorskip("nbformat")
pytest.importorskip("IPython")

LESSON = "rlrobot_course.lesson_03"
MAGICS = (
    "%%time\n",
    "%%capture out\n%%time\n",
    "%matplotlib inline\n",
    "!ls\n",
    "files = !ls\n",
    "x?\n",
    "\n\n%%time\n",
    "%%memory_of_an_extension\n",
    "?x\n",
    "!pip install x\n",
)


@pytest.mark.parametrize("magic", ["", *MAGICS])
def test_below_magics_a_cell_is_read_as_without_them(magic):
    source = f"{magic}from {LESSON} import (\n    check,\n)\nuse_variant(check, 's1')\n"
    source += "def f(): return g()\ncheck.f(f)\ncheck.f.hint(2)"
    assert cell.lessons_imported(source, "rlrobot_course") == ["lesson_03"]
    assert cell.made_for(source) == "s1"
    assert "f" in cell.bound(source)
    assert cell.handed_in(source) == {"f"}
    assert cell.hints_asked([source], "f") == 1
    assert "g" in cell.calls_in([source])["f"]
    assert cell.changes_checks(f"{magic}check.f = print") and not cell.changes_checks(
        source
    )


CODE = (
    f"from {LESSON} import check", "check.f(f)", "use_variant(check, 's1')", "check.f.hint(1)", "def f(): return 1",
    "check.f = print", "f = 1",
)  # fmt: skip
AS_TEXT = (
    "# {}",
    "'''\n{}\n'''",
    'x = """{}"""',
    "print({!r})",
    "%%writefile x.py\n{}",
    "x = 1  # {}",
    "x = ({}",
    "%%html\n{}",
    "%%time\n%%bash\n{}",
    "get_ipython().run_cell_magic('writefile', 'x.py', {!r})",
)


@pytest.mark.parametrize("code", CODE)
@pytest.mark.parametrize("text", AS_TEXT)
def test_code_in_a_comment_a_text_or_what_cannot_be_read_says_nothing(code, text):
    source = text.format(code)
    assert (
        cell.lessons_imported(source, "rlrobot_course") == []
        and cell.made_for(source) == ""
        and cell.handed_in(source) == set()
    )
    assert "f" not in cell.bound(source) and cell.hints_asked([source], "f") == 0
    assert not cell.changes_checks(source)


@settings(max_examples=200, deadline=None)
@given(
    st.text(alphabet=st.sampled_from("%!?#'\"\\\n\r\t\0 ()=[]{}:@.,abcheck.f\ud800é"))
)
def test_any_text_can_be_asked_about(source):
    assert isinstance(cell.bound(source), set) and isinstance(
        cell.handed_in(source), set
    )
    assert cell.hints_asked([source], "f") >= 0 and cell.made_for(source) is not None
    (
        cell.changes_checks(source),
        cell.calls_in([source]),
        cell.lessons_imported(source, "rlrobot_course"),
        cell.exercise_in_last_line(source),
    )


DEEP = "1" + "+1" * 3000
MADE_TO_BREAK = (
    "(" * 5000, "1" + "+1" * 20_000, "%time 1\n" * 5000, "x" + ".a" * 3000 + "()", f"check.f.hint({DEEP})",
    f"use_variant(check, {DEEP})", f"def f():\n    return {DEEP}", f"check.f({DEEP})", "check" + ".f" * 3000 + " = 1",
)  # fmt: skip


@pytest.mark.parametrize("source", MADE_TO_BREAK, ids=range(len(MADE_TO_BREAK)))
def test_a_cell_that_is_made_to_break_the_reading_does_not(tmp_path, source):
    one = read_submission(COURSE, write(tmp_path / "x.ipynb", [HEAD, source]))
    assert (
        one.lesson == "03" and one.answered_by(0, []) is not None and one.called_by("f")
    )
    (
        cell.hints_asked([source], "f"),
        cell.changes_checks(source),
    )


@pytest.mark.parametrize(
    ("define", "is_bound"),
    [
        ("def f(): pass", True), ("async def f(): pass", True), ("class f: pass", True),
        ("if True:\n    def f(): pass", True),
        ("try:\n    f = 1\nfinally:\n    pass", True), ("with x:\n    f: int = 1", True), ("(f := 1)", True),
        ("a, (f, b) = x", True),
        ("from x import g as f", True), ("f = lambda: 0", True), ("@y\ndef f(): pass", True),
        ("def g():\n    f = 1", False), ("class g:\n    f = 1", False), ("[f for f in x]", False), ("f(1)", False),
        ("f = take('03', 'f')", False), ("def f(): return take('03', 'g')", True),
    ],
)  # fmt: skip
def test_what_a_cell_binds(define, is_bound):
    assert ("f" in cell.bound(define)) == is_bound


def test_checks_are_known_by_their_name_wherever_they_come_from():
    for call in ("check.f(f)", "lesson_03.check.f(f)", "check.f(answer=f)"):
        assert cell.handed_in(call) == {"f"}
    assert cell.handed_in("robot.f(f)") == set()


def test_the_last_line_of_a_cell_of_the_course_is_its_check():
    last = cell.exercise_in_last_line
    assert last("f = 1\n\ncheck.f(f)") == last("check.f(f)\n\n# the end\n") == "f"
    for source in (
        "check.f(g)",
        "check.f(f)\n1",
        "# check.f(f)",
        "'''\ncheck.f(f)'''",
        "check.f(f",
        "",
    ):
        assert last(source) == ""


def as_json(sources, **more):
    """A notebook with the least that Jupyter's format wants; more: of the notebook."""
    parts = [{"cell_type": "markdown", "source": ["# The ", "heading"]}]
    parts += [
        {"cell_type": "code", "source": source, "outputs": [], "metadata": {}}
        for source in sources
    ]
    return {"cells": parts, "metadata": {}, "nbformat": 4, "nbformat_minor": 5} | more


def with_cells(**more):
    """Each code cell with more, or without what is "no"."""

    def changed(sources):
        told = as_json(sources)
        told["cells"][1:] = [
            {k: v for k, v in (cell | more).items() if v != "no"}
            for cell in told["cells"][1:]
        ]
        return json.dumps(told)

    return changed


WRITTEN = {
    "with the least": lambda sources: json.dumps({"cells": as_json(sources)["cells"]}),
    "format 5": lambda sources: json.dumps(as_json(sources, nbformat=5)),
    "texts in lists": lambda sources: json.dumps(as_json([source.splitlines(True) for source in sources])),
    "no metadata": with_cells(metadata="no"),
    "outputs null": with_cells(outputs=None),
    "ids that are twice there": with_cells(id="a"),
    "Colab": with_cells(metadata={"id": "x", "cellView": "form", "colab": {"base_uri": "https://x"}}),
    "VS Code": with_cells(metadata={"vscode": {"languageId": "python"}}),
    "Deepnote": with_cells(metadata={"cell_id": "x", "deepnote_cell_type": "code"}, block_group="x"),
    "another kind of cell": lambda sources: json.dumps(as_json(sources) | {
        "cells": [*as_json(sources)["cells"], {"cell_type": "sql"}, {"cell_type": "code", "source": None}]}),
    "mark in each cell": lambda sources: json.dumps(as_json([f"\ufeff{source}" for source in sources])),
}  # fmt: skip


@pytest.mark.parametrize("program", WRITTEN)
def test_a_notebook_is_read_as_any_program_writes_it(tmp_path, program):
    (tmp_path / "x.ipynb").write_text(
        WRITTEN[program](list(cells().values())), encoding="utf-8"
    )
    one = read_submission(COURSE, tmp_path / "x.ipynb")
    assert (one.lesson, [source for source in one.cells if source], one.problem) == (
        "03",
        list(cells().values()),
        "",
    )
    assert set(sections_of(tmp_path / "x.ipynb").values()) == {"The heading"}


@pytest.mark.parametrize(("text", "told"), [("", "empty"), ("\n \0", "empty"), ("<html>", "Expecting value"),
                                            ("[1]", "not a notebook"), ('"{}"', "not a notebook")])  # fmt: skip
def test_what_is_no_notebook_is_told_in_a_sentence(tmp_path, text, told):
    (tmp_path / "x.ipynb").write_text(text, encoding="utf-8")
    assert told in read_submission(COURSE, tmp_path / "x.ipynb").problem


@pytest.mark.parametrize(
    "encoding",
    ["utf-8", "utf-8-sig", "cp1252"],
)
def test_a_notebook_is_read_in_each_encoding(tmp_path, encoding):
    text = json.dumps(as_json([*cells().values(), "# é"]), ensure_ascii=False)
    (tmp_path / "x.ipynb").write_bytes(text.encode(encoding))
    assert read_submission(COURSE, tmp_path / "x.ipynb").cells == [
        *cells().values(),
        "# é",
    ]


def test_outputs_do_not_count_and_what_is_too_large_is_told_what_to_do(
    tmp_path, monkeypatch
):
    path = tmp_path / "x.ipynb"
    output = {"output_type": "stream", "text": "a film " * 2_000_000}
    path.write_text(
        with_cells(outputs=[output])(list(cells().values())), encoding="utf-8"
    )
    assert path.stat().st_size > 66 * 2**20
    assert read_submission(COURSE, path).cells == list(cells().values())
    monkeypatch.setattr(submission, "LARGEST", 1 << 20)
    assert (
        "more than 1 MB: choose “Clear Outputs of All Cells”"
        in read_submission(COURSE, path).problem
    )


def test_the_last_cell_that_runs_is_the_last_that_may_answer(tmp_path):
    more = ["def unrelated(): pass", "1 / 0"]
    for sources in (
        cells(), cells() | {"target": cells()["target"], "above": "check.target(target)"},
        {"head": HEAD, "above": "check.learn(learn)"} | cells(),
    ):  # fmt: skip
        one = read_submission(
            COURSE, write(tmp_path / "x.ipynb", [*sources.values(), *more])
        )
        assert one.last_cell == len(sources)


@pytest.mark.parametrize(
    ("name", "source", "lesson"),
    [
        ("mine", "from rlrobot_course.assignment_2 import check", "assignment_2"),
        ("1_mine", "1 + 1", "assignment_1"),
        ("02_mine", "1 + 1", "02"),
        ("1_mine", "from rlrobot_course.lesson_07 import check", "07"),
        ("9_mine", "1 + 1", ""),
    ],
)
def test_an_import_tells_the_lesson_or_the_assignment_and_else_the_name_of_the_file(
    tmp_path, name, source, lesson
):
    assert (
        read_submission(COURSE, write(tmp_path / f"{name}.ipynb", [source])).lesson
        == lesson
    )
