"""The report of ``python -m rlrobot_edu doctor``: what is installed, what is missing, and what that disables.

The requirements come from the package's own metadata, which pip has written from pyproject.toml. Only the words for
what an extra brings are ours.
"""

import importlib.util
import platform
import sys
import tempfile
import textwrap
from collections.abc import Iterator
from contextlib import suppress
from importlib import metadata
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import rlrobot_edu
from rlrobot_edu.files import shipped
from rlrobot_edu.installing import NAME, to_install
from rlrobot_edu.jit import dispatcher

WIDTH = 100  # of a line
INDENT = 15  # of the text beside a name
# uv makes environments without pip.
PIP = "python -m pip" if importlib.util.find_spec("pip") else "uv pip"
ANEW = f"Install the toolkit anew, in its folder: {PIP} install -e ."

MODULES = {"pillow": "PIL"}  # of packages that are not named like their module
TESTED = shipped("constraints.txt")
FORK = "pybullet-arm64"  # what the extra arm brings where PyBullet has no wheel
# What is missing without an extra of pyproject.toml.
WITHOUT = {
    "arm": "arms are geometry alone, which bumps into nothing; engine='pybullet' does not work",
    "notebook": "there are no widgets and no 3D: no rl.Stepper, rl.meshcat, .show3d() or rl.watch",
    "lab": "the command lab does not open the course, and grade marks no notebook",
    "ros": "no bag of ROS can be read, or no robot driven or served over rosbridge",
    "all": "Dask's clusters are missing",
}


class Finding(NamedTuple):
    """One line of the report.

    name: of the thing examined; says: what was found
    to_do: a sentence if something should be done about it; is_broken: whether the toolkit cannot work like this
    """

    name: str
    says: str
    to_do: str = ""
    is_broken: bool = False


class Diagnosis(NamedTuple):
    """All findings, by the heading under which they stand; `print` shows them."""

    sections: dict[str, list[Finding]]

    @property
    def is_broken(self) -> bool:
        """Whether something is wrong without which the toolkit cannot work."""
        return any(finding.is_broken for finding in self._findings)

    @property
    def _findings(self) -> Iterator[Finding]:
        return chain.from_iterable(self.sections.values())

    def __str__(self) -> str:
        lines = []
        for heading, findings in self.sections.items():
            lines.append(heading)
            lines += [_line(finding) for finding in findings]
            lines.append("")
        to_do = dict.fromkeys(one.to_do for one in self._findings if one.to_do)
        if to_do:
            lines.append("What to do:")
            for i, text in enumerate(to_do, 1):
                task = f"{i}. {text}"
                lines.append(textwrap.fill(task, WIDTH, subsequent_indent="   "))
        else:
            lines.append(
                "All is well. What is said to be missing is needed only for what is said there."
            )
        return "\n".join(lines)


def examine() -> Diagnosis:
    """Look at this Python, at what is installed, and at this folder; nothing is fetched from anywhere."""
    package = _package()
    extras = [] if package.is_broken else list(WITHOUT)
    return Diagnosis(
        {
            "This computer": [
                _python(),
                package,
                _versions(),
                _kernels(),
                _arms(),
                _folder(),
            ],
            "Needed by everything": list(_core()),
            "Extras": [_extra(name) for name in extras],
        }
    )


def _line(finding: Finding) -> str:
    wrapper = textwrap.TextWrapper(
        WIDTH, " " * INDENT, " " * INDENT, break_long_words=False
    )
    says = "\n".join(map(wrapper.fill, finding.says.split("\n")))
    return f"  {finding.name:<{INDENT - 3}} {says[INDENT:]}"


def _python() -> Finding:
    return Finding(
        "Python",
        f"{platform.python_version()} on {sys.platform} {platform.machine()}, {sys.executable}",
    )


def _package() -> Finding:
    """The package's version and place; the version that pip knows may be older than the one that runs."""
    says = f"{rlrobot_edu.__version__} in {dispatcher.PACKAGE}"
    try:
        version = metadata.version(NAME)
    except metadata.PackageNotFoundError:
        return Finding(
            NAME,
            f"{says}; not installed by pip",
            f"{ANEW} (pip does not know of it)",
            is_broken=True,
        )
    if version != rlrobot_edu.__version__:
        return Finding(
            NAME, f"{says}; pip knows {version}", f"{ANEW} (pip knows {version})"
        )
    return Finding(NAME, says)


def _versions() -> Finding:
    """Whether what is installed is what the toolkit is tested with, as constraints.txt says."""
    tested = _tested()
    others = []
    for requirement in chain(_needed(), *map(_needed, WITHOUT)):
        name = canonicalize_name(requirement.name)
        with suppress(metadata.PackageNotFoundError):
            version = metadata.version(name)
            if name in tested and version != tested[name]:
                others.append(f"{name} {version} (tested: {tested[name]})")
    if not others:
        return Finding("versions", "those with which the toolkit is tested")
    to_do = f"If something fails, install the tested versions: add -c {TESTED} to the line that installs."
    return Finding("versions", ", ".join(dict.fromkeys(others)) + f".\n{to_do}")


def _tested() -> dict[str, str]:
    """The tested version of each package on this computer, by its name."""
    pins = map(Requirement, TESTED.read_text(encoding="utf-8").splitlines())
    return {
        canonicalize_name(pin.name): str(pin.specifier).removeprefix("==")
        for pin in pins
        if pin.marker is None or pin.marker.evaluate()
    }


def _kernels() -> Finding:
    if dispatcher.numba is None or dispatcher.IS_PLAIN:
        why = "as NUMBA_DISABLE_JIT says"
        if dispatcher.numba is None:
            why = "without numba"
        return Finding(
            "kernels", f"plain Python, {why}: the same numbers, some 100 times as slow"
        )
    folder = dispatcher.cache_folder()
    if folder is None:
        to_do = f"Make {dispatcher.PACKAGE / '__pycache__'} or ~/.cache writable, so that compiled kernels can be kept."
        return Finding(
            "kernels",
            "compiled anew by every process: no place to keep them is writable",
            to_do,
        )
    if any(folder.rglob("*.nbc")):
        return Finding("kernels", f"compiled, kept in {folder}")
    return Finding(
        "kernels",
        "not compiled yet, which takes some seconds a method, once: the command compile does it",
    )


def _arms() -> Finding:
    try:
        importlib.import_module("rlrobot_edu.robots.engines.bullet.simulation")
    except ImportError as error:
        return Finding("arms", f"geometry alone (engine='kinematic'): {error}")
    for name, remark in (("pybullet", ""), (FORK, ", a fork of it")):
        with suppress(metadata.PackageNotFoundError):
            version = metadata.version(name)
            return Finding("arms", f"simulated by PyBullet ({name} {version}{remark})")
    return Finding("arms", "simulated by PyBullet")


def _folder() -> Finding:
    try:
        with tempfile.TemporaryFile(dir="."):
            return Finding("folder", f"{Path.cwd()}: files can be written")
    except OSError as error:
        to_do = "Go to a folder of your own: results, recordings and my_course/ are written where you are."
        return Finding(
            "folder", f"nothing can be written here ({error.strerror})", to_do
        )


def _needed(extra: str = "") -> list[Requirement]:
    """The requirements of the package on this computer, or those of one of its extras."""
    try:
        lines = metadata.requires(NAME) or []
    except metadata.PackageNotFoundError:
        return []
    found = []
    for requirement in map(Requirement, lines):
        marker = requirement.marker
        of_extra = marker is not None and "extra ==" in str(marker)
        applies = marker is None or marker.evaluate({"extra": extra})
        if applies and of_extra == bool(extra):
            found.append(requirement)
    return found


def _core() -> Iterator[Finding]:
    """What the toolkit itself needs: each is imported, because one that is damaged is no better than none."""
    for requirement in _needed():
        fault = _fault(requirement)
        module = MODULES.get(requirement.name, requirement.name.replace("-", "_"))
        try:
            if not fault:
                importlib.import_module(module)
        except Exception as error:  # a damaged package may raise anything
            fault = f"cannot be imported: {type(error).__name__}: {error}"
        if fault:
            asked = str(requirement).partition(";")[0]
            to_do = f'Install what is needed: {PIP} install --force-reinstall "{asked}"'
            yield Finding(requirement.name, fault, to_do, is_broken=True)
        else:
            yield Finding(requirement.name, metadata.version(requirement.name))


def _extra(name: str) -> Finding:
    """What an extra needs, and with which versions it is there."""
    requirements = _needed(name)
    versions = []
    faults = []
    for requirement in requirements:
        fault = _fault(requirement)
        if fault:
            faults.append(f"{requirement.name} {fault}")
        else:
            version = metadata.version(requirement.name)
            versions.append(f"{requirement.name} {version}")
    if requirements and not faults:
        return Finding(name, ", ".join(versions))
    missing = (
        "; ".join(faults)
        or "nothing of it is for this computer, or pip knows an older toolkit"
    )
    return Finding(
        name,
        f"{missing}.\nWithout it {WITHOUT[name]}.\nTo install it: {to_install(name, PIP)}",
    )


def _fault(requirement: Requirement) -> str:
    """What is wrong with an installed distribution; empty if nothing is."""
    try:
        version = metadata.version(requirement.name)
    except metadata.PackageNotFoundError:
        return "is missing"
    fits = requirement.specifier.contains(version, prereleases=True)
    return "" if fits else f"is {version}, not {requirement.specifier}"
