"""The students of a class, from a list of one's own or as Canvas, Moodle and Gradescope export it."""

from __future__ import annotations

import csv
import io
import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from rlrobot_grading.marking.text import INVISIBLE, text_of

# What a column is called: in a list of one's own, and in those that Canvas, Moodle (in four languages) and Gradescope
# export. The first that is there and filled counts.
COLUMNS = {
    "id": (
        "id", "sid", "student id", "student number", "id number", "número de id", "id-nummer", "matrikelnummer",
        "numéro d'identification", "matricola", "matrícula", "username", "login", "roster_identifier",
    ),
    "number": ("identifier", "identificador", "identificatore", "identifiant", "id"),
    "name": (
        "name", "student", "full name", "nombre completo", "nome completo", "vollständiger name", "nom complet",
    ),
    "first": ("first name", "firstname", "first", "given name", "nombre", "vorname", "prénom"),
    "last": ("last name", "lastname", "last", "surname", "family name", "apellidos", "apellido(s)", "nachname", "nom"),
    "email": (
        "email", "e-mail", "email address", "dirección de correo", "indirizzo email", "e-mail-adresse",
        "adresse de courriel",
    ),
    "late": ("late", "days late"),
    "role": ("role",),
}  # fmt: skip
SEPARATORS = ",;\t|"
MOST_ABOVE = (
    10  # lines above the heading, as a title, or Excel's note on what parts the cells
)
ROUNDED = re.compile(r"\d[.,]\d+E\+\d+")  # what a spreadsheet makes of a long number
# Moodle's number of someone in a course
PARTICIPANT = re.compile(r"(?:partecip|particip|teilnehm)\D*(\d+)", re.IGNORECASE)
NO_STUDENTS = ("points possible", "student, test", "test student")  # Canvas's own lines
STAFF = ("instructor", "ta", "reader")  # Gradescope's


@dataclass(frozen=True)
class Student:
    """One line of the list.

    late: days after the day on which the assignment was due; row: all columns
    number: Moodle's "Participant 123456", if the list has it; the folders that Moodle hands out are named by it
    """

    id: str = ""
    name: str = ""
    email: str = ""
    late: float = 0.0
    row: Mapping[str, str] = field(default_factory=dict, compare=False)
    number: str = field(default="", compare=False)

    @property
    def words(self) -> set[str]:
        """What this student's files may be named by."""
        return {self.id, self.number, *PARTICIPANT.findall(self.number)} - {""}


NOBODY = Student()


def read_students(path: str) -> list[Student]:
    """The students of a CSV file with a column id, and perhaps name, email, late; commas, semicolons or tabs part it.

    A student without an id goes by Moodle's number of the participant, else by the email address.
    Raises OSError, or ValueError if someone has none of these, or one twice, or if days are no numbers.
    """
    students: dict[str, Student] = {}
    for line, row in _rows(path):
        student = _student(f"{path}, line {line}", row)
        if student is None:
            continue
        if student.id.lower() in students:
            raise ValueError(f"{path}, line {line}: the id {student.id} is there twice")
        students[student.id.lower()] = student
    if not students:
        raise ValueError(
            f"{path}: there is no student in it; its first line should name the columns, as id,name,late"
        )
    return list(students.values())


def _student(where: str, row: Mapping[str, str]) -> Student | None:
    """The student of a line; None if it is empty, or of somebody else."""
    by_name = {_heading(name): text for name, text in row.items()}
    told = {
        of: next((by_name[n] for n in names if by_name.get(n)), "")
        for of, names in COLUMNS.items()
    }
    name = told["name"] or f"{told['first']} {told['last']}".strip()
    if (
        name.lower() in NO_STUDENTS
        or told["role"].lower() in STAFF
        or not any(row.values())
    ):
        return None
    participant = PARTICIPANT.match(told["number"])
    if ROUNDED.fullmatch(told["id"]):
        raise ValueError(
            f"{where}: a spreadsheet has rounded the id {told['id']}: format the column as text"
        )
    own = (
        ""
        if PARTICIPANT.match(told["id"])
        else re.sub(r"^(\d+)\.0$", r"\1", told["id"])
    )
    id = own or (participant[1] if participant else told["number"]) or told["email"]
    if not id and not name:
        return None  # such as Canvas's line on which columns are posted by hand
    try:
        late = float(told["late"].replace(",", ".") or 0)
    except ValueError:
        late = -1.0
    if not id or not 0 <= late < 1e4:
        raise ValueError(
            f"{where}: a student has an id, and late is a number of days from 0 on"
        )
    return Student(
        id, name, told["email"], late, row, told["number"] if participant else ""
    )


def _rows(path: str) -> Iterator[tuple[int, dict[str, str]]]:
    """Number and cells of each line below the heading. Raises ValueError for a line with more cells than columns."""
    try:
        text = text_of(path)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None
    head: list[str] = []
    below: list[tuple[int, list[str]]] = []
    for by in SEPARATORS:  # a comma, if all are as likely
        rows = _parted(path, text, by)
        for i, (_, cells) in enumerate(rows[:MOST_ABOVE]):
            if _known(cells) > _known(head):
                head, below = cells, rows[i + 1 :]
    for line, cells in below:
        if any(cells[len(head) :]):
            raise ValueError(
                f"{path}, line {line}: {len(cells)} cells, and the heading names {len(head)} columns"
            )
        yield line, dict(zip(head, cells + [""] * len(head), strict=False))


def _parted(path: str, text: str, by: str) -> list[tuple[int, list[str]]]:
    """Number and cells of each line of a table, the text of a file, whose cells are parted by `by`."""
    rows: list[tuple[int, list[str]]] = []
    line = 1
    try:
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=by)
        for row in reader:
            rows.append((line, [_bare(cell) for cell in row]))
            line = reader.line_num + 1
    except csv.Error as error:
        raise ValueError(f"{path}, line {line}: this is no CSV ({error})") from None
    return rows


def _known(head: Sequence[str]) -> int:
    names = {name for names in COLUMNS.values() for name in names}
    return sum(_heading(name) in names for name in head)


def _heading(name: str) -> str:
    return " ".join(unicodedata.normalize("NFKC", name).lower().split())


def _bare(cell: str) -> str:
    """A cell without spaces around it, and without what keeps a spreadsheet from taking 007 for a number."""
    cell = cell.strip().strip(INVISIBLE).strip()
    return cell[2:-1] if cell.startswith('="') and cell.endswith('"') else cell
