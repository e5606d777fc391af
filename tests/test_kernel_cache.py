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
from rlrobot_edu.learning import jit

numba = pytest.importorskip("numba")
kernel_cache = pytest.importorskip("rlrobot_edu.learning.kernel_cache")
pytestmark = pytest.mark.skipif(numba.config.DISABLE_JIT, reason="needs kernels that are compiled")

PACKAGE = Path(rl.__file__).parent


@pytest.fixture
def load(tmp_path, monkeypatch):
    """A function that gives a small kernel as a new process finds it: with its cache, and yet to be compiled."""
    (tmp_path / "package").mkdir()
    (tmp_path / "rule.py").write_text("def twice(x):\n    return 2 * x\n", encoding="utf-8")
    monkeypatch.setattr(jit, "PACKAGE", tmp_path / "package")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))

    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # a full disk would cut it off

    def load_kernel():
        spec = importlib.util.spec_from_file_location("rule", tmp_path / "rule.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        jit._say_once.cache_clear()
        kernel_cache._warn_once.cache_clear()
        return jit._decorator()(module.twice)

    return load_kernel


def kept(folder):
    """The files of the cache."""
    return sorted(Path(folder).rglob("*.nb*"))


def is_kept(kernel):
    """Whether the kernel, which is right, came from the cache."""
    assert kernel(21) == 42
    return sum(kernel.stats.cache_hits.values()) == 1


def test_a_kernel_is_compiled_once_and_says_so_once(load, tmp_path, capsys):
    for is_first in (True, False):
        kernel = load()
        jit.announce_compilation(kernel)
        assert capsys.readouterr().err.startswith("Compiling") == is_first
        assert is_kept(kernel) != is_first
    assert [path.suffix for path in kept(tmp_path)] == [".nbc", ".nbi"]


DAMAGE = {
    "cut": lambda data: data[: len(data) // 2],
    "cut at its end": lambda data: data[:-1],
    "emptied": lambda _: b"",
    "garbage": lambda data: bytes(255 - byte for byte in data),
    "another pickle": lambda _: pickle.dumps(numba.__version__) + pickle.dumps((1, 2, 3)),
    "of another version": lambda _: pickle.dumps("0.1"),
}


@pytest.mark.parametrize("suffix", [".nbc", ".nbi"])
@pytest.mark.parametrize("damage", DAMAGE)
def test_a_damaged_cache_is_made_anew_without_a_word(load, tmp_path, suffix, damage, capsys):
    assert not is_kept(load())
    (path,) = (path for path in kept(tmp_path) if path.suffix == suffix)
    path.write_bytes(DAMAGE[damage](path.read_bytes()))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not is_kept(load())
        assert is_kept(load())
    assert capsys.readouterr() == ("", "")


@needs_limits
def test_on_a_full_disk_kernels_run_and_are_kept_when_there_is_room(load, tmp_path):
    for _ in range(2):
        with full_disk(20), pytest.warns(UserWarning, match="compiled kernels cannot be kept .*File too large"):
            assert not is_kept(load())
        assert not kept(tmp_path)
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
from rlrobot_edu.learning import jit
agent, env = rl.Agent("worked_example", "Q+SR", seed=0), rl.make_env("worked_example", seed=0)
rl.learn(agent, env, steps=200, progress=False)
assert rl.__file__.startswith(sys.argv[2]), rl.__file__
print(hashlib.sha256(agent.q.tobytes()).hexdigest(), jit.cache_folder() is None)
"""


@needs_limits
@pytest.mark.parametrize("fault", ["no home", "full disk"])
def test_a_new_package_learns_where_its_kernels_cannot_be_kept(fault, tmp_path):
    package = shutil.copytree(
        PACKAGE, tmp_path / "rlrobot_edu", ignore=shutil.ignore_patterns("__pycache__", "course", "reproduction")
    )
    shutil.copytree(shipped("tasks"), tmp_path / "tasks")
    if fault == "no home":  # and no place in the package: not even root can make a folder of a file
        (package / "__pycache__").touch()
    methods = package / "learning" / "methods.py"
    text = methods.read_text(encoding="utf-8")
    for name, line in (("Q_LEARNING", "for a in ("), ("SR", "for s in (")):  # one method alone is compiled sooner
        assert text.count(line) == 1
        text = text.replace(line, f"{line}{name},) + 0 * (")
    methods.write_text(text, encoding="utf-8")

    run = subprocess.run(
        [sys.executable, "-c", LEARN, fault, tmp_path],
        cwd=tmp_path,
        env={**os.environ, "HOME": str(tmp_path / "home"), "PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    agent, env = rl.Agent("worked_example", "Q+SR", seed=0), rl.make_env("worked_example", seed=0)
    rl.learn(agent, env, steps=200, progress=False)
    assert run.stdout.split() == [hashlib.sha256(agent.q.tobytes()).hexdigest(), str(fault == "no home")]
    said = run.stderr.splitlines()
    assert said[0].startswith("Compiling the learning kernels") and len(said) < 5, run.stderr
    assert not kept(tmp_path)
