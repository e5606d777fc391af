"""Compiled kernels are kept where there is a place, and where there is none, or a damaged file, they are made anew."""

import hashlib
import importlib.util
import os
import pickle
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import pytest
from faults import full_disk, needs_limits

import rlrobot_edu as rl
from rlrobot_edu.files import shipped
from rlrobot_edu.jit import dispatcher

numba = pytest.importorskip("numba")
kernel_cache = pytest.importorskip("rlrobot_edu.jit.caching")
pytestmark = pytest.mark.skipif(
    numba.config.DISABLE_JIT, reason="needs kernels that are compiled"
)

PACKAGE = Path(rl.__file__).parent


RULE = """
from rlrobot_edu.jit import dispatcher

FACTOR = 2

@dispatcher.compiled
def times(x):
    return FACTOR * x

def twice(x):
    return times(x)
"""


@pytest.fixture
def load(tmp_path, monkeypatch):
    """A function that gives a small kernel as a new process finds it: with its cache, and yet to be compiled."""
    (tmp_path / "package").mkdir()
    (tmp_path / "rule.py").write_text(RULE, encoding="utf-8")
    monkeypatch.setattr(dispatcher, "PACKAGE", tmp_path / "package")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setattr(dispatcher, "FOLDER", dispatcher.cache_folder())

    monkeypatch.setattr(
        sys, "dont_write_bytecode", True
    )  # a full disk would cut it off

    def load_kernel(old="", new=""):
        """The kernel, after `old` in its file has been replaced with `new`."""
        if old:
            rule = (tmp_path / "rule.py").read_text(encoding="utf-8")
            (tmp_path / "rule.py").write_text(rule.replace(old, new), encoding="utf-8")
        spec = importlib.util.spec_from_file_location("rule", tmp_path / "rule.py")
        module = importlib.util.module_from_spec(spec)
        monkeypatch.setitem(sys.modules, "rule", module)  # where numba looks for it
        spec.loader.exec_module(module)
        kernel_cache._warn_once.cache_clear()
        return dispatcher.compiled(module.twice)

    return load_kernel


def kept(folder):
    """The files of the kernel in the cache."""
    return sorted(Path(folder).rglob("rule.twice-*"))


def is_kept(kernel, factor=2):
    """Whether the kernel, which is right, came from the cache."""
    assert kernel(21) == 21 * factor
    return sum(kernel.stats.cache_hits.values()) == 1


def test_a_kernel_is_compiled_once(load, tmp_path):
    assert not is_kept(load())
    assert is_kept(load())
    assert len(kept(tmp_path)) == 1


def test_an_edit_runs_wherever_it_is_and_what_no_kernel_is_made_of_costs_nothing(
    load, tmp_path
):
    assert not is_kept(load())
    assert not is_kept(
        load("FACTOR = 2", "FACTOR = 3"), factor=3
    )  # what the kernel calls reaches it
    assert not is_kept(load("FACTOR * x", "(FACTOR + 1) * x"), factor=4)
    assert is_kept(
        load("(FACTOR + 1) * x", "FACTOR * x"), factor=3
    )  # the versions stand side by side
    assert is_kept(load("FACTOR = 3", "# an edit\n\nOTHER = 1\nFACTOR = 2"))
    assert len(kept(tmp_path)) == 3


def test_a_kernel_that_no_process_has_asked_for_in_a_month_goes(load, tmp_path):
    is_kept(load())
    (used,), unused = (
        kept(tmp_path),
        [path for path in tmp_path.rglob("*.nbc") if "times" in path.name],
    )
    for path in (used, *unused):
        os.utime(path, (0, 0))
    assert is_kept(load())  # which asks for it
    is_kept(load("FACTOR = 2", "FACTOR = 3"), factor=3)
    assert used.exists() and unused and not any(path.exists() for path in unused)


DAMAGE = {
    "cut": lambda data: data[: len(data) // 2],
    "cut at its end": lambda data: data[:-1],
    "emptied": lambda _: b"",
    "garbage": lambda data: bytes(255 - byte for byte in data),
    "another pickle": lambda _: pickle.dumps((1, 2, 3)),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_a_damaged_cache_is_made_anew_without_a_word(load, tmp_path, damage, capsys):
    assert not is_kept(load())
    (path,) = kept(tmp_path)
    path.write_bytes(DAMAGE[damage](path.read_bytes()))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not is_kept(load())
        assert is_kept(load())
    assert capsys.readouterr() == ("", "")


@needs_limits
def test_on_a_full_disk_kernels_run_and_are_kept_when_there_is_room(load, tmp_path):
    for _ in range(2):
        with (
            full_disk(20),
            pytest.warns(
                UserWarning, match="compiled kernels cannot be kept .*File too large"
            ),
        ):
            assert not is_kept(load())
        assert not [*tmp_path.rglob("*.nbc")]
    assert not is_kept(load())
    assert is_kept(load())


LEARN = """
import hashlib, os, sys
if sys.argv[1] == "no home":
    import pwd
    del os.environ["HOME"]
    pwd.getpwuid = {}.__getitem__  # nobody is known here
else:
    import resource
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))

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
    said = run.stderr.splitlines()
    assert len(said) < 4, run.stderr
    assert not [*tmp_path.rglob("*.nbc")]
