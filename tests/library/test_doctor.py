"""The doctor: what it says of this installation, and of ones in which something is missing, damaged or taken."""

import importlib.util
import re
import socket
import sys
import tomllib
from functools import partial
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import rlrobot_edu as rl
from rlrobot_edu.installing import to_install
from rlrobot_edu.jit import dispatcher
from rlrobot_edu.tools import doctor
from rlrobot_edu.tools.commands import main

PROJECT = tomllib.loads(
    (Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8")
)["project"]
EXTRAS = PROJECT["optional-dependencies"]
COMMAND = partial(to_install, pip=doctor.PIP)


def said(name: str) -> doctor.Finding:
    """What the doctor finds under this name."""
    (finding,) = (
        f
        for findings in doctor.examine().sections.values()
        for f in findings
        if f.name == name
    )
    return finding


@pytest.fixture
def absent(monkeypatch):
    """A function that makes distributions seem not to be installed."""
    version = metadata.version

    def hide(*names):
        def look_up(name):
            if name in names:
                raise metadata.PackageNotFoundError(name)
            return version(name)

        monkeypatch.setattr(metadata, "version", look_up)

    return hide


@pytest.fixture
def needs(monkeypatch):
    """A function that gives the package other requirements than its own."""
    return lambda *lines: monkeypatch.setattr(
        metadata, "requires", lambda name: list(lines)
    )


def test_every_extra_has_words_for_what_is_missing_without_it():
    assert doctor.WITHOUT.keys() == EXTRAS.keys()


@pytest.mark.parametrize("extra", EXTRAS)
def test_an_extra_is_there_with_its_versions_or_is_missed_with_the_command_that_brings_it(
    extra,
):
    says = said(extra).says
    if doctor.WITHOUT[extra] in says:
        assert COMMAND(extra) in says
    else:
        for name, version in (part.split(" ") for part in says.split(", ")):
            assert metadata.version(name) == version


def test_a_healthy_installation_is_well_and_names_all_that_the_package_needs(capsys):
    diagnosis = doctor.examine()
    core = {
        canonicalize_name(finding.name): finding
        for finding in diagnosis.sections["Needed by everything"]
    }
    assert core.keys() == {
        canonicalize_name(Requirement(line).name) for line in PROJECT["dependencies"]
    }
    assert core["numpy"].says == metadata.version("numpy") and not diagnosis.is_broken

    with pytest.raises(SystemExit) as end:
        main(["doctor"])
    text = capsys.readouterr().out
    assert not end.value.code
    assert f"{rl.__version__} in {dispatcher.PACKAGE}" in text and (
        "All is well." in text or "What to do:" in text
    )


def test_a_part_of_an_extra_that_is_missing_is_named_with_what_it_disables(absent):
    absent("websockets")
    finding = said("ros")
    assert (
        finding.says
        == f"websockets is missing.\nWithout it {doctor.WITHOUT['ros']}.\nTo install it: {COMMAND('ros')}"
    )
    assert not finding.to_do and not finding.is_broken  # nobody must have it


def test_an_extra_of_which_nothing_is_known_says_how_it_is_installed(needs):
    needs('rosbags; extra == "ros"')  # a checkout has gone on since pip was told of it
    assert said("arm").says.startswith("nothing of it is for this computer")
    assert COMMAND("arm") in said("arm").says


@pytest.mark.parametrize(
    ("spec", "command"), [(None, "uv pip"), (object(), "python -m pip")]
)
def test_what_installs_something_is_pip_or_uv_where_an_environment_has_no_pip(
    monkeypatch, spec, command
):
    with monkeypatch.context() as patch:
        patch.setattr(importlib.util, "find_spec", lambda name: spec)
        assert command == importlib.reload(doctor).PIP
    importlib.reload(doctor)


def test_a_damaged_package_of_the_core_is_broken_and_the_command_fails(
    monkeypatch, capsys
):
    monkeypatch.setitem(sys.modules, "pymunk", None)  # importing it fails
    finding = said("pymunk")
    assert (
        finding.is_broken and "cannot be imported: ModuleNotFoundError" in finding.says
    )
    with pytest.raises(SystemExit) as end:
        main(["doctor"])
    assert end.value.code == 1
    assert re.search(
        r'What to do:\n1\. .*pip install\s+--force-reinstall\s+"pymunk<8,>=7.0"',
        capsys.readouterr().out,
    )


@pytest.mark.parametrize(
    ("line", "words"), [("numpy>=999", ", not >=999"), ("no-such-thing", "is missing")]
)
def test_a_package_of_the_core_that_does_not_fit_or_is_not_there_is_broken(
    needs, line, words
):
    needs(line)
    finding = said(re.split(">", line)[0])
    assert finding.is_broken and words in finding.says and f'"{line}"' in finding.to_do


def test_a_package_that_pip_does_not_know_is_told_how_to_be_installed(
    monkeypatch, absent
):
    def unknown(name):
        raise metadata.PackageNotFoundError(name)

    absent("rlrobot-edu")
    monkeypatch.setattr(metadata, "requires", unknown)
    monkeypatch.setattr(metadata, "metadata", unknown)
    diagnosis = doctor.examine()
    assert diagnosis.is_broken and "pip install -e ." in str(diagnosis)


def test_an_older_version_known_to_pip_is_told(monkeypatch):
    monkeypatch.setattr(rl, "__version__", "99.0")
    finding = said("rlrobot-edu")
    assert "pip knows" in finding.says and finding.to_do and not finding.is_broken


def test_where_kernels_are_kept_or_why_they_are_plain_is_said(monkeypatch, tmp_path):
    monkeypatch.setattr(dispatcher, "IS_PLAIN", False)
    monkeypatch.setattr(dispatcher, "numba", dispatcher.numba or dispatcher)
    for folder, words in [
        (tmp_path, "not compiled yet"),
        (None, "compiled anew by every process"),
    ]:
        monkeypatch.setattr(dispatcher, "cache_folder", lambda folder=folder: folder)
        assert words in said("kernels").says
    (tmp_path / "learn.nbc").touch()
    monkeypatch.setattr(dispatcher, "cache_folder", lambda: tmp_path)
    assert said("kernels").says == f"compiled, kept in {tmp_path}"
    monkeypatch.setattr(dispatcher, "IS_PLAIN", True)
    assert "NUMBA_DISABLE_JIT" in said("kernels").says
    monkeypatch.setattr(dispatcher, "numba", None)
    assert "without numba" in said("kernels").says


def test_arms_without_pybullet_are_said_to_be_geometry(monkeypatch):
    monkeypatch.setitem(
        sys.modules, "rlrobot_edu.robots.engines.bullet.simulation", None
    )
    assert said("arms").says.startswith("geometry alone (engine='kinematic')")


def test_the_package_that_simulates_arms_is_named():
    pytest.importorskip("pybullet")
    (name,) = (n for n in ("pybullet", doctor.FORK) if is_installed(n))
    assert f"({name} {metadata.version(name)}" in said("arms").says
    assert ("a fork" in said("arms").says) == (name == doctor.FORK)


def is_installed(name):
    return any(d.name == name for d in metadata.distributions())


def test_a_fork_that_simulates_arms_is_said_to_be_one(monkeypatch):
    pytest.importorskip("pybullet")
    known = {doctor.FORK: "3.2.8"}

    def look_up(name):
        if name not in known:
            raise metadata.PackageNotFoundError(name)
        return known[name]

    monkeypatch.setattr(metadata, "version", look_up)
    assert doctor._arms().says == (
        "simulated by PyBullet (pybullet-arm64 3.2.8, a fork of it)"
    )


def test_versions_that_are_not_the_tested_ones_are_named(monkeypatch, tmp_path):
    pins = tmp_path / "constraints.txt"
    monkeypatch.setattr(doctor, "TESTED", pins)
    numpy = metadata.version("numpy")
    pins.write_text(f"numpy=={numpy}\nscipy==0.1 ; sys_platform == 'nowhere'\n")
    assert said("versions").says == "those with which the toolkit is tested"
    pins.write_text("numpy==0.1\n")
    finding = said("versions")
    assert finding.says.startswith(f"numpy {numpy} (tested: 0.1).\n")
    assert f"-c {pins}" in finding.says and not finding.is_broken


def test_a_folder_that_nobody_may_write_to_is_something_to_do(monkeypatch):
    def refuse(dir):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(doctor.tempfile, "TemporaryFile", refuse)
    finding = said("folder")
    assert (
        "Permission denied" in finding.says
        and "a folder of your own" in finding.to_do
        and not finding.is_broken
    )


def test_nothing_is_asked_of_the_network(monkeypatch):
    def refuse(*given):
        raise AssertionError(f"the network was asked for {given}")

    monkeypatch.setattr(socket, "getaddrinfo", refuse)
    monkeypatch.setattr(socket.socket, "connect", refuse)
    doctor.examine()


def test_the_report_stands_in_two_columns_and_no_line_is_longer_than_a_terminal():
    text = str(doctor.examine())
    for line in text.splitlines():
        assert len(line) <= doctor.WIDTH or line.strip().count(" ") <= 5, (
            line
        )  # a path is not broken
        if line.startswith("  "):
            assert re.match(rf".{{{doctor.INDENT}}}\S", line), line
