"""Marks where they are needed: students, rules, tables; what builds on a wrong answer; answers that are alike."""

from __future__ import annotations

import csv
import inspect
import io
from pathlib import Path
from types import SimpleNamespace

import pytest
from test_marks import Here

from rlrobot_course.assignment_4 import exercises
from rlrobot_course.grading.mistake import hinted
from rlrobot_course.homework import inside
from rlrobot_course.homework.alike import alike
from rlrobot_course.homework.marking import Marking
from rlrobot_course.homework.marks import Limits, Marked, Score
from rlrobot_course.homework.misunderstood import misunderstood
from rlrobot_course.homework.rules import NO_RULES, Rules, read_rules
from rlrobot_course.homework.students import Student
from rlrobot_course.homework.submission import Submission
from rlrobot_course.homework.tables import TABLES, table_for

LONGEST = """def period(states):
    n = len(states)
    return next((p for p in range(n // 2, 0, -1) if states[n - p:] == states[n - 2 * p:n - p]), 0)
"""
NO_CAP = """def next_temperature(temperature, states, rewards, default):
    p = period(states)
    return temperature + len(states) / (4 * p) if p and sum(rewards[-p:]) < 0 else default
"""
NEXT = inspect.getsource(exercises.next_temperature)


def marked(rules: Rules = NO_RULES, **answers: str) -> dict[str, Score]:
    """The scores of some answers to assignment 4, each in a cell, judged in this process."""
    cells = list(answers.values())
    places = {name: [list(answers).index(name)] if name in answers else [] for name in vars(exercises.check)}
    marking = Marking(Path(), Submission("it", "assignment_4", cells, places), 0, Limits(), rules)
    names: dict = {"check": SimpleNamespace(**{name: inside.Intake(name) for name in vars(exercises.check)})}
    for place, (name, source) in enumerate(answers.items()):
        exec(source, names)
        inside.answers[name] = names[name]
        marking._judged[name][place] = marking._judge(Here(), place, name, inside._described(names[name]))
    return {name: marking._score(name) for name in answers}


def test_what_calls_a_wrong_function_is_judged_with_the_right_one_and_says_so():
    scores = marked(period=LONGEST, next_temperature=NEXT)
    assert [score.score for score in scores.values()] == [0, 1]
    assert scores["next_temperature"].lent == "period"
    assert "Judged with the right period" in scores["next_temperature"].output
    assert inside.answers["next_temperature"].__globals__["period"] is inside.answers["period"], "it is taken back"


def test_with_the_right_function_in_its_place_a_wrong_answer_stays_wrong_and_a_right_one_needs_none():
    assert marked(period=LONGEST, next_temperature=NO_CAP)["next_temperature"].score == 0
    assert not marked(period=inspect.getsource(exercises.period), next_temperature=NEXT)["next_temperature"].lent


def test_points_parts_and_hints_count_as_the_rules_say():
    rules = Rules(points={"period": 4}, partial=True, hint_off=0.25)
    part = marked(rules, period=LONGEST)["period"]
    assert 2 < part.score < 4 and part.max_score == 4 and part.mistake == "longest" and "% of the cases" in part.output
    right = inspect.getsource(exercises.period) + "\ncheck.period.hint()\n"
    asked = (
        NEXT + "\ncheck.next_temperature.hint(2)\ncheck.next_temperature.hint(2)\n# check.next_temperature.hint(3)\n"
    )
    scores = marked(rules, period=right, next_temperature=asked)
    assert scores["next_temperature"].score == 0.75 and scores["period"].score == 3
    assert scores["period"].reason == "hints asked for"
    found = misunderstood([Marked("it", "assignment_4", list(scores.values()))])
    assert not found, "a hint is no misunderstanding"
    assert marked(Rules(partial=True), period="def period(states):\n    ...\n")["period"].score == 0


def test_late_days_cost_what_the_rules_say_and_no_more_than_the_most():
    rules = Rules(late_off=0.2, late_free=1, late_most=0.5)
    assert [rules.off(days, 5) for days in (0, 1, 2, 3, 9)] == [0, 0, 1, 2, 2.5]


@pytest.mark.parametrize(
    "text", ["points = 3", "late_off = -1", "late_off = true", "partial = 1", "late_of = 1", "a ="]
)
def test_what_is_no_rule_is_refused_by_name(tmp_path, text):
    (tmp_path / "rules.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"rules\.toml"):
        read_rules(str(tmp_path / "rules.toml"))


def test_rules_come_from_a_file(tmp_path):
    (tmp_path / "rules.toml").write_text("partial = true\nlate_off = 0.1\n[points]\ndrive = 3\n", encoding="utf-8")
    rules = read_rules(str(tmp_path / "rules.toml"))
    assert rules == Rules(points={"drive": 3}, partial=True, late_off=0.1) and rules.points_of("period") == 1


def a_class() -> list[Marked]:
    row = {"Student": "Ada", "ID": "101", "SIS User ID": "9", "SIS Login ID": "ada", "Section": "A"}
    scores = [Score("period", 0.5, "", 2, is_answered=True, mistake="longest"), Score("drive", 1, "", lent="period")]
    return [Marked("in/1.ipynb", "assignment_4", scores, student=Student("101", "Ada", "a@x", 2, row), off=0.25),
            Marked("in/2.ipynb", "assignment_4", scores, student=Student("=102", "Bob"))]  # fmt: skip


@pytest.mark.parametrize(
    ("system", "first", "ada"),
    [
        ("plain", "student,notebook,lesson,score,max_score,"
         "assignment_4:period,assignment_4:drive,days_late,off,reasons,notes",
         "101,in/1.ipynb,assignment_4,1.25,3,0.5,1,2,0.25,"
         "period: longest; drive: judged with the right period; 2 days late: 0.25 off,"),
        ("canvas", "Student,ID,SIS User ID,SIS Login ID,Section,assignment 4", "Ada,101,9,ada,A,1.25"),
        ("moodle", "ID number,Full name,Email address,assignment 4,assignment 4 feedback",
         "101,Ada,a@x,1.25,period: longest; drive: judged with the right period; 2 days late: 0.25 off"),
        ("gradescope", "Name,SID,Email,Total Score,Max Points,Lateness (H:M:S),1: period (2 pts),2: drive (1 pts)",
         "Ada,101,a@x,1.25,3,48:00:00,0.5,1"),
    ],
)  # fmt: skip
def test_a_table_has_the_columns_that_its_system_takes_in(system, first, ada):
    lines = table_for(system, a_class()).splitlines()
    assert lines[0] == first and ada in lines
    rows = list(csv.reader(io.StringIO("\n".join(lines))))
    assert len({len(row) for row in rows}) == 1 and "'=102" in rows[-1], "a spreadsheet would reckon with it"


def test_answers_that_are_alike_to_the_token_are_named_and_the_courses_own_too():
    places = {"period": [0], "next_temperature": [1]}
    ones = [
        Submission("a", "assignment_4", [LONGEST, NEXT], places),
        Submission("b", "assignment_4", [LONGEST.replace("  n =", "  'Mine.'  # mine\n    n ="), NEXT], places),
        Submission("c", "assignment_4", [LONGEST.replace("p ", "q ").replace(" p", " q"), "x ="], places),
    ]
    rows = list(csv.DictReader(io.StringIO(alike(ones))))
    assert [(row["exercise"], row["notebooks"], row["alike to the course's solution"]) for row in rows] == [
        ("period", "a b", "no"), ("next_temperature", "a b", "yes"),
    ]  # fmt: skip
    short = [
        Submission(name, "assignment_4", ["def period(states):\n    return 0\n"], {"period": [0]}) for name in "ab"
    ]
    assert len(alike(short).splitlines()) == 1, "anybody would write it so"


def test_in_homework_hints_can_be_fewer(monkeypatch):
    assert hinted(["a", "b", "c"], 3).text == "c"
    for most, told in (("1", "1 of 3"), ("0", "0 of 3")):
        monkeypatch.setenv("RLROBOT_EDU_HINTS", most)
        assert told in hinted(["a", "b", "c"], 2).text
    monkeypatch.setenv("RLROBOT_EDU_HINTS", "many")
    assert hinted(["a", "b", "c"], 3).text == "c"


def test_the_commands_systems_are_those_that_there_are_tables_for():
    from rlrobot_course.homework.options import SYSTEMS

    assert tuple(TABLES) == SYSTEMS
