"""Lists of students, and who handed in which notebook by the names of files and folders."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rlrobot_grading.marking.attribution import owners_of
from rlrobot_grading.marking.marks import Rules, read_rules
from rlrobot_grading.marking.students import NOBODY, Student, read_students
from rlrobot_grading.marking.submission import Submission


def a_roster(folder: Path, text: str | bytes) -> list[Student]:
    data = text.encode() if isinstance(text, str) else text
    (folder / "roster.csv").write_bytes(data)
    return read_students(str(folder / "roster.csv"))


@pytest.mark.parametrize(
    ("text", "student"),
    [
        ("id,name,late\ns1,Ada,1.5\n", Student("s1", "Ada", late=1.5)),
        ("id;name;late\ns1;Ada;1,5\n", Student("s1", "Ada", late=1.5)),
        ("  ID \tName\n s1 \t Ada \n\n\t\n", Student("s1", "Ada")),
        ("id,name\rs1,Ada\r", Student("s1", "Ada")),
        ("\ufeffid;name\r\ns1;Ada\r\n", Student("s1", "Ada")),
        ("id\ns1\n", Student("s1")),
        ('Name,Group,Id\n"Lovelace, Ada",B,s1\n', Student("s1", "Lovelace, Ada")),
        ("id,name\ns1,Jürgen\n".encode("cp1252"), Student("s1", "Jürgen")),
    ],
)
def test_a_list_may_have_its_columns_in_any_order_and_any_usual_separator(
    tmp_path, text, student
):
    assert a_roster(tmp_path, text) == [student]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("id\n", "no student in it"),
        ("", "is empty"),
        ("name\nAda\n", "no column id"),
        ("id,name\n,Ada\n", "line 2: a student has an id"),
        ("id,late\n1,soon\n", "line 2.*days from 0 on"),
        ("id,late\n1,-1\n", "line 2.*days from 0 on"),
        ("id,late\n1,nan\n", "line 2.*days from 0 on"),
        ("id\n1.23E+05\n", "line 2: a spreadsheet has rounded the id"),
        ("id\na\nb\nA \n", "line 4: the id A is there twice"),
        ("name,id\nLovelace, Ada,s1\n", "line 2: it has more cells"),
        (b"PK\x03\x04workbook", "no column id"),
        ("id\n" + "a" * 200_000, "this is no CSV"),
    ],
)
def test_a_list_that_cannot_be_right_is_refused_with_file_and_line(
    tmp_path, text, told
):
    with pytest.raises(ValueError, match=rf"roster\.csv.*{told}"):
        a_roster(tmp_path, text)


@given(
    st.binary(max_size=300)
    | st.text("id,;\t\n\r\"'=a1 \0", max_size=60).map(str.encode)
)
def test_whatever_the_list_is_it_names_students_or_is_refused_in_a_sentence(
    tmp_path_factory, data
):
    try:
        students = a_roster(tmp_path_factory.mktemp("roster"), data)
    except ValueError as error:
        assert "roster.csv" in str(error) and "\n" not in str(error).strip()
    else:
        assert all(student.id for student in students)
        assert len({student.id.lower() for student in students}) == len(students)


def owners(
    students: list[str] | list[Student],
    *names: str,
    lesson: str = "assignment_1",
    made_for: str = "",
):
    """The ids of the owners of notebooks with these names; empty for nobody's."""
    known = [Student(one) if isinstance(one, str) else one for one in students]
    return [
        owner.student.id
        for owner in owners_of(
            [Submission(name, lesson, made_for=made_for) for name in names], known
        )
    ]


FORTY = [str(i) for i in range(1, 41)]
LAYOUTS = (
    "in/{id}/1_a_robots_day_as_numbers.ipynb",
    "in/{id}/1_a_robots_day_as_numbers-1.ipynb",
    "in/{id}/my work (2).ipynb",
    "in/1_a_robots_day_as_numbers_{id}.ipynb",
    "in/{id}_1_a_robots_day_as_numbers.ipynb",
    "in/surname_{id}.ipynb",
    "in/surname_{id}_assignment_1.ipynb",
    "submitted/{id}/1_a_robots_day_as_numbers/1_a_robots_day_as_numbers.ipynb",
    "week 3/{id}/1_a_robots_day_as_numbers.ipynb",
    "1/{id}/1_a_robots_day_as_numbers.ipynb",
)


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize(
    "ids",
    [FORTY, [f"{i:02}" for i in range(1, 41)], [f"S{i:03}" for i in range(1, 41)]],
)
def test_a_class_is_told_apart_in_every_layout_also_by_ids_that_are_numbers_of_assignments(
    layout, ids
):
    names = [layout.format(id=one) for one in ids]
    assert owners(ids, *names) == ids
    shuffled = random.Random(1).sample(list(zip(ids, names, strict=True)), len(ids))
    assert owners(ids, *(name for _, name in shuffled)) == [one for one, _ in shuffled]


def test_one_students_five_assignments_are_this_students():
    titles = {
        "assignment_1": "1_a_robots_day",
        "assignment_2": "2_on_or_off_policy",
        "02": "03_q_learning",
    }
    handed_in = [
        Submission(f"in/7/{title}.ipynb", lesson) for lesson, title in titles.items()
    ]
    assert [
        owner.student.id for owner in owners_of(handed_in, list(map(Student, FORTY)))
    ] == ["7", "7", "7"]
    assert owners(FORTY, "in/7/1_a_robots_day.ipynb") == ["7"]


def test_the_number_of_the_assignment_alone_is_nobodys_id():
    assert owners(FORTY, "in/1_a_robots_day.ipynb", "in/7/1_a_robots_day.ipynb") == [
        "",
        "7",
    ]
    with pytest.raises(ValueError, match="no id of a student is in its name"):
        owners(FORTY, "in/1_a_robots_day.ipynb")


def test_of_ids_that_contain_each_other_the_longer_counts():
    assert owners(["ada", "ada-marie", "s1", "s1-2"], "in/ada-marie.ipynb", "in/ada.ipynb", "in/s1-2.ipynb") == [
        "ada-marie", "ada", "s1-2",
    ]  # fmt: skip


def test_an_id_is_a_word_in_any_case_and_any_form_of_its_letters():
    students = ["s1", "s10", "jürgen"]
    names = ["in/smith_S1_42_02.ipynb", "in/s10/02.ipynb", "in/Ju\u0308rgen.ipynb"]
    assert owners(students, *names) == students


def test_what_does_not_tell_is_nobodys_and_a_note_says_why():
    submissions = [
        Submission(name, "02")
        for name in ("in/02.ipynb", "in/s1_s10.ipynb", "in/s1/s10.ipynb")
    ]
    nobodys, two, folder = owners_of(submissions, [Student("s1"), Student("s10")])
    assert nobodys.student is two.student is NOBODY
    assert (
        "No id of a student" in nobodys.note
        and "s1 and s10 are both in its name" in two.note
    )
    assert folder.student.id in ("s1", "s10") and "in its name, too" in folder.note


def test_a_renamed_notebook_is_the_students_for_whom_it_was_made():
    (owner,) = owners_of(
        [Submission("in/mine.ipynb", "02", made_for="S2")],
        [Student("s1"), Student("s2")],
    )
    assert owner.student.id == "s2" and "made for s2" in owner.note


def test_a_notebook_that_was_made_for_another_student_is_noted():
    (owner,) = owners_of(
        [Submission("in/s1.ipynb", "02", made_for="s2")], [Student("s1"), Student("s2")]
    )
    assert owner.student.id == "s1"
    assert "made for s2, not for s1" in owner.note


def test_without_a_list_names_of_files_distinguish_students_and_else_paths():
    assert owners([], "a/x.ipynb", "b/y.ipynb") == ["x", "y"]
    assert owners([], "a/02.ipynb", "b/02.ipynb") == ["a/02", "b/02"]


def test_late_days_cost_what_the_rules_say_and_no_more_than_the_most():
    rules = Rules(late_off=0.2, late_free=1, late_most=0.5)
    assert [rules.off(days, 5) for days in (0, 1, 2, 3, 9)] == [0, 0, 1, 2, 2.5]


@pytest.mark.parametrize(
    "text",
    [
        "points = 3",
        "late_off = -1",
        "late_off = true",
        "partial = 1",
        "late_of = 1",
        "a =",
        "late_off = 10",
        "hint_off = 1.5",
        "late_most = 50",
        "late_off = inf",
        "hint_off = nan",
    ],
)
def test_what_is_no_rule_is_refused_by_name(tmp_path, text):
    (tmp_path / "rules.toml").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=r"rules\.toml"):
        read_rules(str(tmp_path / "rules.toml"))


def test_rules_come_from_a_file(tmp_path):
    (tmp_path / "rules.toml").write_text(
        "partial = true\nlate_off = 0.1\n[points]\ndrive = 3\n", encoding="utf-8"
    )
    rules = read_rules(str(tmp_path / "rules.toml"))
    assert (
        rules == Rules(points={"drive": 3}, partial=True, late_off=0.1)
        and rules.points_of("period") == 1
    )
