"""Each student their own, and secret tapes: other cases, constants and orders, and the same difficulty."""

from __future__ import annotations

import importlib
import json
import os
from pathlib import Path
from types import FunctionType, SimpleNamespace

import nbformat
import numpy as np
import pytest
from test_checks import EVERY, RIGHT, exercises, wrong_answers

from rlrobot_course.homework import COURSE, use_variant
from rlrobot_course.homework.hand_out import hand_out, solution_of
from rlrobot_grading.exercises.exercise import Exercise
from rlrobot_grading.exercises.question import Question
from rlrobot_grading.marking.secret import secret_twin
from rlrobot_grading.marking.submission import read_submission
from rlrobot_grading.marking.variants import variant_of

ROOT = Path(__file__).parents[2]
LESSONS = [f"assignment_{i}" for i in range(1, 6)]
STUDENTS = [
    f"s{i:04}" for i in range(200 if os.environ.get("RLROBOT_EDU_LONG") else 12)
]


def notebook(lesson: str) -> Path:
    return next((ROOT / "notebooks/homework").glob(f"{lesson[-1]}_*.ipynb"))


def fault(lesson: str, student: str) -> str:
    """What makes a student's variant easier or harder than that of others; empty if nothing does."""
    base, variant = COURSE.exercises_of(lesson), variant_of(COURSE, lesson, student)
    if list(base) != list(variant.exercises):
        return "other exercises"
    for name, its_own in variant.exercises.items():
        plain = base[name]
        if [mistake.id for mistake in its_own.mistakes] != [
            mistake.id for mistake in plain.mistakes
        ]:
            return f"other mistakes in {name}"
        if isinstance(its_own, Exercise):
            if len(its_own.tape) != len(plain.tape) or not its_own.judge(its_own.right):
                return f"other cases in {name}"
            if type(its_own) is Exercise and its_own is plain:
                return f"the same cases in {name}"
        elif len(
            {str(mistake.wrong) for mistake in its_own.mistakes} | {str(its_own.right)}
        ) <= len(plain.mistakes):
            return f"two answers are one in {name}"
    return ""


@pytest.mark.long
@pytest.mark.parametrize("lesson", LESSONS)
def test_all_students_have_the_same_difficulty(lesson):
    """Two hundred of them with make test-all LONG=1."""
    assert not [
        (student, told) for student in STUDENTS if (told := fault(lesson, student))
    ]


def test_a_number_has_one_variant_and_two_numbers_have_two():
    tapes = [
        repr(variant_of(COURSE, "assignment_1", student).exercises["returns"].cases)
        for student in ("a1", "A1", "a2")
    ]
    assert tapes[0] == tapes[1] != tapes[2]


@pytest.mark.parametrize("lesson", ["assignment_2", "assignment_4", "assignment_5"])
def test_whatever_may_differ_stands_in_the_notebook_or_in_a_solution(lesson):
    cells = "\n".join(
        "".join(cell["source"])
        for cell in json.loads(notebook(lesson).read_text(encoding="utf-8"))["cells"]
    )
    folder = ROOT / "rlrobot_course" / lesson
    solutions = "\n".join(
        path.read_text(encoding="utf-8")
        for path in (*folder.glob("*.py"), *folder.glob("*.md"))
    )
    variants = [variant_of(COURSE, lesson, student) for student in STUDENTS[:3]]
    for place in variants[0].changes:
        assert place in cells or place in solutions, place
    assert len({variant.text(cells) for variant in variants}) > 1


def differing(lesson: str):
    """Two students, of whom the second's answers to what may differ are wrong for the first."""
    first, *others = STUDENTS
    return variant_of(COURSE, lesson, first), [
        variant_of(COURSE, lesson, other) for other in others[:5]
    ]


@pytest.mark.long
def test_the_answer_of_another_student_is_mostly_wrong_where_constants_or_letters_differ():
    for lesson, name in (
        ("assignment_2", "who"),
        ("assignment_4", "next_temperature"),
        ("assignment_5", "inputs"),
    ):
        mine, others = differing(lesson)
        exercise = mine.exercises[name]
        judge = exercise if isinstance(exercise, Question) else exercise.judge
        assert judge(exercise.right)
        assert (
            sum(bool(judge(other.exercises[name].right)) for other in others)
            < len(others) / 2
        ), name


def test_an_exercise_that_builds_on_another_uses_that_of_the_same_student():
    for student in STUDENTS[:2]:
        exercises = variant_of(COURSE, "assignment_4", student).exercises
        drive = exercises["drive"].right
        assert isinstance(drive, FunctionType)
        assert (
            drive.__globals__["next_temperature"] is exercises["next_temperature"].right
        )


def test_a_line_in_the_notebook_sets_the_checks_of_a_notebook():
    check = SimpleNamespace(
        **vars(importlib.import_module("rlrobot_course.assignment_1.exercises").check)
    )
    before = check.returns
    use_variant(check, STUDENTS[0])
    assert len(check.returns.tape) == len(before.tape)
    assert repr(check.returns.cases) != repr(before.cases)


def test_every_student_gets_a_notebook_and_the_instructor_its_solutions(tmp_path):
    roster = tmp_path / "list.csv"
    roster.write_text("id\ns1\ns2\n", encoding="utf-8")
    assert hand_out(str(roster), [notebook("assignment_5")], tmp_path, hints=0) == 2
    for student in ("s1", "s2"):
        out, solved = (
            next((tmp_path / room / student).iterdir())
            for room in ("students", "solutions")
        )
        submission, handed_out = (
            read_submission(COURSE, solved),
            out.read_text(encoding="utf-8"),
        )
        assert (
            submission.made_for == student
            and student in out.name
            and submission.lesson == "assignment_5"
        )
        assert "# your lines here" in handed_out and "RLROBOT_EDU_HINTS=0" in handed_out
        names: dict = {"np": np}
        for cell in nbformat.read(solved, as_version=4).cells:
            if "exercise" in cell.metadata.get("tags", []):
                exec(cell.source.partition("\ncheck.")[0], names)
        for name, exercise in variant_of(
            COURSE, "assignment_5", student
        ).exercises.items():
            assert getattr(exercise, "judge", exercise)(names[name]), name
            assert str(exercise.right) not in handed_out or name != "inputs"
    roster.write_text("id\n../s1\n", encoding="utf-8")
    with pytest.raises(ValueError, match="cannot be part of a file's name"):
        hand_out(str(roster), [notebook("assignment_5")], tmp_path)


def test_a_notebook_without_exercises_is_refused_before_anything_is_written(tmp_path):
    cells = [nbformat.v4.new_code_cell("1 + 1")]
    nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / "mine.ipynb")
    (tmp_path / "list.csv").write_text("id\ns1\n", encoding="utf-8")
    with pytest.raises(ValueError, match="no cell imports the check"):
        hand_out(str(tmp_path / "list.csv"), [tmp_path / "mine.ipynb"], tmp_path)
    assert not (tmp_path / "students").exists()


@pytest.mark.long
@pytest.mark.parametrize("lesson", COURSE.lessons)
def test_the_solution_of_each_exercise_is_a_right_answer(lesson):
    names: dict = {"np": np}
    for name, exercise in COURSE.exercises_of(lesson).items():
        if isinstance(exercise, Exercise):
            exec(solution_of(name, lesson), names)
            assert exercise.judge(names[name]), name


WITH_TAPE = [
    (lesson, name)
    for lesson, name in EVERY
    if type(exercises(lesson)[name]) is Exercise
]


@pytest.mark.long
@pytest.mark.parametrize(("lesson", "name"), WITH_TAPE)
def test_on_a_secret_tape_right_is_right_and_wrong_mostly_wrong(lesson, name):
    exercise = exercises(lesson)[name]
    solution = getattr(
        importlib.import_module(f"rlrobot_course.{lesson}.exercises"), name
    )
    tapes = set()
    for seed in range(2):
        twin = secret_twin(exercise, seed)
        tapes.add(repr(twin.cases))
        for right in (solution, RIGHT.get(lesson, {}).get(name, solution)):
            assert twin.judge(right), (seed, twin.judge(right))
    taken = [
        wrong for wrong, _ in wrong_answers(lesson)[name] if twin.share(wrong) == 1
    ]
    assert len(taken) <= 1, "an edge that only the notebook's tape has"
    assert len(tapes) == 2 and repr(secret_twin(exercise, 1).cases) in tapes, (
        "each seed has one tape, of its own"
    )
