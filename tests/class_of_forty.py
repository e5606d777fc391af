"""A made-up class goes through all of homework: python tests/class_of_forty.py [students]

Each student gets a notebook of their own, and hands it in: right, half right, wrong in a known way, or hostile. The
class is graded, as another user where root does it, and every table is compared with what was built into it.
"""

from __future__ import annotations

import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import nbformat

from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.source import edited_body, head_and_body
from rlrobot_course.homework.each import export_each
from rlrobot_course.homework.own import variant_of

ROOT = Path(__file__).parents[1]
LESSON, NOTEBOOK = "assignment_1", ROOT / "homework" / "1_a_robots_day_as_numbers.ipynb"
KINDS = ("wrong", "right", "wrong", "hostile", "wrong", "half", "wrong", "hostile")  # of forty, twenty are wrong
WRONG_WAYS = 20
HOSTILE = (
    "import os\nos._exit(1)",
    "while True: pass",
    "check.train = lambda answer: print('✓ Right.')",
    "import numpy\nmuch = numpy.ones((400_000, 2000))",
    "import mmap\nmuch = mmap.mmap(-1, 1 << 34)",
    "import subprocess\nsubprocess.Popen(['sleep', '1000'], start_new_session=True)",
    "import glob, os, signal\nfor p in glob.glob('/proc/[0-9]*/cmdline'):\n"
    "    if b'class_points' in open(p, 'rb').read():\n        os.kill(int(p.split('/')[2]), signal.SIGKILL)",
    "import rlrobot_course.homework.rooms as rooms\nopen(rooms.COURSE / 'homework/marking.py', 'a').write('#')",
)
HARMFUL_ALONE = HOSTILE[-2:]  # without a guard these end or change the grader itself: only where there is one


@dataclass
class Class:
    """What was built into a class: for each student the points, and how often each mistake is made in each exercise."""

    points: dict[str, float] = field(default_factory=dict)
    mistakes: Counter[tuple[str, str]] = field(default_factory=Counter)


def roster(n: int) -> str:
    """A list of students; every tenth is two days late."""
    return "id,name,email,late\n" + "".join(
        f"s{i:03},Student {i},s{i:03}@x.org,{2 * (i % 10 == 9)}\n" for i in range(n)
    )


def handed_in(folder: Path, n: int, hostile: tuple[str, ...]) -> Class:
    """Write n notebooks into folder/in, made of the solutions of each student: the kinds take turns."""
    built, wrong_so_far, hostile_so_far = Class(), 0, 0
    for i in range(n):
        student = f"s{i:03}"
        notebook = nbformat.read(folder / "solutions" / student / f"{NOTEBOOK.stem}_{student}.ipynb", as_version=4)
        answers = {
            match[1]: cell
            for cell in notebook.cells
            if cell.cell_type == "code" and (match := re.search(r"^check\.(\w+)\(\1\)\s*\Z", cell.source, re.MULTILINE))
        }
        points, kind = float(len(answers)), KINDS[i % len(KINDS)]
        if kind == "half":
            for name in list(answers)[::2]:
                cell = answers[name]
                cell.source = f"{name} = ...\ncheck.{name}({name})"
                built.mistakes[name, "not answered"] += 1
                points -= 1
        elif kind == "wrong":
            name, way, source = wrong_ways(student)[wrong_so_far % WRONG_WAYS]
            answers[name].source = f"{source}\n\ncheck.{name}({name})"
            built.mistakes[name, way.replace("_", " ")] += 1
            points, wrong_so_far = points - 1, wrong_so_far + 1
        elif kind == "hostile":
            notebook.cells.insert(2, nbformat.v4.new_code_cell(hostile[hostile_so_far % len(hostile)]))
            hostile_so_far += 1
        nbformat.write(notebook, folder / "in" / f"{NOTEBOOK.stem}_{student}.ipynb")
        built.points[student] = round(points * (0.9 if i % 10 == 9 else 1), 2)
    return built


def wrong_ways(student: str) -> list[tuple[str, str, str]]:
    """Wrong answers of a student's variant: exercise, mistake, source; those that are made by an edit."""
    ways = []
    for name, exercise in variant_of(LESSON, student).exercises.items():
        assert isinstance(exercise, Exercise)
        for mistake in exercise.mistakes:
            if not callable(mistake.wrong):
                source = head_and_body(exercise.right)[0] + edited_body(exercise.right, mistake.wrong)
                ways.append((name, mistake.id, source))
    return ways[:: max(1, len(ways) // WRONG_WAYS)][:WRONG_WAYS]


def go_through_all(folder: Path, n: int, jobs: int) -> list[str]:
    """Grade a class of n, and say what is not as it was built; nothing if all is well."""
    guarded = sys.platform == "linux" and os.getuid() == 0 and shutil.which("setpriv") is not None
    (folder / "in").mkdir()
    (folder / "roster.csv").write_text(roster(n), encoding="utf-8")
    (folder / "rules.toml").write_text("late_off = 0.1\nlate_free = 1\n", encoding="utf-8")
    export_each([NOTEBOOK], folder, str(folder / "roster.csv"), hints=1)
    built = handed_in(folder, n, HOSTILE if guarded else tuple(one for one in HOSTILE if one not in HARMFUL_ALONE))
    command = [sys.executable, "-m", "rlrobot_course", "grade", "in", "--roster", "roster.csv", "--rules", "rules.toml",
               "--for", "canvas", "--csv", "class_points.csv", "--mistakes", "mistakes.csv", "--feedback", "sheets",
               "--alike", "alike.csv", "--jobs", str(jobs), "--memory", "2048", "--seconds", "60",
               *(["--user", "61000"] if guarded else [])]  # fmt: skip
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=3000)
    if done.returncode != 1:
        return [f"exit code {done.returncode}: {done.stderr}"]
    rows = list(csv.DictReader((folder / "class_points.csv").open(encoding="utf-8")))
    told = {row["ID"]: float(row["assignment 1"]) for row in rows if row["ID"]}
    wrong = [
        f"{student}: {told.get(student)} points, not {p}"
        for student, p in built.points.items()
        if told.get(student) != p
    ]
    counted = {
        (row["exercise"], row["mistake"]): int(row["how many"])
        for row in csv.DictReader((folder / "mistakes.csv").open(encoding="utf-8"))
    }
    if counted != dict(built.mistakes):
        wrong.append(f"mistakes: {sorted(counted.items() ^ built.mistakes.items())}")
    if len(list((folder / "sheets").iterdir())) != n:
        wrong.append("a sheet is missing")
    return wrong


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        begun = time.monotonic()
        faults = go_through_all(Path(temporary), int(sys.argv[1]) if sys.argv[1:] else 40, jobs=2)
        print("\n".join(faults) or f"All as it was built, in {time.monotonic() - begun:.0f} s.")
    sys.exit(bool(faults))
