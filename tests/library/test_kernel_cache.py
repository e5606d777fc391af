"""Compiled kernels are kept where there is a place, and where there is none they are made anew."""

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from faults import needs_limits

import rlrobot_edu as rl
from rlrobot_edu.files import shipped
from rlrobot_edu.jit import building
from rlrobot_edu.learning.algorithms import sarsa
from rlrobot_edu.learning.templates import step

numba = pytest.importorskip("numba")
pytestmark = pytest.mark.skipif(
    numba.config.DISABLE_JIT, reason="needs kernels that are compiled"
)

PACKAGE = Path(rl.__file__).parent


def test_a_built_module_is_its_template_with_other_imports():
    built = building.build(step, update=sarsa.update, ON_POLICY=True)
    text = Path(built.__file__).read_text(encoding="utf-8")
    assert text.startswith(Path(step.__file__).read_text(encoding="utf-8"))
    assert built.update is sarsa.update and built.ON_POLICY and not step.ON_POLICY
    assert building.build(step, update=sarsa.update, ON_POLICY=True) is built


def test_its_name_holds_the_sources_of_the_packages_so_an_edit_anywhere_is_seen(
    tmp_path, monkeypatch
):
    monkeypatch.setattr(building, "FOLDER", tmp_path)

    def build():
        return building._build.__wrapped__(step, (), update=sarsa.update)

    before = build()
    assert build() is before
    edited = {"rlrobot_edu": "other sources"}
    monkeypatch.setattr(building, "sources_of", edited.__getitem__)
    after = build()
    assert after.__file__ != before.__file__ and after is not before


def test_what_no_module_can_import_is_in_memory_alone(tmp_path, monkeypatch):
    def update(m, s, a, r, s_next, a_next, terminated):
        return 0.0

    monkeypatch.setattr(building, "FOLDER", tmp_path)
    built = building.build(step, update=update)
    assert built.update.py_func.__code__ is update.__code__
    assert not [*tmp_path.iterdir()]


def test_modules_that_nobody_has_built_in_a_month_go(tmp_path, monkeypatch):
    monkeypatch.setattr(building, "FOLDER", tmp_path)
    old, young = tmp_path / "old.py", tmp_path / "young.py"
    old.touch()
    young.touch()
    os.utime(old, (0, 0))
    monkeypatch.setattr(building, "sources_of", lambda package: "of a month later")
    building._build.__wrapped__(step, (), update=sarsa.update)
    assert young.exists() and not old.exists()


def said_by_the_second_process(program):
    """What this program prints, run once more after it has run."""
    for _ in range(2):
        ran = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True
        )
        assert not ran.returncode, ran.stderr
    return ran.stdout.strip()


HITS = """
import rlrobot_edu as rl
from rlrobot_edu.learning import compiled_loop
runs = []
make_run = compiled_loop.make_run
compiled_loop.make_run = lambda *kind: runs.append(make_run(*kind)) or runs[-1]
model = rl.SampleModel.from_recording(rl.read_recording("wander_simple"))
rl.learn(rl.Agent(model, "Q+SR", seed=0), rl.make_env(model, seed=0), 10, progress=False)
print(sum(runs[0].stats.cache_hits.values()))
"""


def test_the_next_process_finds_what_this_one_has_compiled():
    assert said_by_the_second_process(HITS) == "1"


LEARN = """
import hashlib, os, sys
if sys.argv[1] == "no home":
    import pwd
    del os.environ["HOME"]
    pwd.getpwuid = {}.__getitem__  # nobody is known here
else:
    import resource
    resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

import rlrobot_edu as rl
from rlrobot_edu.jit import dispatcher
agent, env = rl.Agent("worked_example", "Q+SR", seed=0), rl.make_env("worked_example", seed=0)
rl.learn(agent, env, steps=200, progress=False)
assert rl.__file__.startswith(sys.argv[2]), rl.__file__
print(hashlib.sha256(agent.q.tobytes()).hexdigest(), dispatcher.cache_folder() is None)
"""


@pytest.mark.long
@needs_limits
@pytest.mark.parametrize("fault", ["no home", "full disk"])
def test_a_new_package_learns_where_its_kernels_cannot_be_kept(fault, tmp_path):
    package = shutil.copytree(
        PACKAGE, tmp_path / "rlrobot_edu", ignore=shutil.ignore_patterns("__pycache__")
    )
    shutil.copytree(shipped("tasks"), tmp_path / "tasks")
    if (
        fault == "no home"
    ):  # and no place in the package: not even root can make a folder of a file
        (package / "__pycache__").touch()

    run = subprocess.run(
        [sys.executable, "-c", LEARN, fault, tmp_path],
        cwd=tmp_path,
        env={**os.environ, "HOME": str(tmp_path / "home"), "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    agent, env = (
        rl.Agent("worked_example", "Q+SR", seed=0),
        rl.make_env("worked_example", seed=0),
    )
    rl.learn(agent, env, steps=200, progress=False)
    assert run.stdout.split() == [
        hashlib.sha256(agent.q.tobytes()).hexdigest(),
        str(fault == "no home"),
    ]
    assert len(run.stderr.splitlines()) < 4, run.stderr
    assert not [*tmp_path.rglob("*.nbc")]


OWN = """
import mine
import rlrobot_edu as rl
from rlrobot_edu.learning.step import make_step
agent = rl.Agent("worked_example", rl.Method(rl.Algorithm("MINE", mine.update), "SR"))
print(agent.update(0, 0, 1.0, 1, 0, False))
update = make_step(agent.method).update
print(sum(update.stats.cache_hits.values()))
"""


@pytest.mark.long
def test_the_next_process_finds_somebodys_own_kernel_unless_what_it_refers_to_was_edited(
    tmp_path,
):
    told = []
    for factor in (2, 2, 3):
        (tmp_path / "mine.py").write_text(
            f"FACTOR = {factor}.0\n\n\ndef update(m, s, a, r, s_next, a_next, terminated):\n"
            "    return FACTOR * r\n",
            encoding="utf-8",
        )
        ran = subprocess.run(
            [sys.executable, "-B", "-c", OWN],
            cwd=tmp_path,
            capture_output=True,
            text=True,
        )
        assert not ran.returncode, ran.stderr
        told.append(ran.stdout.split())
    assert told == [["2.0", "0"], ["2.0", "1"], ["3.0", "0"]]


JUDGED = """
from rlrobot_edu.robots.engines.kinematic.compiled_task import judge_of
from rlrobot_edu.task.robot_cards import ROBOTS
from rlrobot_edu.task.task_file import load_task
task = load_task("wander_1k")
print(judge_of(task, list(ROBOTS[task.robot].sensors)).cache_hits)
"""


def test_the_next_process_finds_the_judge_of_a_task():
    assert said_by_the_second_process(JUDGED) == "1"
