"""Lists of students as real systems write them, and whose a notebook is by the names of files and folders."""

from __future__ import annotations

import codecs
import random
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rlrobot_grading.marking.attribution import owners_of
from rlrobot_grading.marking.marks import Rules, read_rules
from rlrobot_grading.marking.students import NOBODY, Student, read_students
from rlrobot_grading.marking.submission import Submission

CANVAS = """Student,ID,SIS User ID,SIS Login ID,Section,1 A robot's day (4711)
,,,,,Manual Posting
    Points Possible,,,,,5
"Lovelace, Ada",101,S9,ada,"Robotics, A",
"Student, Test",199,,0a1b2c,"Robotics, A",
"""
MOODLE = """Identifier,"Full name","Email address",Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (submission)","Last modified (grade)","Feedback comments"
"Participant 123456","Ada Lovelace",ada@uni.example,"Submitted for grading",,5.00,Yes,"Monday, 2 March 2026",-,
"""
SPANISH = """Identificador;"Nombre completo";"Dirección de correo";Estado;Calificación
"Participante 123456";"Ada Lovelace";ada@uni.example;"Enviado para calificar";
"""
GERMAN = """ID;Vollständiger Name;E-Mail-Adresse;Status
Teilnehmer/in123456;Ada Lovelace;ada@uni.example;Zur Bewertung abgegeben
"""
MOODLE_PEOPLE = "First name,Last name,ID number,Email address,Groups\nAda,Lovelace,7,ada@uni.example,\n"
GRADESCOPE = """First Name,Last Name,SID,Email,Role,Sections
Ada,Lovelace,7,ada@uni.example,Student,A
Charles,Babbage,,cb@uni.example,Instructor,
Luigi,Menabrea,,lm@uni.example,TA,
"""
PARTICIPANT = Student("123456", "Ada Lovelace", "ada@uni.example")


def a_roster(folder: Path, text: str | bytes) -> list[Student]:
    data = text.encode() if isinstance(text, str) else text
    (folder / "roster.csv").write_bytes(data)
    return read_students(str(folder / "roster.csv"))


@pytest.mark.parametrize(
    ("text", "student"),
    [
        ("id,name,late\ns1,Ada,1.5\n", Student("s1", "Ada", late=1.5)),
        ("id;name;late\ns1;Ada;1,5\n", Student("s1", "Ada", late=1.5)),
        ("sep=;\r\nID;Name\r\ns1;Ada\r\n", Student("s1", "Ada")),
        ("  ID \tFull  Name\n s1 \t Ada \n\n\t\n", Student("s1", "Ada")),
        ("id,name\rs1,Ada\r", Student("s1", "Ada")),
        ('id,name\n="007",Ada\n', Student("007", "Ada")),
        ("\ufeffid;name\r\ns1;Ada\r\n", Student("s1", "Ada")),
        ('"sep=;"\nid;name\ns1;Ada\n', Student("s1", "Ada")),
        ("Class of 2026\n\nid,name\ns1,Ada\n", Student("s1", "Ada")),
        ("id|name\ns1|Ada\n", Student("s1", "Ada")),
        (",id,name\n0,1234.0,Ada\n", Student("1234", "Ada")),
        ("id\u200b,name\n\ufeffs1,Ada\n\0\0", Student("s1", "Ada")),
        ("nu\u0301mero de id;nombre\ns1;Ada\n", Student("s1", "Ada")),
        ("Matrikelnummer;Vorname\n7;Ada\n", Student("7", "Ada")),
        ("id\ns1,,\n", Student("s1")),
        ("Name;Id\nLovelace, Ada;s1\n", Student("s1", "Lovelace, Ada")),
        (CANVAS, Student("101", "Lovelace, Ada")),
        (MOODLE, PARTICIPANT),
        (SPANISH, PARTICIPANT),
        (GERMAN, PARTICIPANT),
        (MOODLE_PEOPLE, Student("7", "Ada Lovelace", "ada@uni.example")),
        (GRADESCOPE, Student("7", "Ada Lovelace", "ada@uni.example")),
        ("Full name,Email address,ID number\nAda,a@x,7\n", Student("7", "Ada", "a@x")),
        ("Name,SID,Email\nAda,7,a@x\n", Student("7", "Ada", "a@x")),
        (
            "First name,Surname,ID number,Email address\nAda,Lovelace,,a@x\n",
            Student("a@x", "Ada Lovelace", "a@x"),
        ),
    ],
)
def test_lists_of_ones_own_and_those_that_systems_export_are_read(
    tmp_path, text, student
):
    assert a_roster(tmp_path, text) == [student]


UMLAUTS = "id\tname\ns1\tJürgen Müller\n"


@pytest.mark.parametrize(
    "data",
    [
        UMLAUTS.encode(),
        UMLAUTS.encode("utf-8-sig"),
        UMLAUTS.encode("latin-1"),
        UMLAUTS.encode("utf-16"),
        UMLAUTS.encode("utf-16-le"),
        UMLAUTS.encode("utf-16-be"),
        codecs.BOM_UTF16_BE + UMLAUTS.encode("utf-16-be"),
        UMLAUTS.replace("\n", "\r\n").encode("cp1252"),
    ],
)
def test_a_list_may_be_in_any_encoding_that_spreadsheets_and_shells_write(
    tmp_path, data
):
    assert a_roster(tmp_path, data) == [Student("s1", "Jürgen Müller")]
    (tmp_path / "rules.toml").write_bytes(
        "# für alle\nlate_off = 0.1\n".encode("utf-16")
    )
    assert read_rules(str(tmp_path / "rules.toml")).late_off == 0.1


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("id\n", "no student in it"),
        ("", "no student in it"),
        ("name\nAda\n", "line 2: a student has an id"),
        ("id,late\n1,soon\n", "line 2.*days from 0 on"),
        ("id,late\n1,-1\n", "line 2.*days from 0 on"),
        ("id,late\n1,nan\n", "line 2.*days from 0 on"),
        ("id\n1.23E+05\n", "line 2: a spreadsheet has rounded the id"),
        ("id\na\nb\nA \n", "line 4: the id A is there twice"),
        (
            "name,id\nLovelace, Ada,s1\n",
            "line 2: 3 cells, and the heading names 2 columns",
        ),
        (b"PK\x03\x04workbook", "workbook.*as CSV"),
        (b"\xff\xfei\0d\0\n\0a", "begins as utf-16, but is not"),
        ("id\n" + "a" * 200_000, "line 2: this is no CSV"),
        ("a" * 200_000, "line 1: this is no CSV"),
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
    "in/{id}_surname.ipynb",
    "in/surname_{id}_assignment_1.ipynb",
    "in/lovelaceada_{id}_55501_1_a_robots_day_as_numbers-2.ipynb",
    "in/lovelaceada_LATE_{id}_55501_1_a_robots_day_as_numbers.ipynb",
    "in/Ada Lovelace_{id}_assignsubmission_file_/1_a_robots_day_as_numbers.ipynb",
    "in/Ada Lovelace_{id}_assignsubmission_file_1_a_robots_day_as_numbers.ipynb",
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


@pytest.mark.parametrize(
    "copy", ["-2", " (2)", " 2", " copy 2", "_copy2", " - Kopie (2)", "–copia"]
)
def test_which_copy_it_is_is_no_id(copy):
    assert owners(FORTY, *(f"in/{id}/1_a_robots_day{copy}.ipynb" for id in "789")) == [
        "7",
        "8",
        "9",
    ]


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


def test_folders_of_moodle_are_named_by_its_number_also_if_the_list_has_an_id_of_its_own():
    ada = Student("7", "Ada", number="Participant 123456")
    assert owners(
        [ada, Student("8")],
        "in/Ada_123456_assignsubmission_file_/02.ipynb",
        "in/8.ipynb",
    ) == ["7", "8"]


def test_without_a_list_names_tell_students_apart_and_else_folders():
    assert owners([], "a/02.ipynb", "b/02.ipynb") == ["a", "b"]
    assert owners([], "a/x.ipynb", "b/y.ipynb") == ["x", "y"]
    assert owners([], "a/02.ipynb", "a/02-1.ipynb", "b/02.ipynb") == ["a", "a", "b"]
    assert owners([], "am/ada/02.ipynb", "pm/ada/02.ipynb") == ["am/ada", "pm/ada"]


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
