"""What is the learner's own: copies of the notebooks, right functions that are kept."""

import importlib.util
import json
import os
import subprocess
import sys
import time

import pytest

from rlrobot_course.learner import my_course
from rlrobot_course.learner.my_course import copy_missing, set_back
from rlrobot_course.learner.my_functions import FILE, keep, owner_of, take
from rlrobot_course.lesson_03 import check, exercises
from rlrobot_grading.answers.notebook import is_notebook

OUTPUT = {"output_type": "stream", "name": "stdout", "text": ["1\n"]}
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}


def write(path, source="1 + 1"):
    cells = [
        {
            "cell_type": "code",
            "source": [source],
            "outputs": [OUTPUT],
            "execution_count": 1,
            "metadata": {},
        }
    ]
    path.parent.mkdir(exist_ok=True)
    path.write_text(
        json.dumps(
            {
                "cells": cells,
                "metadata": {"kernelspec": KERNEL},
                "nbformat": 4,
                "nbformat_minor": 5,
            }
        )
    )


@pytest.fixture(autouse=True)
def somebody_looks_on(monkeypatch):
    """Else, as where notebooks are run to be saved, `take` says nothing of what is given."""
    monkeypatch.setenv("RLROBOT_EDU_PROGRESS", "1")


@pytest.fixture
def course(tmp_path):
    """Two lessons, and a folder for the learner's copies: the keywords of `my_course`'s functions."""
    for name in ("00_start.ipynb", "03_q.ipynb"):
        write(tmp_path / "notebooks" / name)
    return {"source": tmp_path / "notebooks", "folder": tmp_path / "my_course"}


def test_copies_have_no_outputs_and_are_never_overwritten(course):
    assert copy_missing(**course) == [f"2 notebooks were copied to {course['folder']}."]
    mine = course["folder"] / "03_q.ipynb"
    cell = json.loads(mine.read_text())["cells"][0]
    assert (
        cell["source"] == ["1 + 1"]
        and cell["outputs"] == []
        and cell["execution_count"] is None
    )
    mine.write_text(mine.read_text().replace("1 + 1", "my own work"))
    assert copy_missing(**course) == []
    assert "my own work" in mine.read_text()
    mine.write_text("not a notebook any more")
    assert (
        copy_missing(**course) == [] and mine.read_text() == "not a notebook any more"
    )


def test_a_new_edition_is_told_and_a_lesson_that_is_set_back_is_not_lost(course):
    copy_missing(**course)
    mine = course["folder"] / "03_q.ipynb"
    mine.write_text(mine.read_text().replace("1 + 1", "my own work"))
    write(course["source"] / "03_q.ipynb", "2 + 2")
    assert "make fresh LESSON=03" in copy_missing(**course)[0]
    assert set_back("03", **course).startswith(
        f"{mine} is fresh; the old one is {course['folder'] / 'old' / '03_q_'}"
    )
    assert "2 + 2" in mine.read_text()
    assert "my own work" in next((course["folder"] / "old").iterdir()).read_text()
    assert copy_missing(**course) == []


def test_assignments_have_a_folder_of_their_own_and_are_set_back_alike(course):
    write(course["source"] / "homework" / "1_cart.ipynb")
    assert copy_missing(**course) == [f"3 notebooks were copied to {course['folder']}."]
    mine = course["folder"] / "homework" / "1_cart.ipynb"
    mine.write_text(mine.read_text().replace("1 + 1", "my own work"))
    assert f"{mine} is fresh" in set_back("homework 1", **course)
    assert "1 + 1" in mine.read_text()


def test_a_lesson_and_an_assignment_of_one_number_cannot_be_taken_for_each_other(
    course,
):
    write(course["source"] / "homework" / "2_cart.ipynb")
    copy_missing(**course)
    for number, file in (
        ("3", "03_q.ipynb"),
        ("03", "03_q.ipynb"),
        ("homework 2", "homework/2_cart.ipynb"),
    ):
        mine = course["folder"] / file
        assert set_back(number, **course).startswith(f"{mine} is fresh")


def test_two_that_are_set_back_within_one_second_are_both_kept(course, monkeypatch):
    monkeypatch.setattr(time, "strftime", lambda form: "now")
    copy_missing(**course)
    mine = course["folder"] / "03_q.ipynb"
    for work in ("first work", "second work", "third work"):
        mine.write_text(mine.read_text().replace("1 + 1", work))
        set_back("03", **course)
    kept = sorted(path.read_text() for path in (course["folder"] / "old").iterdir())
    assert [
        work in text
        for work, text in zip(("first", "second", "third"), kept, strict=True)
    ] == [True] * 3


def test_a_lesson_that_is_not_there_is_named_with_those_that_are(course):
    with pytest.raises(
        ValueError, match=r"there is no lesson '77'\. The lessons are 00, 03"
    ):
        set_back("77", **course)


def lab_that_ends_with(*ends):
    """A stand-in for the process of JupyterLab: what each call of `wait` returns, or raises."""

    ahead = list(ends)

    class Lab:
        def __init__(self, command, cwd):
            Lab.command = command

        def wait(self):
            end = ahead.pop(0)
            if end is KeyboardInterrupt:
                raise KeyboardInterrupt
            return end

    return Lab


def test_jupyterlab_is_asked_for_the_learners_copy_and_hears_one_ctrl_c(
    course, monkeypatch, capsys
):
    Lab = lab_that_ends_with(KeyboardInterrupt, 130)
    monkeypatch.setattr(my_course.subprocess, "Popen", Lab)
    assert my_course.open_lab(["--port=1"], **course) == 0
    assert Lab.command[-2:] == [
        "--LabApp.default_url=/lab/tree/my_course/00_start_here.ipynb",
        "--port=1",
    ]
    assert "--ip=127.0.0.1" in Lab.command
    *_, last = capsys.readouterr().out.splitlines()
    assert last.startswith(
        f"JupyterLab has ended. Your notebooks are in {course['folder']};"
    )


@pytest.mark.parametrize("code", [1, 2, -9])
def test_a_jupyterlab_that_does_not_start_is_not_told_as_a_normal_end(
    course, monkeypatch, capsys, code
):
    monkeypatch.setattr(my_course.subprocess, "Popen", lab_that_ends_with(code))
    assert my_course.open_lab([], **course) == code
    said = capsys.readouterr()
    assert "has ended" not in said.out + said.err
    assert f"did not start, or broke off (exit code {code})" in said.err


def test_without_jupyterlab_it_is_told_what_to_install(course, monkeypatch):
    monkeypatch.setattr(my_course, "find_spec", lambda name: None)
    with pytest.raises(ImportError, match="pip install"):
        my_course.open_lab([], **course)


@pytest.mark.parametrize("own", ["--ip=0.0.0.0", "--ip 0.0.0.0", "--log-level=INFO"])
def test_an_option_of_ones_own_takes_the_place_of_the_commands(
    course, monkeypatch, own
):
    Lab = lab_that_ends_with(0)
    monkeypatch.setattr(my_course.subprocess, "Popen", Lab)
    my_course.open_lab(own.split(), **course)
    name = own.split()[0].partition("=")[0]
    assert [word.partition("=")[0] for word in Lab.command].count(name) == 1


@pytest.mark.parametrize("where", ["the checkout", "elsewhere"])
def test_the_command_that_is_named_works_where_one_stands(tmp_path, where):
    folder = my_course.NOTEBOOKS.parent if where == "the checkout" else tmp_path
    script = (
        "from rlrobot_course.learner.my_course import LAB, FRESH; print(LAB, FRESH)"
    )
    environment = os.environ | {"PYTHONPATH": str(my_course.NOTEBOOKS.parent)}
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    program = "make" if where == "the checkout" else "rlrobot-edu"
    assert done.stdout.startswith(f"{program} lab {program} fresh")


def module_of(path, source):
    """A learner's functions as a module of their own, so that their source can be read."""
    path.write_text(source)
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


MINE = """
import numpy as np

factor = 1

def goal(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * np.max(q[s_next])

def update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (target(q, r, s_next, terminated, gamma) - q[s, a])

def leans(q, r, s_next, terminated, gamma):
    return factor * goal(q, r, s_next, terminated, gamma)
"""


def test_what_is_right_is_kept_and_taken_from_there_with_what_it_calls(
    tmp_path, capsys
):
    mine = module_of(tmp_path / "cells.py", MINE)
    for name, answer in (
        ("update", mine.update),
        ("target", mine.goal),
    ):  # in any order
        assert keep(
            answer, "03", name, getattr(check, name).judge, tmp_path
        ).startswith(f"Kept in {FILE}")
    target, update, learn = take("03", "target", "update", "learn", folder=tmp_path)
    assert capsys.readouterr().out == (
        "yours: target, update; given: learn (yours comes here when its check in lesson 03 is green)\n"
    )
    assert learn is exercises.learn and update is not exercises.update
    assert [owner_of(update, target), owner_of(learn), owner_of(learn, update)] == [
        "your",
        "the given",
        "partly your",
    ]
    assert check.update(update) and check.target(target)
    assert update.__globals__["target"].__name__ == "goal", "mine calls mine"
    module_of(tmp_path / FILE, (tmp_path / FILE).read_text())  # a module of its own


def test_helpers_and_numbers_of_other_cells_are_kept_with_what_uses_them(
    tmp_path, capsys
):
    mine = module_of(tmp_path / "cells.py", MINE.replace("import numpy as np\n", "import numpy as np, math as m\n")
                     .replace("return factor * goal", "return m.floor(1.5) * factor * goal"))  # fmt: skip
    assert keep(mine.leans, "03", "target", check.target.judge, tmp_path).startswith(
        f"Kept in {FILE}"
    )
    target = take("03", "target", folder=tmp_path)
    assert capsys.readouterr().out == "yours: target\n" and check.target(target)


def test_what_needs_what_cannot_be_written_down_is_not_kept_and_take_says_why(
    tmp_path, capsys
):
    mine = module_of(
        tmp_path / "cells.py", MINE.replace("factor = 1", "factor = np.ones(())")
    )
    assert check.target(mine.leans)
    assert "on its own, target does not work" in keep(
        mine.leans, "03", "target", check.target.judge, tmp_path
    )
    capsys.readouterr()
    assert take("03", "target", folder=tmp_path) is exercises.target
    assert capsys.readouterr().out.startswith(
        "target is green, but it is not kept: on its own, target does not work"
    )
    assert "only what is written with def" in keep(
        lambda: 0, "03", "target", check.target.judge, tmp_path
    )
    assert "only what is written with def" in keep(
        len, "03", "target", check.target.judge, tmp_path
    )


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\0",
        "# lesson 03: target\ndef target(\n# end of target",
        "# lesson 03: target\nraise SystemExit\n# end of target",
    ],
)
def test_a_broken_file_gives_the_given_version(tmp_path, capsys, text):
    (tmp_path / FILE).write_text(text)
    assert take("03", "target", folder=tmp_path) is exercises.target
    said = capsys.readouterr().out
    assert "given: target" in said and (
        f"{FILE}, line 2" in said or "def target(" not in text
    )


def test_a_function_that_the_lesson_does_not_have_is_named(tmp_path):
    with pytest.raises(ValueError, match="lesson 03 has no function 'updat'"):
        take("03", "updat", folder=tmp_path)


def test_a_kept_function_that_is_wrong_by_now_is_not_taken(tmp_path):
    wrong = "def target(q, r, s_next, terminated, gamma):\n    return r\n"
    (tmp_path / FILE).write_text(f"# lesson 03: target\n{wrong}# end of target\n")
    assert take("03", "target", folder=tmp_path) is exercises.target


def test_outside_a_notebook_a_check_writes_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert not is_notebook()
    assert check.target(exercises.target)
    assert list(tmp_path.iterdir()) == []


def test_in_a_notebook_a_check_keeps_a_right_answer(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("rlrobot_grading.exercises.exercise.is_notebook", lambda: True)

    def target(q, r, s_next, terminated, gamma):
        return r if terminated else r + gamma * max(q[s_next])

    assert f"Kept in {FILE}" in check.target(target).gained
    assert take("03", "target", folder=tmp_path) is not exercises.target
    assert "the course's own solution" in check.target(exercises.target).text
