"""What is told of graded notebooks: text, sheets, tables, and a class's mistakes."""

from __future__ import annotations

import csv
import io
from datetime import date

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rlrobot_course.homework import COURSE
from rlrobot_grading.hints.detectors import DETECTORS
from rlrobot_grading.marking.marks import Marked, Score
from rlrobot_grading.marking.misunderstood import mistakes_table, misunderstood
from rlrobot_grading.marking.reports import as_sheet, as_text, cells_shown, sheet_names
from rlrobot_grading.marking.students import Student
from rlrobot_grading.marking.tables import points_table, reasons

CELLS = [
    "import numpy as np",
    "\n# target\ndef target(q)\n    return 0",
    "x = input('how many?')",
    "   \n",
]
DAY = date(2026, 3, 2)


def read(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Code cell 1 changes the checks.", "Code cell 1 (“import numpy as np”) changes the checks."),
        ("answered in the code cells 1, 3; the last",
         "cells 1 (“import numpy as np”), 3 (“x = input('how many?')”); the last"),
        ("Code cell 2 stops with SyntaxError: expected ':' (190330142.py, line 3)",
         "Code cell 2 (“# target”) stops with SyntaxError: expected ':', in its line 3 (“def target(q)”)"),
        ("Code cell 3 stops with EOFError: EOF when reading a line",
         "it asks with input(), and nobody is there to type"),
        ("Code cell 3 stops with StdinNotImplementedError: raw_input was called, but this frontend does not support "
         "input requests.", "it asks with input(), and nobody is there to type"),
        ("Code cell 4 is endless", "Code cell 4 is endless"),
        ("Code cell 99 is endless (1.py, line 7)", "Code cell 99 is endless (1.py, line 7)"),
    ],
)  # fmt: skip
def test_a_cell_is_told_by_its_first_line_and_an_error_by_its_own(said, told):
    assert told in cells_shown(said, CELLS)


@given(
    st.text("Code cel123,.py)(line <>\n“”", max_size=60),
    st.lists(st.text("ab \n(", max_size=20), max_size=3),
)
def test_whatever_is_said_of_whatever_cells_is_told(said, cells):
    assert isinstance(cells_shown(said, cells), str)


# --- tables


def a_class() -> list[Marked]:
    scores = [
        Score("period", 0.5, "", 2, is_answered=True, mistake="longest"),
        Score("drive", 1, "", substituted="period"),
    ]
    return [Marked("in/1.ipynb", "assignment_4", scores, student=Student("101", "Ada", 2), off=0.25),
            Marked("in/2.ipynb", "assignment_4", scores, student=Student("=102", "Bob"))]  # fmt: skip


def test_the_table_of_points_has_a_line_for_each_student_and_no_formula():
    lines = points_table(a_class()).splitlines()
    assert lines[0] == (
        "id,name,notebook,lesson,score,max_score,assignment_4:period,assignment_4:drive,days_late,off,reasons,notes"
    )
    assert lines[1] == (
        "101,Ada,in/1.ipynb,assignment_4,1.25,3,0.5,1,2,0.25,"
        "period: longest; drive: judged with the right period; 2 days late: 0.25 off,"
    )
    assert lines[2].startswith("'=102"), "a spreadsheet would reckon with it"


def a_score(
    mistake: str = "",
    hint: str = "",
    output: str = "✗ Case 1 of 4 differs.\n  called with x = 1",
    **more,
) -> Score:
    return Score(
        "target",
        0.0,
        output,
        is_answered=more.pop("is_answered", True),
        mistake=mistake,
        hint=hint,
        **more,
    )


BLANK = a_score(
    output="… This check waits for your answer: write target.", is_answered=False
)
CRASHED = a_score(
    output="✗ Not answered. Code cell 5 stops with SyntaxError: no.", is_answered=False
)


def test_tables_tell_students_hints_and_verdicts_and_never_the_name_of_a_detector():
    for name in (*DETECTORS, "exception", "spoilt", "form", "past_the_end"):
        one = Marked("a", "03", [a_score(name, "look at γ.")], student=Student("7"))
        assert reasons(one) == "target: look at γ."
        one = Marked("a", "03", [a_score(name)], student=Student("7"))
        assert reasons(one) == "target: Case 1 of 4 differs."
        assert "target: Case 1 of 4 differs." in points_table([one])
    assert reasons(Marked("a", "03", [BLANK])) == "target: not answered yet"
    assert (
        reasons(Marked("a", "03", [CRASHED]))
        == "target: Not answered. Code cell 5 stops with SyntaxError: no."
    )


def test_what_was_not_graded_has_empty_cells_and_not_0_points_in_every_table():
    problem = "This is not a notebook that can be read."
    broken = Marked(
        "in/b.ipynb",
        "03",
        [Score("target", 0.0, problem)],
        student=Student("7"),
        problem=problem,
    )
    lost = Marked(
        "in/c.ipynb",
        "",
        [Score("notebook", 0.0, problem)],
        student=Student("8"),
        problem=problem,
    )
    whole = Marked(
        "in/a.ipynb", "03", [Score("target", 1.0, "✓")], student=Student("1")
    )
    rows = read(points_table([whole, broken, lost]))
    assert [row["score"] for row in rows] == ["1", "", ""]
    for row in rows[1:]:
        assert row["reasons"] == f"not graded: {problem}"
    assert (
        as_text(broken).count(problem) == as_sheet(broken, {}, DAY).count(problem) == 1
    )
    assert "0 of" not in as_sheet(broken, {}, DAY) and "not graded" in as_sheet(
        broken, {}, DAY
    )
    assert misunderstood(COURSE, [broken, lost]) == []


def test_no_text_in_any_table_is_a_formula():
    evil = Marked("=1+1.ipynb", "03", [a_score("values", "=2+2")], student=Student("7"))
    assert "=2+2" not in [
        cell for row in csv.reader(io.StringIO(points_table([evil]))) for cell in row
    ]


# --- sheets


def test_a_sheet_names_student_file_and_day_and_says_how_its_points_came_about():
    scores = [
        Score("period", 2.0, "✓ Right.", 2.0),
        BLANK,
        Score("drive", 0.0, "", 0.0),
        a_score("x", "y", "✗ No."),
    ]
    one = Marked(
        "in/1_a.ipynb",
        "assignment_4",
        scores,
        student=Student("7", "Ada", late=2),
        off=0.5,
    )
    sheet = as_sheet(one, {"target": "3. The target"}, DAY)
    assert sheet.startswith(
        "# Ada (7), assignment 4: 1.5 of 4 points\n\n`1_a.ipynb`, graded on 2026-03-02.\n"
    )
    for told in ("2 points for the answers; 2 days late: 0.5 points off.", "- `period`: right",
                 "- `target`: not answered yet, 0 of 1", "- `drive`: does not count", "✗ No.",
                 "To look at again: *3. The target*, in your notebook."):  # fmt: skip
        assert told in sheet
    assert "waits for your answer" not in sheet + as_text(one)


def test_sheets_are_named_for_the_student_and_the_lesson_and_none_is_there_twice():
    named = {
        ("in/x.ipynb", "7", "03"): "7_lesson_03.md",
        ("in/y.ipynb", "a/b@c", "assignment_1"): "a_b@c_assignment_1.md",
        ("in/z.ipynb", "8", ""): "8.md",
        ("in/ada/02.ipynb", "", "03"): "02_lesson_03.md",
        ("in/bob/02.ipynb", "", "03"): "02_lesson_03_2.md",
    }
    marked = [
        Marked(name, lesson, [], student=Student(id)) for name, id, lesson in named
    ]
    assert list(sheet_names(marked)) == list(named.values())


# --- what a class has misunderstood

PAST, GAMMA = (
    ("past_the_end", "nothing follows a <terminal> state."),
    ("no_gamma", "γ is missing: 3 is not 2.7."),
)
SLIPS = {
    3: PAST,
    5: PAST,
    8: PAST,
    1: GAMMA,
    9: ("no_gamma", "γ is missing: 4 is not 3.6."),
    7: ("", ""),
}


def made_up(n: int) -> list[Marked]:
    """A class of n in lesson 03, whose `target` is right but for SLIPS, and whose `q_by_hand` is never answered."""
    return [
        Marked(f"student_{i}.ipynb", "03", [
            a_score(*SLIPS[i]) if i in SLIPS else Score("target", 1.0, "✓", is_answered=True),
            Score("q_by_hand", 0.0, "…"),
        ]) for i in range(n)
    ]  # fmt: skip


def test_every_mistake_is_counted_once_for_each_notebook_that_made_it():
    found = misunderstood(COURSE, made_up(40))
    told = [(one.exercise, one.mistake, len(one.notebooks)) for one in found]
    assert told == [("target", "past the end", 3), ("target", "no gamma", 2), ("target", "not recognised", 1),
                    ("q_by_hand", "not answered", 40)]  # fmt: skip
    assert found[0].notebooks == [
        "student_3.ipynb",
        "student_5.ipynb",
        "student_8.ipynb",
    ]
    assert found[0].hint == PAST[1] and found[1].hint in (
        GAMMA[1],
        "γ is missing: 4 is not 3.6.",
    )


def test_the_table_names_the_notebooks_that_made_a_mistake():
    table = read(mistakes_table(COURSE, made_up(40)))
    assert [row["how many"] for row in table] == ["3", "2", "1", "40"]
    assert (
        table[1]["notebooks"] == "student_1.ipynb student_9.ipynb"
        and table[1]["mistake"] == "no gamma"
    )


def test_who_understood_all_or_was_asked_nothing_that_counts_has_misunderstood_nothing():
    right = [Marked("one.ipynb", "03", [Score("target", 1.0, "✓", is_answered=True)])]
    assert (
        misunderstood(COURSE, right) == []
        and mistakes_table(COURSE, right).count("\n") == 1
    )
    assert (
        misunderstood(
            COURSE, [Marked("a", "03", [a_score("exception", max_score=0.0)])]
        )
        == []
    )


def test_answers_that_fit_no_known_mistake_are_together_if_they_were_told_the_same_or_by_one_detector():
    told = [("exception", "look at the call of choose."), ("exception", "a loop in it never ends."),
            ("exception", "a loop in it never ends."), ("one_change", "it answers as if “n” were 0."),
            ("one_change", "it answers as if “k” were 0."), ("one_change", "it answers as if “k” were 0."),
            ("past_the_end", "this looks past the end: 3."), ("past_the_end", "this looks past the end: 4."),
            ("", "")]  # fmt: skip
    found = misunderstood(
        COURSE,
        [Marked(f"{i}.ipynb", "03", [a_score(*one)]) for i, one in enumerate(told)],
    )
    assert [(one.mistake, len(one.notebooks)) for one in found] == [
        ("not recognised", 3), ("not recognised", 2), ("past the end", 2), ("not recognised", 1), ("not recognised", 1),
    ]  # fmt: skip
    assert [one.hint for one in found[:2]] == [
        "it answers as if “k” were 0.",
        "a loop in it never ends.",
    ]
