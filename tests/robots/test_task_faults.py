"""Task files that are not as they should be, in the toolkit's own folder and elsewhere: named, and no others suffer."""

import os
import pickle
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_tasks import GOOD, write

import rlrobot_edu as rl
from rlrobot_edu.checks import MOST_BINS, MOST_PAIRS
from rlrobot_edu.files import shipped
from rlrobot_edu.task.task_file import available_tasks

PACKAGE = Path(rl.__file__).parent


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """A function that runs Python with a copy of the package, whose folder of tasks is not as it should be."""
    home = tmp_path_factory.mktemp("copy")
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(PACKAGE, home / "rlrobot_edu", ignore=ignored)
    tasks = shutil.copytree(shipped("tasks"), home / "tasks")
    for name in ("wander_simple copy", "wander-simple", "2nd", "größe"):
        shutil.copy(tasks / "wander_simple.py", tasks / f"{name}.py")
    (tasks / "broken.py").write_text("task = Task(", encoding="utf-8")
    (tasks / "ends.py").write_text("import sys\nsys.exit()", encoding="utf-8")
    (tasks / "nothing.py").touch()
    (tasks / "binary.py").write_bytes(b"\xff\xfe")
    (tasks / "no_words.py").write_text(GOOD.partition("\n")[2], encoding="utf-8")
    (tasks / "folder.py").mkdir()

    def run(*command, **settings):
        environment = {
            **os.environ,
            "PYTHONPATH": str(home),
            "PYTHONIOENCODING": "utf-8",
            **settings,
        }
        return subprocess.run(
            [sys.executable, *command], cwd=home, env=environment, capture_output=True
        )

    return run


def test_files_that_are_no_tasks_in_the_folder_of_tasks_do_not_disturb_the_others(
    python,
):
    code = (
        "import rlrobot_edu as rl, gymnasium\n"
        "from rlrobot_edu.task.task_file import available_tasks\n"
        "ids = sum(name.startswith('rlrobot/') for name in gymnasium.registry)\n"
        "print(rl.load_task('no_words').states.n, len(available_tasks()), ids)"
    )
    done = python("-c", code)
    assert done.returncode == 0, done.stderr.decode()
    n = len(available_tasks()) + len(
        ("broken", "ends", "nothing", "binary", "no_words", "folder", "größe")
    )
    assert done.stdout.split() == [b"3", b"%d" % n, b"%d" % n]


def test_the_list_of_tasks_says_what_is_wrong_with_one_and_goes_on(python):
    done = python("-m", "rlrobot_edu", "tasks")
    assert (done.returncode, done.stderr) == (0, b"")
    said = {line.split()[0]: line for line in done.stdout.decode().splitlines()}
    assert set(available_tasks()) < set(said)
    assert not any(
        "cannot be loaded" in said[name]
        for name in (*available_tasks(), "no_words", "größe")
    )
    for name, what in {
        "broken": "never closed", "ends": "line 2: SystemExit", "nothing": "must define task", "binary": "SyntaxError",
        "folder": "no such",
    }.items():  # fmt: skip
        assert (
            "cannot be loaded" in said[name]
            and f"{name}.py" in said[name]
            and what in said[name]
        )


@pytest.mark.parametrize("command", ["tasks", "--help"])
def test_a_terminal_that_knows_ascii_alone_shows_question_marks(python, command):
    done = python("-m", "rlrobot_edu", command, PYTHONIOENCODING="ascii")
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.isascii() and (command != "tasks" or b"1024 ? 9" in done.stdout)


@pytest.mark.skipif(
    os.name != "posix", reason="needs a pipe that tells its writer that nobody reads"
)
def test_a_reader_who_has_seen_enough_ends_the_list_without_a_word():
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "rlrobot_edu", "tasks"]
    done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert done.stderr == b"" and done.returncode != 0


FAULTS = {
    "1 / 0": "ZeroDivisionError: division by zero",
    "__import__('sys').exit()": "SystemExit",
    "after_all": "NameError",
    "readings['lasr']": r"there is no 'lasr'(\.|; did you mean 'laser_\w+'\?) There are ",
}


@pytest.mark.parametrize("what", ["goal", "reward", "command"])
@pytest.mark.parametrize("fault", FAULTS)
def test_a_function_of_a_task_that_fails_is_named_with_its_file_and_line(
    tmp_path, what, fault
):
    broken = f"def broken(*given):\n    readings = given[-1]\n    return {fault}\n"
    text = f"{GOOD}\n\n{broken}\n\nfrom dataclasses import replace\n\ntask = replace(task, {what}=broken)\n"
    line = text.split(f"return {fault}")[0].count("\n") + 1
    path = tmp_path / "my_own.py"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(
        ValueError, match=rf"my_own\.py, line {line}: {what} .*failed: {FAULTS[fault]}"
    ):
        env = rl.make_env(path, seed=0)
        env.reset()
        env.step(0)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("rewards=[-1, 1]", "rewards=[-1, 1], step_time=1e9", "at most 600, got 1000000000.0"),
        ("rewards=[-1, 1]", "rewards=[-1, 1], step_time=float('inf')", "at most 600"),
        ("rewards=[-1, 1]", "rewards=[-1, 1], step_time=True and '1'", "step_time"),
        ('laser_front", cuts=[0.2, 0.5], unit="m"', 'theta", sectors=10**7, unit="rad"', f"at most {MOST_BINS:,}"),
        (
            'inputs=[InputVariable("laser_front", cuts=[0.2, 0.5], unit="m")]',
            'inputs=[InputVariable(n, cuts=[i / 1e5 for i in range(1, 9999)], unit="m") for n in ("laser_left", '
            '"laser_right")]',
            f"99,980,001 states × 4 actions are too many for a table: at most {MOST_PAIRS:,}",
        ),
        ("task = Task", "import sys; sys.exit(3)\ntask = Task", "line 4: SystemExit: 3"),
        ("task = Task", "raise SystemExit\ntask = Task", "SystemExit"),
        ("task = Task", "raise SystemError('no')\ntask = Task", "line 4: SystemError: no"),
    ],
)  # fmt: skip
def test_what_would_hang_fill_the_memory_or_end_the_program_is_refused_in_a_sentence(
    tmp_path, old, new, words
):
    path = write(tmp_path, old, new)
    with pytest.raises(ValueError) as refusal:
        rl.load_task(path)
    assert str(path) in str(refusal.value) and words in str(refusal.value)
    assert "\n" not in str(refusal.value) and len(str(refusal.value)) < 600


HEADS = {
    "a dataclass": "from dataclasses import dataclass\n@dataclass\nclass Limits:\n    near: 'float' = 0.05\n",
    "annotations": "from __future__ import annotations\nfrom dataclasses import dataclass, field\n@dataclass\n"
    "class Limits:\n    near: float = field(default=0.05, kw_only=True)\n",
    "a named tuple": "from typing import NamedTuple\nclass Limits(NamedTuple):\n    near: float = 0.05\n",
    "an enum": "from enum import Enum\nclass Limits(float, Enum):\n    near = 0.05\n",
    "pickle": "import pickle\nclass Limits:\n    near = 0.05\nassert pickle.loads(pickle.dumps(Limits())).near\n",
    "its own name": "import sys\nclass Limits:\n    near = 0.05\nassert sys.modules[__name__].Limits is Limits\n",
}


@pytest.mark.parametrize("head", HEADS)
def test_a_task_file_may_hold_whatever_a_module_may(tmp_path, head):
    text = (
        Path(rl.load_task("wander_simple").path)
        .read_text(encoding="utf-8")
        .split('"""', 2)[2]
    )
    before = set(sys.modules)
    (tmp_path / "mine.py").write_text(HEADS[head] + text, encoding="utf-8")
    task = rl.load_task(tmp_path / "mine.py")
    assert rl.learn(
        rl.Agent(task, seed=0),
        rl.make_env(pickle.loads(pickle.dumps(task)), seed=0),
        3,
        progress=False,
    )
    assert not [
        name for name in set(sys.modules) - before if "rlrobot_edu_task" in name
    ]


def test_line_ends_do_not_change_what_task_it_is(tmp_path):
    text = Path(rl.load_task("wander_simple").path).read_bytes().replace(b"\r\n", b"\n")
    prints = set()
    for ends in (b"\n", b"\r\n"):
        (tmp_path / "mine.py").write_bytes(text.replace(b"\n", ends))
        prints.add(rl.load_task(tmp_path / "mine.py").fingerprint)
    assert len(prints) == 1


def test_a_goal_that_gives_no_truth_value_names_the_file(tmp_path):
    task = replace(
        rl.load_task("navigation_1k"), goal=lambda readings: np.zeros(2), path="mine.py"
    )
    with pytest.raises(ValueError, match=r"^mine\.py: goal failed: ValueError"):
        task.at_goal({})


@pytest.mark.parametrize("wrong", [[], {}, 3, b"pymunk", ("pymunk",)])
def test_an_engine_or_a_recording_of_another_kind_is_refused_in_words(wrong):
    if wrong:
        with pytest.raises(ValueError, match="has no engine"):
            rl.make_env("wander_simple", engine=wrong)
    with pytest.raises(ValueError, match="a recording is the name of one"):
        rl.read_recording(wrong)


def test_a_task_of_the_toolkit_is_the_same_one_each_time_and_an_edited_file_another(
    tmp_path,
):
    assert (
        rl.load_task("wander_1k")
        is rl.load_task("wander_1k")
        is rl.Agent("wander_1k").task
    )
    path = tmp_path / "mine.py"
    path.write_text(GOOD, encoding="utf-8")
    first = rl.load_task(path)
    path.write_text(GOOD.replace("0.2", "0.3"), encoding="utf-8")
    assert rl.load_task(path).inputs[0].cuts == (0.3, 0.5) and first.inputs[0].cuts == (
        0.2,
        0.5,
    )
