"""The command line: what --help teaches, in the course's commands and in the library's own."""

import os
import re
import sys
from unittest.mock import Mock

import pytest

import rlrobot_edu as rl
from rlrobot_course.commands import open_lab
from rlrobot_edu.task.task_file import available_tasks
from rlrobot_edu.tools import commands

NAMES = [
    "lab",
    "fresh",
    "progress",
    "doctor",
    "tasks",
    "new-task",
    "check-task",
    "serve-robot",
    "course",
    "compile",
]


@pytest.fixture(autouse=True)
def called(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["rlrobot-edu"])


def help_of(capsys, *words: str) -> str:
    with pytest.raises(SystemExit) as end:
        commands.main([*words, "--help"])
    assert end.value.code == 0
    return " ".join(capsys.readouterr().out.split())


def test_help_names_every_command_with_a_line_and_three_to_begin_with(capsys):
    text = help_of(capsys)
    for name in NAMES:
        assert f" {name} " in text
    first = text.partition("begin with:")[2]
    assert re.findall(r"rlrobot-edu ([a-z-]+) ", first) == [
        "doctor",
        "lab",
        "check-task",
    ]


@pytest.mark.parametrize("name", NAMES)
def test_help_of_a_command_says_what_it_does_with_an_example_that_can_be_typed(
    capsys, name
):
    text = help_of(capsys, name)
    (example,) = re.findall(rf"Example: rlrobot-edu ({name}.*)$", text)
    run, _ = commands.parse(example.split())
    assert " ".join(run.__doc__.split()) in text


@pytest.mark.parametrize(("called", "name"), [
    ("/usr/bin/rlrobot-edu", "rlrobot-edu"), ("rlrobot-edu.exe", "rlrobot-edu"),
    ("rlrobot_edu/__main__.py", "python -m rlrobot_edu"),
])  # fmt: skip
def test_help_calls_the_command_as_it_was_called(monkeypatch, capsys, called, name):
    monkeypatch.setattr(sys, "argv", [called])
    assert help_of(capsys, "tasks").startswith(f"usage: {name} tasks ")


def test_tasks_are_listed_and_a_new_one_is_written_where_you_are(
    capsys, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    commands.main(["tasks"])
    assert {line.split()[0] for line in capsys.readouterr().out.splitlines()} == set(
        available_tasks()
    )
    commands.main(["new-task", "follow_wall"])
    assert "Written: follow_wall.py" in capsys.readouterr().out
    with pytest.raises(SystemExit, match="follow_wall"):
        commands.main(["new-task", "follow_wall"])


def test_a_wrong_task_is_told_in_a_sentence():
    with pytest.raises(SystemExit, match="wander_1k"):
        commands.main(["check-task", "wander1k"])
    with pytest.raises(SystemExit, match="lesson"):
        commands.main(["fresh", "77"])


def test_a_file_that_cannot_be_written_is_told_in_a_sentence_without_the_systems_number(
    tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(
        os, "fsync", Mock(side_effect=PermissionError(13, "Permission denied"))
    )
    with pytest.raises(
        SystemExit, match=r"^not writable; choose a folder of your own: 'mine\.py'$"
    ):
        commands.main(["new-task", "mine"])


@pytest.mark.parametrize(
    "more",
    [
        ["--allow-root"],
        ["--port", "9999", "--no-browser"],
        ["a.ipynb", "--port=1"],
        ["--version"],
        [],
    ],
)
def test_what_follows_lab_goes_to_jupyterlab_as_it_stands(more):
    assert commands.parse(["lab", *more]) == (open_lab, {"more": more})


def test_without_a_command_there_is_the_help_and_no_error(capsys):
    with pytest.raises(SystemExit) as end:
        commands.main([])
    assert end.value.code == 0
    alone = capsys.readouterr()
    assert alone.err == ""
    assert " ".join(alone.out.split()) == help_of(capsys)


def test_the_version_can_be_asked_for(capsys):
    with pytest.raises(SystemExit) as end:
        commands.main(["--version"])
    assert end.value.code == 0
    assert capsys.readouterr().out == f"rlrobot-edu {rl.__version__}\n"


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ("grade --contaner x handed_in", "--container"), ("new-task reach --robt arm", "--robot"),
        ("new-task reach --robot mobilebase", "mobile_base"), ("check-task Wander-1k", "wander_1k"),
        ("fresh homwork 1", "homework 1"), ("course chek 04", "check"),
    ],
)  # fmt: skip
def test_a_slip_in_any_word_of_a_command_is_answered_with_what_was_meant(
    capsys, words, meant
):
    with pytest.raises(SystemExit) as end:
        commands.main(words.split())
    assert f"did you mean {meant!r}?" in f"{end.value} {capsys.readouterr().err}"


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("slip", ["left out", "changed", "doubled", "exchanged"])
def test_a_slip_in_a_command_gets_the_command_that_was_meant(capsys, name, slip):
    word = {
        "left out": name[:1] + name[2:],
        "changed": f"{name[:-1]}q",
        "doubled": name[:2] + name[1:],
        "exchanged": name[1] + name[0] + name[2:],
    }[slip]
    with pytest.raises(SystemExit) as end:
        commands.main([word])
    assert end.value.code == 2
    assert f"did you mean {name!r}?" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--quick"], ["--"], [""], ["xyzzy"]])
def test_what_is_no_command_is_refused_in_a_sentence(capsys, words):
    with pytest.raises(SystemExit) as end:
        commands.main(words)
    assert end.value.code == 2
    said = capsys.readouterr().err
    assert "there is no command" in said or "a command comes first" in said


@pytest.mark.parametrize("name", ["nofile.toml", "nofile.py", "folder/nofile"])
def test_what_looks_like_a_file_is_told_to_be_none_and_not_to_be_no_name(name):
    with pytest.raises(SystemExit, match=r"nofile.*: there is no such task file"):
        commands.main(["check-task", name])


def test_an_option_that_is_not_known_is_refused(capsys):
    with pytest.raises(SystemExit) as end:
        commands.main(["tasks", "--quick"])
    assert (
        end.value.code == 2
        and "tasks does not know --quick." in capsys.readouterr().err
    )


def test_the_library_has_its_own_commands_without_the_other_packages(
    monkeypatch, capsys
):
    monkeypatch.setattr(commands, "entry_points", lambda group: [])
    with pytest.raises(SystemExit):
        commands.main(["--help"])
    first_words = re.findall(r"^    ([a-z-]+)", capsys.readouterr().out, re.MULTILINE)
    assert first_words == ["doctor", "tasks", "new-task", "check-task"]
