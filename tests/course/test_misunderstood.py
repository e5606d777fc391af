"""What a class has misunderstood: right by construction, for submissions whose mistakes are known."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import nbformat
import pytest

from rlrobot_course.homework import grade as grade_module
from rlrobot_course.homework.grade import grade
from rlrobot_course.homework.marks import Marked, Score
from rlrobot_course.homework.misunderstood import as_page, as_table, misunderstood
from rlrobot_course.homework.submission import sections_of


def score(exercise: str, mistake: str = "", hint: str = "", *, right=False, is_answered=True) -> Score:
    return Score(exercise, float(right), f"✗ {hint}", is_answered=is_answered, mistake=mistake, hint=hint)


def made_up(n: int, slips: dict[int, tuple[str, str]]) -> list[Marked]:
    """A class of n in lesson 02, whose `target` is right but for these slips, and whose `by_hand` is never answered."""
    return [
        Marked(f"student_{i}.ipynb", "02", [
            score("target", *slips[i]) if i in slips else score("target", right=True),
            score("by_hand", is_answered=False),
        ]) for i in range(n)
    ]  # fmt: skip


PAST, GAMMA = ("past_the_end", "nothing follows a <terminal> state."), ("no_gamma", "γ is missing: 3 is not 2.7.")
SLIPS = {3: PAST, 5: PAST, 8: PAST, 1: GAMMA, 9: ("no_gamma", "γ is missing: 4 is not 3.6."), 7: ("", "")}


def test_every_mistake_is_counted_once_for_each_notebook_that_made_it():
    found = misunderstood(made_up(40, SLIPS))
    told = [(one.exercise, one.mistake, len(one.notebooks)) for one in found]
    assert told == [("target", "past the end", 3), ("target", "no gamma", 2), ("target", "not recognised", 1),
                    ("by_hand", "not answered", 40)]  # fmt: skip
    assert found[0].notebooks == ["student_3.ipynb", "student_5.ipynb", "student_8.ipynb"]
    assert found[0].hint == PAST[1] and found[1].hint in (GAMMA[1], "γ is missing: 4 is not 3.6.")


def test_the_page_names_no_one_and_the_table_does():
    marked = made_up(40, SLIPS)
    page, table = as_page(marked), list(csv.DictReader(io.StringIO(as_table(marked))))
    assert "student_" not in page and "&lt;terminal&gt;" in page and "<code>target</code>, 34 of 40 right" in page
    assert "<code>by_hand</code>, 0 of 40 right" in page and "3 of 40" in page
    assert [row["how many"] for row in table] == ["3", "2", "1", "40"]
    assert table[1]["notebooks"] == "student_1.ipynb student_9.ipynb" and table[1]["mistake"] == "no gamma"


def test_a_class_that_understood_all_has_an_empty_table():
    marked = [Marked("one.ipynb", "02", [score("target", right=True)])]
    assert misunderstood(marked) == [] and as_table(marked).count("\n") == 1
    assert "1 of 1 right" in as_page(marked) and "<table>" not in as_page(marked)


@pytest.fixture
def handed_in(tmp_path, monkeypatch) -> Path:
    """Two students whose notebooks have the same name, and a grader that needs no kernel."""
    for student in ("ada", "bob"):
        cells = [nbformat.v4.new_markdown_cell("# 02\n\nwords\n\n## 3. The target\n\n### Exercise: `target`"),
                 nbformat.v4.new_code_cell("check.target(target)")]  # fmt: skip
        (tmp_path / "in" / student).mkdir(parents=True)
        nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / "in" / student / "02.ipynb")
    slips = iter([score("target", *PAST), score("target", right=True)])
    monkeypatch.setattr(
        grade_module, "marked_files", lambda paths, *_: (Marked(str(path), "02", [next(slips)]) for path in paths)
    )
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_each_student_gets_a_sheet_that_says_what_to_look_at_again(handed_in):
    assert grade(["in"], seed=1, feedback="sheets", mistakes="mistakes.html", csv="points.csv") == 1
    sheets = {path.name: path.read_text(encoding="utf-8") for path in Path("sheets").iterdir()}
    assert sheets.keys() == {"in__ada__02.md", "in__bob__02.md"}
    assert "nothing follows a <terminal> state." in sheets["in__ada__02.md"]
    assert "*Exercise: `target`*, in your notebook" in sheets["in__ada__02.md"]
    assert "- `target`: right" in sheets["in__bob__02.md"] and "bob" not in sheets["in__ada__02.md"]
    points = list(csv.DictReader(Path("points.csv").read_text(encoding="utf-8").splitlines()))
    assert [row["reasons"] for row in points] == ["target: nothing follows a <terminal> state.", ""]
    page = Path("mistakes.html").read_text(encoding="utf-8")
    assert re.search(r"1 of 2</td><td>past the end</td>", page) and "ada" not in page


def test_a_file_that_is_no_notebook_has_no_sections(tmp_path):
    (tmp_path / "x.ipynb").write_bytes(b"\x89PNG")
    assert sections_of(tmp_path / "x.ipynb") == {}
