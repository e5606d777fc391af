"""The learner's own files: a check or an answer that is written to them loses nothing of what stands there."""

import codecs
import json
import multiprocessing

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rlrobot_course.learner import learners_files
from rlrobot_course.learner.learners_files import enter, entries, put_aside
from rlrobot_course.learner.my_course import copy_missing, set_back
from rlrobot_course.learner.my_functions import FILE, is_right, keep, take
from rlrobot_course.learner.progress import show as show_progress
from rlrobot_course.learner.sections import HEAD
from rlrobot_course.lesson_03 import check, exercises
from rlrobot_course.lesson_05 import challenge as lesson_05
from rlrobot_course.play import challenge
from rlrobot_course.questions import prediction

TARGET = "def target(q, r, s_next, terminated, gamma):\n    return r if terminated else r + gamma * q[s_next].max()\n"
SPOILT = "def target(q, r, s_next, terminated, gamma):\n    return r\n"


def keep_target(folder, name="target"):
    return keep(
        getattr(exercises, name), "03", name, getattr(check, name).judge, folder
    )


def fresh(folder):
    """An empty folder: hypothesis calls a test many times with one tmp_path."""
    for path in folder.iterdir():
        path.unlink()
    return folder / FILE


lines = st.sampled_from(
    ["", "import random  # mine", "# été, α = 0.1", "x = 'ä'", '"""', "def helper(x):\n    return 2 * x", "    ", "\f",
     "def target(", "factor = 1; y = 2", "# lesson 03: learn", "# lesson 03: target", "# lesson 01: mine", "target = 3",
     "target = helper  # a note", "# -*- coding: latin-1 -*-", "\0", "@staticmethod", TARGET, SPOILT,
     "# not kept: it is green", "# end of target"]
)  # fmt: skip
texts = st.lists(
    lines | st.text(st.characters(exclude_categories=["Cs"]), max_size=20), max_size=6
)


@settings(
    max_examples=150,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(
    texts,
    st.sampled_from(["", TARGET, SPOILT]),
    texts,
)
def test_all_that_stood_around_a_function_is_still_there_or_in_a_copy(
    tmp_path, above, mine, below
):
    path = fresh(tmp_path)
    parts = [
        "\n".join(above),
        f"\n# lesson 03: target\n{mine}# end of target\n",
        "\n".join(["", *below]),
    ]
    data = [part.encode() for part in parts]
    path.write_bytes(b"".join(data))
    told = keep_target(tmp_path)
    copies = [copy.read_bytes() for copy in tmp_path.iterdir() if copy != path]
    now = path.read_bytes()
    if b"".join(data) in copies:
        assert "my_functions.old.py" in told
    else:
        rest = now
        for part in (data[0], data[2]):  # in this order, and not one sign less
            part = part.replace(b"\r\n", b"\n").rstrip(b"\n")
            assert part in rest
            rest = rest[rest.index(part) + len(part) :]
        assert copies == []
    assert not told.startswith("Kept") or is_right("03", "target", tmp_path)


@settings(
    max_examples=100,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(st.binary(max_size=60))
def test_any_bytes_are_still_there_or_in_a_copy(tmp_path, data):
    path = fresh(tmp_path)
    path.write_bytes(data)
    text = data.removeprefix(codecs.BOM_UTF8).replace(b"\r\n", b"\n").rstrip(b"\n")
    for name in ("target", "target", "update"):
        keep_target(tmp_path, name)
        copies = [copy.read_bytes() for copy in tmp_path.iterdir() if copy != path]
        assert data in copies or text in path.read_bytes()


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
@pytest.mark.parametrize("new_line", ["\n", "\r\n"])
def test_a_file_that_an_editor_saved_in_another_way_goes_on(
    tmp_path, encoding, new_line
):
    keep_target(tmp_path)
    text = (
        (tmp_path / FILE)
        .read_text("utf-8")
        .replace("import math\n", "import math\nimport random  # été\n")
    )
    (tmp_path / FILE).write_bytes(
        (text + "# à moi\n").replace("\n", new_line).encode(encoding)
    )
    assert keep_target(tmp_path, "update").startswith("Kept")
    now = (tmp_path / FILE).read_text("utf-8")
    assert "import random  # été\n" in now and "# à moi\n" in now
    assert is_right("03", "target", tmp_path) and is_right("03", "update", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [FILE]


def test_a_check_that_is_run_again_replaces_its_own_section_alone(tmp_path):
    path = tmp_path / FILE
    path.write_text(
        f"# mine\n# lesson 03: target\n{SPOILT}# end of target\n\ndef my_helper(x):\n    return 2 * x\n"
    )
    assert keep_target(tmp_path).startswith("Kept")
    text = path.read_text()
    assert text.startswith("# mine\n# lesson 03: target\ndef target(")
    assert (
        text.endswith("# end of target\n\ndef my_helper(x):\n    return 2 * x\n")
        and text.count("def target") == 1
    )
    before = path.stat().st_mtime_ns
    keep_target(tmp_path)
    assert path.stat().st_mtime_ns == before and path.read_text() == text, (
        "nothing new, nothing written"
    )


def test_sections_stand_in_the_order_of_the_lessons(tmp_path):
    for name in ("update", "learn", "target"):
        keep_target(tmp_path, name)
    text = (tmp_path / FILE).read_text()
    assert text.startswith(HEAD)
    places = [
        text.index(f"\n\n\n# lesson 03: {name}\n")
        for name in ("learn", "target", "update")
    ]
    assert places == sorted(places)


def test_what_cannot_be_read_goes_to_a_copy_that_replaces_no_other(tmp_path):
    for data in (b"\0 one", b"\0 two"):
        (tmp_path / FILE).write_bytes(data)
        assert "is in my_functions.old" in keep_target(tmp_path)
    assert (tmp_path / "my_functions.old.py").read_bytes() == b"\0 one"
    assert (tmp_path / "my_functions.old2.py").read_bytes() == b"\0 two"


def test_an_answer_that_would_end_its_own_section_changes_nothing_and_says_why(
    tmp_path,
):
    cells = tmp_path / "cells.py"
    cells.write_text(
        TARGET.replace("    return", "# end of target\n    return", 1), "utf-8"
    )
    names = {}
    exec(compile(cells.read_text("utf-8"), str(cells), "exec"), names)
    told = keep(names["target"], "03", "target", check.target.judge, tmp_path)
    assert (
        "looks like" in told
        and told.startswith("(Not kept")
        and not (tmp_path / FILE).exists()
    )


def test_a_file_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / FILE).mkdir()
    assert keep_target(tmp_path).startswith(
        "(Not kept for later lessons: my_functions.py stays as it was: "
    )


def keep_one(folder, name):
    keep_target(folder, name)


def test_two_notebooks_at_once_both_keep_theirs(tmp_path):
    fork = multiprocessing.get_context(
        "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    )
    workers = [
        fork.Process(target=keep_one, args=(tmp_path, name))
        for name in ("target", "update", "learn")
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all(is_right("03", name, tmp_path) for name in ("target", "update", "learn"))
    assert [path.name for path in tmp_path.iterdir()] == [FILE]


def test_the_lock_of_a_notebook_that_was_killed_holds_nobody_up(tmp_path, monkeypatch):
    (tmp_path / f".{FILE}.lock").mkdir()
    monkeypatch.setattr(learners_files, "ABANDONED", 0.05)
    assert keep_target(tmp_path).startswith("Kept")
    (tmp_path / f".{FILE}.lock").write_text("no folder")
    assert "another notebook holds this" in keep_target(tmp_path, "update")


def test_a_file_that_is_no_text_is_told_by_take(tmp_path, capsys):
    (tmp_path / FILE).write_bytes(b"\0")
    assert take("03", "target", folder=tmp_path) is exercises.target
    assert "no text that can be read" in capsys.readouterr().out


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: (
        st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3)
    ),
    max_leaves=8,
)


@settings(
    max_examples=150,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(
    st.binary(max_size=40) | values.map(lambda value: json.dumps(value).encode()),
    st.sampled_from(["", "a", "03 x"]),
)
def test_an_entry_leaves_all_others_as_they_are_and_what_is_damaged_in_a_copy(
    tmp_path, data, name
):
    fresh(tmp_path)
    path = tmp_path / "my.json"
    path.write_bytes(data)
    told = enter(path, name, "new", str.strip)
    now = json.loads(path.read_bytes())
    try:
        before = json.loads(data)
    except ValueError:
        before = None
    if isinstance(before, dict) and isinstance(before.get(name, ""), str):
        assert now == {**before, name: "new"} and told == ""
    else:
        assert (tmp_path / "my.old.json").read_bytes() == data and "my.old.json" in told
        assert now == {**(before if isinstance(before, dict) else {}), name: "new"}
    assert entries(path, str.strip)[name] == "new"


def test_a_copy_has_a_name_of_its_own(tmp_path):
    path = tmp_path / "a.json"
    path.write_text("1")
    assert [put_aside(path) for _ in range(3)][
        -1
    ] == "What a.json was until now is in a.old3.json."


DAMAGED = [
    '{"01 turn": "left"',
    '["left"]',
    '{"01 turn": 3, "03 other": "x"}',
    "\0",
    "{" * 2000,
]


@pytest.mark.parametrize("text", DAMAGED)
def test_a_damaged_file_of_predictions_is_put_aside_and_the_reader_is_told(
    tmp_path, monkeypatch, text
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(prediction, "is_notebook", lambda: True)
    (tmp_path / "my_predictions.json").write_text(text)
    asked = prediction.Prediction("01 turn", "Where to?", ["left", "right"])
    asked.choose("right")
    assert (tmp_path / "my_predictions.old.json").read_text() == text
    assert "my_predictions.old.json" in asked._told.value
    assert prediction.kept("my_predictions.json")["01 turn"] == "right"


@pytest.mark.parametrize(
    "text",
    ['{"05": [1.0, 0.1], "11": "?"}', '{"05": [NaN, 1], "11": [2.0, 0.1]}', "[]", "{"],
)
def test_one_damaged_score_costs_no_other(tmp_path, monkeypatch, text):
    monkeypatch.chdir(tmp_path)
    (tmp_path / challenge.FILE).write_text(text)
    mine = lesson_05.challenge
    best, told = mine._keep(challenge.Score(0.5, 0.1))
    now = json.loads((tmp_path / challenge.FILE).read_text())
    if text.startswith('{"05": [1'):
        assert (
            best == (1.0, 0.1) and now == {"05": [1.0, 0.1], "11": "?"} and told == ""
        )
    else:
        assert (
            tmp_path / "my_challenges.old.json"
        ).read_text() == text and "my_challenges.old.json" in told
        assert now["05"] == [0.5, 0.1] and now.get("11", [2.0, 0.1]) == [2.0, 0.1]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"metadata": []}',
        '{"metadata": {"rlrobot_edu": 1}}',
        "\xff",
        "[" * 5000,
    ],
)
def test_a_broken_copy_of_a_notebook_stays_as_it_is(tmp_path, text):
    source, folder = tmp_path / "notebooks", tmp_path / "my_course"
    source.mkdir()
    folder.mkdir()
    (source / "00_start.ipynb").write_text('{"cells": [], "metadata": {}}')
    (folder / "00_start.ipynb").write_bytes(text.encode("latin-1"))
    copy_missing(source, folder)
    assert (folder / "00_start.ipynb").read_bytes() == text.encode("latin-1")
    set_back("00", source, folder)
    assert next((folder / "old").iterdir()).read_bytes() == text.encode("latin-1")


def test_progress_says_that_the_file_is_no_text(tmp_path, capsys):
    (tmp_path / FILE).write_bytes(b"\0")
    show_progress(tmp_path)
    assert "no text that can be read" in capsys.readouterr().out
