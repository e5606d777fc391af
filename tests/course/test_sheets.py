"""What is told of a graded notebook: which cell, why points are missing, in words that a student can place."""

from __future__ import annotations

import csv
import io
from datetime import date

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_marks_and_students import LONGEST, NO_CAP, marked

from rlrobot_course.assignment_1 import check as check_1
from rlrobot_course.grading.detectors import DETECTORS
from rlrobot_course.homework.alike import alike
from rlrobot_course.homework.marks import Marked, Score
from rlrobot_course.homework.misunderstood import as_page, misunderstood
from rlrobot_course.homework.outputs import sheet_names
from rlrobot_course.homework.reports import as_sheet, as_text
from rlrobot_course.homework.students import Student
from rlrobot_course.homework.submission import Submission
from rlrobot_course.homework.tables import TABLES, reasons, table_for
from rlrobot_course.homework.told import in_words

CELLS = ["import numpy as np", "\n# target\ndef target(q)\n    return 0", "x = input('how many?')", "   \n"]
DAY = date(2026, 3, 2)


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
    assert told in in_words(said, CELLS)


@given(st.text("Code cel123,.py)(line <>\n“”", max_size=60), st.lists(st.text("ab \n(", max_size=20), max_size=3))
def test_whatever_is_said_of_whatever_cells_is_told(said, cells):
    assert isinstance(in_words(said, cells), str)


def a_score(
    mistake: str = "", hint: str = "", output: str = "✗ Case 1 of 4 differs.\n  called with x = 1", **more
) -> Score:
    return Score("target", 0.0, output, is_answered=more.pop("is_answered", True), mistake=mistake, hint=hint, **more)


BLANK = a_score(output="… This check waits for your answer: write target.", is_answered=False)
CRASHED = a_score(output="✗ Not answered. Code cell 5 stops with SyntaxError: no.", is_answered=False)


def test_tables_tell_students_hints_and_verdicts_and_never_the_name_of_a_detector():
    for name in (*DETECTORS, "exception", "spoilt", "form", "past_the_end"):
        one = Marked("a", "02", [a_score(name, "look at γ.")], student=Student("7"))
        assert reasons(one) == "target: look at γ."
        one = Marked("a", "02", [a_score(name)], student=Student("7"))
        assert reasons(one) == "target: Case 1 of 4 differs."
        assert all("target: Case 1 of 4 differs." in table_for(system, [one]) for system in ("plain", "moodle"))
    assert reasons(Marked("a", "02", [BLANK])) == "target: not answered yet"
    assert reasons(Marked("a", "02", [CRASHED])) == "target: Not answered. Code cell 5 stops with SyntaxError: no."


def test_what_was_not_graded_has_empty_cells_and_not_0_points_in_every_table():
    problem = "This is not a notebook that can be read."
    broken = Marked("in/b.ipynb", "02", [Score("target", 0.0, problem)], student=Student("7"), problem=problem)
    lost = Marked("in/c.ipynb", "", [Score("notebook", 0.0, problem)], student=Student("8"), problem=problem)
    whole = Marked("in/a.ipynb", "02", [Score("target", 1.0, "✓")], student=Student("1"))
    points = {"plain": "score", "canvas": "lesson 02", "moodle": "lesson 02", "gradescope": "Total Score"}
    for system in TABLES:
        rows = list(csv.DictReader(io.StringIO(table_for(system, [whole, broken, lost]))))[-3:]
        assert [row[points[system]] for row in rows] == ["1", "", ""]
        assert system not in ("plain", "moodle") or all(f"not graded: {problem}" in row.values() for row in rows[1:])
    assert as_text(broken).count(problem) == as_sheet(broken, {}, DAY).count(problem) == 1
    assert "0 of" not in as_sheet(broken, {}, DAY) and "not graded" in as_sheet(broken, {}, DAY)
    assert misunderstood([broken, lost]) == [] and "in 0 notebooks" in as_page([broken, lost])


def test_a_sheet_names_student_file_and_day_and_says_how_its_points_came_about():
    scores = [Score("period", 2.0, "✓ Right.", 2.0), BLANK, Score("drive", 0.0, "", 0.0)]
    one = Marked("in/1_a.ipynb", "assignment_4", scores, student=Student("7", "Ada", late=2), off=0.5)
    sheet = as_sheet(one, {}, DAY)
    assert sheet.startswith("# Ada (7), assignment 4: 1.5 of 3 points\n\n`1_a.ipynb`, graded on 2026-03-02.\n")
    assert "2 points for the answers; 2 days late: 0.5 points off." in sheet
    assert "- `target`: not answered yet, 0 of 1" in sheet and "waits for your answer" not in sheet + as_text(one)
    assert "- `drive`: does not count" in sheet


def test_sheets_are_named_for_the_student_and_as_the_system_takes_them_back():
    handed_in = [
        ("in/x.ipynb", "7", "02"),
        ("in/y.ipynb", "a/b@c", "assignment_1"),
        ("in/z.ipynb", "8", ""),
        ("in/lovelaceada_101_55501_02.ipynb", "101", "02"),
        ("in/Ada_123456_assignsubmission_file_/02.ipynb", "123456", "02"),
        ("in/ada/02.ipynb", "", "02"),
        ("in/again/x.ipynb", "7", "02"),
    ]
    assert list(sheet_names(handed_in)) == [
        "7_lesson_02.md", "a_b@c_assignment_1.md", "8.md", "lovelaceada_101_55501_02.md",
        "Ada_123456_assignsubmission_file_/02.md", "in__ada__02.md", "in__again__x.md",
    ]  # fmt: skip


def test_on_the_classs_page_answers_that_fit_no_known_mistake_are_together_only_if_they_were_told_the_same():
    told = [("exception", "look at the call of choose."), ("exception", "a loop in it never ends."),
            ("exception", "a loop in it never ends."), ("values", "a loop in it never ends."),
            ("past_the_end", "this looks past the end: 3."), ("past_the_end", "this looks past the end: 4."),
            ("", "")]  # fmt: skip
    found = misunderstood([Marked(f"{i}.ipynb", "02", [a_score(*one)]) for i, one in enumerate(told)])
    assert [(one.mistake, len(one.notebooks)) for one in found] == [
        ("not recognised", 3), ("past the end", 2), ("not recognised", 1), ("not recognised", 1),
    ]  # fmt: skip
    assert found[0].hint == "a loop in it never ends."


def test_an_exercise_that_does_not_count_is_no_misunderstanding():
    assert misunderstood([Marked("a", "02", [a_score("exception", max_score=0.0)])]) == []


def test_what_is_wrong_in_a_caller_itself_is_told_and_not_what_comes_of_a_wrong_function_that_it_calls():
    alone = marked(next_temperature=NO_CAP.replace("period(states)", "0"))["next_temperature"]
    crashes = "def period(states):\n    raise IndexError('of period')\n"
    score = marked(period=crashes, next_temperature=NO_CAP)["next_temperature"]
    assert score.score == 0 and "of period" not in score.output and score.lent == "period"
    assert "Judged with the right period" in score.output and alone.lent == ""


def test_the_hint_for_zeros_is_no_riddle():
    verdict = check_1.returns.judge(lambda rewards, gamma: np.zeros(len(rewards)))
    assert "0 times" not in repr(verdict)


SPLIT = Submission("split", "assignment_4", [LONGEST, "print('mine')", "check.period(period)"], {"period": [2]})
WHOLE = Submission("whole", "assignment_4", [f"{LONGEST}\ncheck.period(period)"], {"period": [0]})
AGAIN = Submission(
    "again", "assignment_4", [LONGEST, "def period(states):\n    ...\n\ncheck.period(period)"], {"period": [1]}
)
BEHIND = Submission("behind", "assignment_4", ["check.period(period)", LONGEST], {"period": [0]})


@pytest.mark.parametrize("other", [SPLIT, AGAIN, BEHIND])
def test_answers_are_alike_also_if_the_definition_stands_in_another_cell_than_its_check(other):
    (row,) = csv.DictReader(io.StringIO(alike([WHOLE, other])))
    assert row["exercise"] == "period" and row["notebooks"] == f"whole {other.name}"


def test_lambdas_are_alike_too_unless_they_are_short():
    text = "period = lambda states: next((p for p in range(9, 0, -1) if states[-p:] == states[-2 * p:-p]), 0)"
    ones = [Submission(name, "assignment_4", [text.replace("9", nine)], {"period": [0]}) for name, nine in
            [("a", "9"), ("b", "8"), ("c", "9")]]  # fmt: skip
    assert [row["notebooks"] for row in csv.DictReader(io.StringIO(alike(ones)))] == ["a c"]
    short = [Submission(name, "assignment_4", ["period = lambda states: 0"], {"period": [0]}) for name in "ab"]
    assert len(alike(short).splitlines()) == 1


def test_code_too_deep_to_be_compared_costs_no_other_answer():
    deep = Submission("deep", "assignment_4", [f"def period(x):\n    return {'-' * 600}x"], {"period": [0]})
    assert "whole split" in alike([deep, WHOLE, SPLIT])


def test_no_text_in_any_table_is_a_formula():
    evil = Marked("=1+1.ipynb", "02", [a_score("values", "=2+2")], student=Student("7"))
    assert "=2+2" not in [cell for row in csv.reader(io.StringIO(table_for("moodle", [evil]))) for cell in row]
    ones = [Submission(f"={name}", "assignment_4", [LONGEST], {"period": [0]}) for name in "ab"]
    assert "'=a =b" in alike(ones)
