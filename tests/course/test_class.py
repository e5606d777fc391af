"""A made-up class goes through all of homework, and every table says what was built into it."""

from __future__ import annotations

import csv
import io
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

import nbformat
import pytest

from rlrobot_course.homework.hand_out import hand_out

ROOT = Path(__file__).parents[2]
NOTEBOOK = ROOT / "notebooks/homework" / "1_a_robots_day_as_numbers.ipynb"
BLANK = "{name} = ...\n\ncheck.{name}({name})"
WRONG = "def {name}(*arguments):\n    return -77\n\ncheck.{name}({name})"
HOSTILE = (
    "import os\nos._exit(1)",
    "while True: pass",
    "check.train = lambda answer: print('✓ Right.')",
    "import numpy\nmuch = numpy.ones((400_000, 2000))",
    "import mmap\nmuch = mmap.mmap(-1, 1 << 34)",
    "import subprocess\nsubprocess.Popen(['sleep', '1000'], start_new_session=True)",
)
CHANGES_THE_GRADER = (
    "import pathlib, rlrobot_grading\n"
    "for path in pathlib.Path(rlrobot_grading.__file__).parent.rglob('*.py'):\n"
    "    open(path, 'a').write('#')"
)
HARMFUL_ALONE = (  # without a guard these end or change the grader itself: only where there is one
    "import glob, os, signal\nfor p in glob.glob('/proc/[0-9]*/cmdline'):\n"
    "    if b'class_points' in open(p, 'rb').read():\n        os.kill(int(p.split('/')[2]), signal.SIGKILL)",
    CHANGES_THE_GRADER,
)
ANSWER = re.compile(r"^check\.(\w+)\(\1\)\s*\Z", re.MULTILINE)


def test_the_program_that_changes_the_grader_opens_each_of_its_files():
    opened = []

    def note(path, mode):
        opened.append((path, mode))
        return io.StringIO()

    exec(CHANGES_THE_GRADER, {"open": note})
    package = ROOT / "rlrobot_grading"
    assert {(path, "a") for path in package.rglob("*.py")} <= set(opened)


@pytest.mark.long
def test_a_class_that_is_right_half_right_wrong_and_hostile_gets_what_it_deserves(
    tmp_path,
):
    """Each student has a hostile notebook of their own, every second one is half right, and the last one is late."""
    guarded = (
        sys.platform == "linux"
        and os.getuid() == 0
        and shutil.which("setpriv") is not None
    )
    hostile = (*HOSTILE, *HARMFUL_ALONE) if guarded else HOSTILE
    students = [f"s{i:03}" for i in range(len(hostile))]
    lines = "".join(
        f"{id},Student {id},{2 * (id == students[-1])}\n" for id in students
    )
    (tmp_path / "roster.csv").write_text(f"id,name,late\n{lines}", encoding="utf-8")
    (tmp_path / "rules.toml").write_text(
        "late_off = 0.1\nlate_free = 1\n", encoding="utf-8"
    )
    hand_out(str(tmp_path / "roster.csv"), [NOTEBOOK], tmp_path, hints=1)
    (tmp_path / "in").mkdir()
    points: dict[str, float] = {}
    missed: Counter[str] = Counter()
    for i, (student, harm) in enumerate(zip(students, hostile, strict=True)):
        path = tmp_path / "solutions" / student / f"{NOTEBOOK.stem}_{student}.ipynb"
        notebook = nbformat.read(path, as_version=4)
        answers = {
            match[1]: cell
            for cell in notebook.cells
            if (match := ANSWER.search(cell.source))
        }
        names = list(answers)[i % len(answers) :: 2] if i % 2 else []
        for name in names:
            answers[name].source = (BLANK if i % 4 == 1 else WRONG).format(name=name)
            missed[name] += 1
        notebook.cells.insert(1, nbformat.v4.new_code_cell(harm))
        nbformat.write(notebook, tmp_path / "in" / path.name)
        points[student] = len(answers) - len(names)
    points[students[-1]] *= 0.9
    command = [sys.executable, "-m", "rlrobot_edu", "grade", "in", "--roster", "roster.csv", "--rules", "rules.toml",
               "--csv", "class_points.csv", "--mistakes", "mistakes.csv", "--feedback", "sheets",
               "--jobs", "2", "--memory", "2048", "--seconds", "60",
               *(["--user", "61000"] if guarded else ["--trust"])]  # fmt: skip
    done = subprocess.run(
        command, cwd=tmp_path, capture_output=True, text=True, timeout=3000
    )
    assert done.returncode == 1, done.stderr
    rows = list(csv.DictReader((tmp_path / "class_points.csv").open(encoding="utf-8")))
    assert {row["id"]: float(row["score"]) for row in rows} == pytest.approx(points)
    counted: Counter[str] = Counter()
    for row in csv.DictReader((tmp_path / "mistakes.csv").open(encoding="utf-8")):
        counted[row["exercise"]] += int(row["how many"])
    assert counted == missed
    assert len(list((tmp_path / "sheets").iterdir())) == len(students)
