"""The catalogue of mistakes is what it says, and gives away nothing of the assignments."""

import json
import math
from importlib import import_module

import numpy as np
import public_faults
import pytest

from rlrobot_course.authoring import catalogue
from rlrobot_course.authoring.commands import run

ASSIGNMENTS = [
    import_module(f"rlrobot_course.assignment_{i}.exercises").check for i in range(1, 6)
]


@pytest.fixture(scope="module")
def entries():
    return [json.loads(line) for line in catalogue.lines()]


def exercise_of(entry):
    """The exercise of an entry, and the names that its functions see."""
    lesson, name, _ = entry["id"].split("/")
    module = import_module(f"rlrobot_course.lesson_{lesson}.exercises")
    return getattr(module.check, name), vars(module)


def made(text, names, helpers):
    """The function that a text defines; it sees the helpers as they are written in the entry."""
    sees = {"np": np, "math": math} | names
    for helper in helpers.values():
        exec(helper, sees)
    found = {}
    exec(text, sees, found)
    return list(found.values())[-1]


def differing(exercise, function):
    """The numbers of the cases in which a function does not do what is right."""
    pairs = zip(exercise.expected, exercise.outcomes(function), strict=False)
    return [i for i, (right, got) in enumerate(pairs, 1) if not right.equals(got)]


@pytest.mark.nightly
def test_every_right_function_is_right_and_every_wrong_one_first_differs_where_it_says(
    entries,
):
    wrong = []
    checked = set()
    for entry in entries:
        if "first_case" not in entry:
            assert entry["right"] != entry["wrong"]
            continue
        exercise, names = exercise_of(entry)
        if entry["right"] not in checked:
            right = made(entry["right"], names, entry["helpers"])
            assert differing(exercise, right) == [], entry["id"]
            checked.add(entry["right"])
        found = differing(exercise, made(entry["wrong"], names, entry["helpers"]))
        if found[:1] != [entry["first_case"]["number"]]:
            wrong.append(entry["id"])
        assert entry["first_case"]["expected"] != entry["first_case"]["got"] or (
            "changes what it should read" in entry["first_case"]
        )
    assert wrong == []


@pytest.mark.long
def test_it_has_the_mistakes_of_all_lessons_and_of_no_assignment(entries):
    assert len({entry["id"] for entry in entries}) == len(entries)
    assert {int(entry["id"][:2]) for entry in entries} == set(range(1, 23))
    text = json.dumps(entries)
    assert "assignment" not in text
    for check in ASSIGNMENTS:
        for exercise in vars(check).values():
            assert f"/{exercise.name}/" not in text
            if hasattr(exercise, "wrong_functions"):
                assert json.dumps(catalogue.source(exercise.right)) not in text


@pytest.mark.long
def test_its_cases_are_those_that_a_learner_has_and_no_secret_ones(entries):
    for entry in entries:
        if "first_case" in entry:
            exercise, _ = exercise_of(entry)
            case = exercise.cases[entry["first_case"]["number"] - 1]
            for name, value in entry["first_case"]["arguments"].items():
                assert catalogue.show(case[name]) == value


@pytest.mark.long
def test_the_page_tells_how_much_there_is(entries):
    assert 1400 < len(entries) < 1600
    assert 950 < sum("first_case" in entry for entry in entries) < 1100


@pytest.mark.long
def test_the_six_public_faults_are_named_as_the_page_says():
    page = public_faults.PAGE.read_text(encoding="utf-8")
    assert public_faults.written(page) == page
    assert all(public_faults.verdict(fault).hint for fault in public_faults.FAULTS)


def test_the_command_writes_a_line_for_each(monkeypatch, capsys):
    monkeypatch.setattr(catalogue, "lines", lambda: iter(["{}", "{}"]))
    assert run(["mistakes"]) == 0
    assert capsys.readouterr().out == "{}\n{}\n"
